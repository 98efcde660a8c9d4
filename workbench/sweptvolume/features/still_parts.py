# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that stand still around moving ones: chosen parts, or all visible parts. Each solid or mesh
counts as a separate part and has its own rule."""
from .. import convert
from ..convert import InputProblem
from ..texts import translate
from . import containers, missing, neighbour_rules, row_names
from . import envelope as envelope_feature
from .base import kind_of


#: Factor on the mesh deflection for solids that are only drawn, not measured.
DRAWN = 4
#: Kinds of result objects that count as parts.
_RESULTS = (envelope_feature.Envelope.KIND, "SweptVolume::Solid")


def _linked(root, path):
    return root.getSubObject(path, retType=1).getLinkedObject(True)


def _parts(root, sub):
    """Returns (root, path) of all solids and meshes below a path. If the path leads to a single
    object with a shape or mesh, returns this object, whatever its kind."""
    if root.getSubObject(sub, retType=1) is None:
        convert.leaves(root, sub)  # raises InputProblem
    found = convert.leaves(root, sub)
    if len(found) == 1 and found[0][1] == sub:
        return [(root, sub)]
    return [(root, path) for linked, path in found if convert.solid_like(linked)]


class Neighbour:
    """A part that stands still: name, convert.Body, deviation of its triangles from its surface
    (mm), place in the document ((root, sub), and as a place of row_names), and rule."""

    def __init__(self, name, body, chord, pair, rule):
        self.name = name
        self.body = body
        self.chord = chord
        self.pair, self.place = pair, row_names.place_of(*pair)
        self.rule = rule  # neighbour_rules.Rule


#: Largest number of names in one sentence.
_MOST_NAMES = 12


def listed(names):
    """Returns names for a sentence, each in quotation marks."""
    words = ['"{}"'.format(name) for name in names[:_MOST_NAMES]]
    return ", ".join(words + (["..."] if len(names) > _MOST_NAMES else []))


def left_out_text(problem):
    return translate("SweptVolume", "Left out: {0}").format(problem)


def no_neighbour():
    return InputProblem(
        translate(
            "SweptVolume",
            "There is no neighbour: choose parts as neighbours, or make other parts visible.",
        )
    )


def has_surface(root, path):
    """Returns whether an object has a surface. Points, wires and axes have none."""
    linked = _linked(root, path)
    return linked.isDerivedFrom("Mesh::Feature") or bool(linked.Shape.Faces)


def chord_of(pairs, deflection):
    """Returns how far (mm) the triangles of parts may deviate from them; 0 for meshes."""
    shapes = any(
        not linked.isDerivedFrom("Mesh::Feature")
        for root, sub in pairs
        for linked, _ in convert.leaves(root, sub)
    )
    return deflection if shapes else 0.0


class StillParts:
    """Base class of plans. A plan has `document`, `pairs` (the moving parts), `neighbours`,
    `all_visible`, `rules` ({(root, sub): Rule}), `values` (settings) and is_own()."""

    def rules_of(self, obj, rules):
        """Returns the rules of an object. rules: the module that reads them. Stores in `lost` the
        text about deleted or damaged inputs."""
        self.lost = missing.text(obj)
        try:
            return rules.read(obj)
        except InputProblem as problem:
            self.lost = self.lost or str(problem)
            return {}

    def is_own(self, obj):
        """Returns whether an envelope is the sweep of the moving parts themselves."""
        raise NotImplementedError

    def leaves(self):
        """Returns (root, path) of every neighbour, each solid or mesh by itself, without the moving
        parts. Raises InputProblem if a chosen neighbour cannot be checked."""
        found = self._all_visible() if self.all_visible else self._chosen()
        if not found:
            raise no_neighbour()
        return found

    def _chosen(self):
        found = []
        for root, sub in self.neighbours:
            below = [pair for pair in _parts(root, sub) if not self._moves(*pair)]
            if not below:
                raise self._not_checked(root, sub)
            found += [pair for pair in below if pair not in found]
        return found

    def _all_visible(self):
        found = []
        for root in containers.standing(self.document):
            if convert.is_shown(root):
                found += [
                    (r, path)
                    for r, path in _parts(root, "")
                    if not kind_of(_linked(r, path)) and not self._moves(r, path)
                ]
        return found

    def pairs_named(self, names):
        """Returns (root, path) for each name in the rows of a report, or None if the part is not
        there any more. If parts have the same name, the first row gets the first part."""
        by_name = {}
        for pair in self.leaves():
            if neighbour_rules.of(self.rules, *pair).kind != neighbour_rules.IGNORE:
                by_name.setdefault(convert.label_of(*pair), []).append(pair)
        return [by_name[name].pop(0) if by_name.get(name) else None for name in names]

    def seen_deflection(self):
        """Returns the deflection (mm) of solids for pictures."""
        return DRAWN * max(float(self.values["MeshDeflection"]), 0.05)

    def left_out(self):
        """Returns notes on visible envelopes and solids that AllVisible leaves out. The user may
        choose them as neighbours."""
        if not self.all_visible:
            return []
        labels = [
            o.Label
            for o in self.document.Objects
            if kind_of(o) in _RESULTS and o.Visibility and not self._is_sweep(o)
        ]
        if not labels:
            return []
        return [
            translate(
                "SweptVolume",
                "Left out: {0}. Envelopes and their solids are checked only if you "
                "choose them as neighbours.",
            ).format(", ".join('"{}"'.format(label) for label in labels))
        ]

    def _is_sweep(self, obj):
        while kind_of(obj) == _RESULTS[1] and obj.Source is not None:
            obj = obj.Source
        return self.is_own(obj)

    def _not_checked(self, root, sub):
        label = convert.label_of(root, sub)
        if any(self._moves(*pair) for pair in _parts(root, sub)):
            return InputProblem(
                translate(
                    "SweptVolume",
                    '"{0}" is both a neighbour and a moving part: remove it from one of the lists.',
                ).format(label)
            )
        return convert.holds_nothing(root, sub)

    def _moves(self, root, path):
        return any(root is r and path.startswith(s) for r, s in self.pairs)

    def still_parts(self, deflection):
        """Returns (neighbours as plain values, notes on parts left out, [name, place] of ignored
        neighbours). Raises InputProblem."""
        neighbours, notes, ignored = [], self.left_out(), []
        for pair in self.leaves():
            name = convert.label_of(*pair)
            rule = neighbour_rules.of(self.rules, *pair)
            neighbour_rules.check(rule, name)
            if rule.kind == neighbour_rules.IGNORE:
                ignored.append([name, row_names.place_of(*pair)])
                continue
            try:
                part = convert.body_from([pair], deflection)
            except InputProblem as problem:
                if not self.all_visible:
                    raise
                notes.append(left_out_text(problem))
                continue
            neighbours.append(Neighbour(name, part, chord_of([pair], deflection), pair, rule))
        return neighbours, notes, ignored
