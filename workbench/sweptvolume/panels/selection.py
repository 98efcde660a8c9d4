# SPDX-License-Identifier: LGPL-2.1-or-later
"""Returns the selected objects that the commands can use. Keeps sub paths through groups and
links."""
import FreeCAD as App
import FreeCADGui as Gui

from ..convert import InputProblem, leaves, pairs_of, root_path, split_path, targets
from ..features.base import kind_of, objects_of_kind
from ..features.clearance import is_clearance
from ..features.envelope import Envelope, is_envelope
from ..features.mechanism import is_mechanism
from ..features.motion import Motion, is_motion, parts_of
from ..features.sequence import is_sequence
from ..features.shared import is_shared
from ..features.solid import can_be_source, is_solid
from ..features.study import is_study
from ..features.study_plan import can_run
from ..texts import translate


def paths():
    """Returns the selected (root, sub path) without element names, each once, in order of
    selection."""
    found = []
    for item in Gui.Selection.getSelectionEx("", 0):
        for sub in item.SubElementNames or [""]:
            pair = (item.Object, split_path(item.Object, sub))
            if not pair[1]:
                pair = root_path(item.Object)
            if pair not in found:
                found.append(pair)
    return found


def _target(pair):
    return pair[0].getSubObject(pair[1], retType=1)


def _ours(obj):
    tests = (
        is_envelope,
        is_motion,
        is_solid,
        is_clearance,
        is_mechanism,
        is_sequence,
        is_shared,
        is_study,
    )
    return any(test(obj) for test in tests)


def parts():
    """Returns the selected solids and meshes that can move."""
    return _with_geometry(lambda target: not _ours(target))


def spaces():
    """Returns the selected solids and meshes, including results of this workbench."""
    return _with_geometry(lambda target: True)


def _with_geometry(test):
    found = []
    for pair in paths():
        target = _target(pair)
        if target is None or not test(target):
            continue
        try:
            if leaves(*pair):
                found.append(pair)
        except ValueError:
            continue
    return found


def moved_part(obj):
    """Returns the part that a motion moves (None: a new motion): the selected part, the motion's
    own part, or the first part of an envelope that uses the motion."""
    chosen = parts() or [pair for pair in (parts_of(obj) if obj else []) if targets([pair])]
    if chosen:
        return chosen[0]
    for user in obj.InList if obj else []:
        if is_envelope(user) and user.MovingParts:
            return pairs_of(user.MovingParts)[0]
    document = obj.Document if obj else App.ActiveDocument
    return next(iter(_only_part(document)), None)


def ours():
    """Returns whether an object of this workbench is selected."""
    return _first(_ours) is not None


def motion():
    """Returns the selected motion, or None."""
    return _first(is_motion)


def envelope():
    return _first(is_envelope)


def solid():
    return _first(is_solid)


def shared():
    """Returns the selected shared volume, or None."""
    return _first(is_shared)


def clearance():
    """Returns the selected clearance check, or None."""
    return _first(is_clearance)


def mechanism():
    """Returns the selected mechanism check, or None."""
    return _first(is_mechanism)


def sequence():
    """Returns the selected sequence, or None."""
    return _first(is_sequence)


def has_report(obj):
    """Returns whether an object is a check or a study, for which there are reports."""
    return is_clearance(obj) or is_mechanism(obj) or is_study(obj)


def reported():
    """Returns the selected check or study, or None."""
    return _first(has_report)


def study():
    """Returns the selected study, or None."""
    return _first(is_study)


def runs():
    """Returns the selected envelopes and clearance checks, which can be runs of a study."""
    return list(_targets(can_run))


def motions():
    """Returns all selected motions."""
    return list(_targets(is_motion))


def source():
    """Returns the selected envelope or other mesh from which a solid can be made."""
    return _first(can_be_source)


def placed():
    """Returns the selected objects that have a placement and do not belong to this workbench."""
    return list(_targets(lambda target: hasattr(target, "Placement") and not _ours(target)))


def of_kind(document, kind):
    """Returns (object, count). object is the selected object of a kind (KIND of its proxy), or the
    only one of the document, or None. count is the number of such objects in the document."""
    found = _first(lambda obj: kind_of(obj) == kind)
    known = objects_of_kind(document, kind)
    if found is None and len(known) == 1:
        found = known[0]
    return found, len(known)


def _missing_text(document, kind, none, several):
    """Returns the text about what is missing for a command that acts on one object of a kind.
    `none`: the text if the document has none; `several`: the text (with their number) if one
    must be selected. Returns "" if nothing is missing."""
    found, count = of_kind(document, kind)
    if found is not None:
        return ""
    return several.format(count) if count else none


def the_envelope(document):
    """Returns the envelope for a command that acts on one. Raises InputProblem."""
    found = of_kind(document, Envelope.KIND)[0]
    if found is None:
        raise InputProblem(translate("SweptVolume", "Select an envelope first."))
    return found


def the_motion(document):
    """Returns the motion for a command that acts on one. Raises InputProblem."""
    found = of_kind(document, Motion.KIND)[0]
    if found is None:
        raise InputProblem(translate("SweptVolume", "Select a motion first."))
    return found


def missing_envelope_text(document):
    """Returns why a command that acts on one envelope cannot run, or ""."""
    return _missing_text(
        document,
        Envelope.KIND,
        translate(
            "SweptVolume", "There is no envelope in the document: make one with Create envelope."
        ),
        translate("SweptVolume", "The document has {0} envelopes: select one of them."),
    )


def missing_motion_text(document):
    """Returns why a command that acts on one motion cannot run, or ""."""
    return _missing_text(
        document,
        Motion.KIND,
        translate("SweptVolume", "There is no motion in the document: make one with New motion."),
        translate("SweptVolume", "The document has {0} motions: select one of them."),
    )


def moving_parts(document):
    """Returns the selected parts. Without a selection, returns the only visible part of the
    document."""
    chosen = parts()
    return chosen if chosen or plain() else _only_part(document)


def _only_part(document):
    """Returns the only visible solid or mesh of a document in a list, or an empty list if there are
    several."""
    found = []
    for obj in document.Objects:
        if not getattr(obj, "Visibility", False) or kind_of(obj) or obj.InList:
            continue
        if obj.isDerivedFrom("Mesh::Feature") or getattr(obj, "Shape", None) and obj.Shape.Solids:
            found.append(root_path(obj))
        if len(found) > 1:
            return []
    return found


def _first(test):
    return next(_targets(test), None)


def _targets(test):
    """Yields the selected objects that pass a test."""
    for pair in paths():
        target = _target(pair)
        if target is not None and test(target):
            yield target


def plain():
    """Returns the selected objects that do not belong to this workbench, with or without a
    placement."""
    return list(_targets(lambda target: not _ours(target)))
