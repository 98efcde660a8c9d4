# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes reports of clearance and mechanism checks as one HTML file. The texts come from the stored
report. The 3D view shows the parts as they were checked, so the result must be up to date.

request() reads the document (GUI thread). text() and write() may run in any thread.
"""
import hashlib
import os
import time

import numpy as np

from . import core, settings, targets
from .convert import InputProblem, label_of
from .core_texts import said
from .features import check, clearance, mechanism
from .features.clearance_plan import envelope_arrays
from .safe_file import written_beside
from .texts import language, translate

SUFFIXES = (".html", ".htm", ".pdf")


def is_pdf(path):
    return path.lower().endswith(".pdf")


def check_target(path):
    """Calls targets.check_target() with the file types of reports."""
    targets.check_target(path, SUFFIXES)


def date():
    """Returns the time of the report. The environment variable SOURCE_DATE_EPOCH (seconds since
    1970) replaces it. Raises InputProblem."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    try:
        now = time.gmtime(int(given)) if given else time.gmtime()
    except (ValueError, OverflowError):
        text = translate(
            "SweptVolume",
            'The environment variable SOURCE_DATE_EPOCH is "{0}", but must be a whole number of '
            "seconds since 1970-01-01: correct or unset it.",
        )
        raise InputProblem(text.format(given)) from None
    return time.strftime("%Y-%m-%d %H:%M UTC", now)


def template(pdf=False):
    """Returns the text of the template in the preferences. Without one, returns the built-in
    template for PDF, or "" for HTML. Raises InputProblem."""
    path = settings.page_template(pdf)
    if not path:
        return core.page_template("print") if pdf else ""
    try:
        with open(path, encoding="utf-8") as file:
            found = file.read()
    except (OSError, UnicodeDecodeError) as error:
        text = translate(
            "SweptVolume",
            'The report template "{0}" cannot be read ({1}): choose another template '
            "in the preferences.",
        )
        raise InputProblem(text.format(path, error)) from None
    if not found.strip():
        text = translate(
            "SweptVolume",
            'The report template "{0}" is empty: choose another template in the ' "preferences.",
        )
        raise InputProblem(text.format(path))
    return found


class _Request:
    """A page as plain values, independent of any document. Subclasses read the check. They define
    parts() (for the 3D view, as in core.report_page()) and inputs() (the first rows of the table
    of inputs)."""

    def __init__(self, obj, is_changed, pdf):
        self.report = obj.Proxy.report_of(obj)
        self.title, self.language = obj.Label, language()
        self.date, self.layout = date(), template(pdf)
        self.file = _file_of(obj.Document, is_changed)
        self.read(obj)

    def read(self, obj):
        """Reads the document. GUI thread."""
        raise NotImplementedError


class _OfClearance(_Request):
    def read(self, obj):
        plan = clearance.Plan.of(obj)
        self.moving = ", ".join(label_of(*pair) for pair in plan.pairs)
        self.motion = plan.moving().motion.Label
        self.check = plan.request()
        self.envelope = None
        if plan.envelope is not None and plan.envelope.Mesh.CountFacets:
            self.envelope = (plan.envelope.Label, *envelope_arrays(plan.envelope))

    def parts(self):
        body = self.check.body
        shape = body.body.vertices, body.body.triangles
        parts = [(self.moving, *shape, _motion(body), body.interpolation, True, False)]
        for name, vertices, triangles, _, _ in self.check.rows():
            parts.append((name, vertices, triangles, None, "linear", False, False))
        if self.envelope is not None:
            parts.append((*self.envelope, None, "linear", False, True))
        return parts

    def inputs(self):
        body = self.check.body
        found = [_triangles("body", self.moving, body.body.vertices, body.body.triangles)]
        found.append(_poses(self.motion, body))
        return found + [_triangles("neighbour", *row[:3]) for row in self.check.rows()]


class _OfMechanism(_Request):
    def read(self, obj):
        plan = mechanism.Plan.of(obj)
        self.check = plan.request()
        self.motions = {pair: path.Label for pair, path in zip(plan.pairs, plan.motions)}

    def parts(self):
        return [(*row[:5], part.moves(), False) for row, part in self._rows()]

    def inputs(self):
        found = []
        for row, part in self._rows():
            found.append(_triangles("body" if part.moves() else "neighbour", *row[:3]))
            poses = _poses(self.motions[part.pair], part.run) if part.moves() else None
            if poses is not None and poses not in found:
                found.append(poses)
        return found

    def _rows(self):
        rows = self.check.rows()  # rows() leaves out parts that give no triangles
        return zip(rows, self.check.parts)


def _file_of(document, is_changed):
    """Returns (name, note, path) of the document's file, or None if there is no file. The note says
    that the document was changed since it was saved, or is ""."""
    if not document.FileName or not os.path.isfile(document.FileName):
        return None
    how = translate("SweptVolume", "changed since it was saved") if is_changed else ""
    return os.path.basename(document.FileName), how, document.FileName


def request(obj, is_changed=False, pdf=False):
    """Returns the input of text() for a check. is_changed: the document was changed since it was
    saved. Raises InputProblem if there is no result, or if the result does not match the present
    parts."""
    check.update_status(obj)
    if obj.Proxy.report_of(obj) is None or obj.Status != clearance.UP_TO_DATE:
        text = translate(
            "SweptVolume",
            'The check "{0}" is not up to date. If it uses an envelope, recompute the envelope '
            "first; then run the check again.",
        )
        raise InputProblem("\n".join(filter(None, (text.format(obj.Label), obj.Message))))
    kind = _OfMechanism if mechanism.is_mechanism(obj) else _OfClearance
    return kind(obj, is_changed, pdf)


def _hash(*arrays):
    found = hashlib.sha256()
    for array in arrays:
        found.update(np.ascontiguousarray(array).tobytes())
    return found.hexdigest()


def _triangles(role, name, vertices, triangles):
    shape = np.asarray(vertices, "<f8"), np.asarray(triangles, "<i4")
    detail = translate("SweptVolume", "{0} triangles").format(len(triangles))
    return role, name, detail, _hash(*shape)


def _motion(run):
    return run.times, run.rotations, run.translations


def _poses(label, run):
    detail = translate("SweptVolume", "{0} poses").format(len(run.times))
    arrays = (run.times, run.translations, run.rotations)
    return "motion", label, detail, _hash(*(np.asarray(a, "<f8") for a in arrays))


def _inputs(req):
    """Returns the rows of the page's table of inputs. For a shape, shows the hash of the triangles
    that were checked."""
    found = req.inputs()
    if req.file is not None:
        name, how, path = req.file
        content = hashlib.sha256()
        with open(path, "rb") as file:
            for block in iter(lambda: file.read(1 << 20), b""):
                content.update(block)
        found.append((translate("SweptVolume", "document"), name, how, content.hexdigest()))
    return found


def _translated(report):
    """Returns the report with its findings and notes in the user's language."""
    findings = [dict(w, text=said(w["code"], w["text"])) for w in report.get("warnings", [])]
    findings += [{"code": "", "text": note} for note in report.get("notes", [])]
    return dict(report, warnings=findings, findings_language=language())


def text(req, control, pictures=(), view=True):
    """Returns the text of the page, in any thread. pictures: (caption, media type, bytes). Raises
    core.CoreError, InputProblem."""
    return core.report_page(
        _translated(req.report),
        control,
        title=req.title,
        language=req.language,
        date=req.date,
        template=req.layout,
        inputs=_inputs(req),
        parts=req.parts() if view else [],
        pictures=list(pictures),
    )


def write(obj, path, control=None):
    """Writes the HTML page of a check, for scripts. Raises InputProblem, core.CoreError."""
    check_target(path)
    if is_pdf(path):
        raise InputProblem(
            translate(
                "SweptVolume",
                "A PDF file can be written only while the FreeCAD window is open. In scripts, "
                "write the report as HTML.",
            )
        )
    page = text(request(obj), control or core.Control())
    with written_beside(path) as beside, open(beside, "w", encoding="utf-8", newline="") as out:
        out.write(page)
