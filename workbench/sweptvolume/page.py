# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of clearance checks for people: one HTML file. What it tells is the stored report; what it shows is
the parts as they were checked, so the result must be up to date.

request() reads the document (thread of the GUI), text() and write() may run in any thread.
"""
import hashlib
import os
import time

import numpy as np

from . import core, settings, targets
from .convert import InputProblem, label_of
from .core_texts import said
from .features import check, clearance
from .features.clearance_plan import envelope_arrays
from .safe_file import written_beside
from .texts import language, translate

SUFFIXES = (".html", ".htm", ".pdf")


def is_pdf(path):
    return path.lower().endswith(".pdf")


def check_target(path):
    """As targets.check_target(), for the types of reports."""
    targets.check_target(path, SUFFIXES)


def date():
    """The time of the report; that of SOURCE_DATE_EPOCH (seconds since 1970) where the environment has it.
    Raises InputProblem."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    try:
        now = time.gmtime(int(given)) if given else time.gmtime()
    except (ValueError, OverflowError):
        text = translate("Messages", 'SOURCE_DATE_EPOCH is "{0}"; it must be seconds since 1970.')
        raise InputProblem(text.format(given)) from None
    return time.strftime("%Y-%m-%d %H:%M UTC", now)


def template():
    """Text of the template of the preferences; "" where none is chosen. Raises InputProblem."""
    path = settings.page_template()
    if not path:
        return ""
    try:
        with open(path, encoding="utf-8") as file:
            found = file.read()
    except (OSError, UnicodeDecodeError) as error:
        text = translate("Messages", 'the template "{0}" of the preferences cannot be read: {1}')
        raise InputProblem(text.format(path, error)) from None
    if not found.strip():
        text = translate("Messages", 'the template "{0}" of the preferences is empty.')
        raise InputProblem(text.format(path))
    return found


class Request:
    """A page as plain values, no document behind it. check: clearance_plan.Request."""

    def __init__(self, obj, is_changed):
        self.report = clearance.report_of(obj)
        self.title = obj.Label
        self.date = date()
        self.layout = template()
        self.language = language()
        plan = clearance.Plan.of(obj)
        self.moving = ", ".join(label_of(*pair) for pair in plan.pairs)
        moving = plan.moving()
        self.motion = moving.motion.Label
        self.check = plan.request()
        self.envelope = None
        if plan.envelope is not None and plan.envelope.Mesh.CountFacets:
            self.envelope = (plan.envelope.Label, *envelope_arrays(plan.envelope))
        self.file = _file_of(obj.Document, is_changed)


def _file_of(document, is_changed):
    """(name, how it stands to the document, path) of the document's file; None where there is none."""
    if not document.FileName or not os.path.isfile(document.FileName):
        return None
    how = translate("Messages", "changed since it was saved") if is_changed else ""
    return os.path.basename(document.FileName), how, document.FileName


def request(obj, is_changed=False):
    """What text() needs of a clearance check. is_changed: the document was, since it was saved. Raises
    InputProblem where there is no result, or where it is not that of the parts as they are now."""
    check.update_status(obj)
    if clearance.report_of(obj) is None or obj.Status != clearance.UP_TO_DATE:
        text = translate(
            "Messages",
            '"{0}" has no result that is up to date: recompute its envelope, if it has one, and check again '
            "first.",
        )
        raise InputProblem("\n".join(filter(None, (text.format(obj.Label), obj.Message))))
    return Request(obj, is_changed)


def _hash(*arrays):
    found = hashlib.sha256()
    for array in arrays:
        found.update(np.ascontiguousarray(array).tobytes())
    return found.hexdigest()


def _triangles(role, name, vertices, triangles):
    shape = np.asarray(vertices, "<f8"), np.asarray(triangles, "<i4")
    detail = translate("Messages", "{0} triangles").format(len(triangles))
    return role, name, detail, _hash(*shape)


def _inputs(req, rows):
    """Rows of the page's table of inputs. A shape stands for the triangles that were checked."""
    body = req.check.body
    poses = translate("Messages", "{0} poses").format(len(body.times))
    arrays = (body.times, body.translations, body.rotations)
    found = [
        _triangles("body", req.moving, body.body.vertices, body.body.triangles),
        ("motion", req.motion, poses, _hash(*(np.asarray(a, "<f8") for a in arrays))),
    ]
    found += [_triangles("neighbour", row[0], row[1], row[2]) for row in rows]
    if req.file is not None:
        name, how, path = req.file
        content = hashlib.sha256()
        with open(path, "rb") as file:
            for block in iter(lambda: file.read(1 << 20), b""):
                content.update(block)
        found.append((translate("Messages", "document"), name, how, content.hexdigest()))
    return found


def _told(report):
    """The report with its findings and notes in the user's language."""
    findings = [dict(w, text=said(w["code"], w["text"])) for w in report.get("warnings", [])]
    findings += [{"code": "", "text": note} for note in report.get("notes", [])]
    return dict(report, warnings=findings, findings_language=language())


def text(req, control, layout=None, pictures=(), view=True):
    """Any thread: the page. layout: another template; pictures: (caption, media type, bytes). Raises
    core.CoreError, InputProblem."""
    rows = req.check.rows()
    parts = []
    if view:
        body = req.check.body
        motion = (body.times, body.rotations, body.translations)
        shape = body.body.vertices, body.body.triangles
        parts.append((req.moving, *shape, motion, body.interpolation, True, False))
        parts += [(row[0], row[1], row[2], None, "linear", False, False) for row in rows]
        if req.envelope is not None:
            parts.append((*req.envelope, None, "linear", False, True))
    return core.report_page(
        _told(req.report),
        control,
        title=req.title,
        language=req.language,
        date=req.date,
        template=req.layout if layout is None else layout,
        inputs=_inputs(req, rows),
        parts=parts,
        pictures=list(pictures),
    )


def write(obj, path, control=None):
    """Writes the HTML page of a clearance check, for scripts. Raises InputProblem, core.CoreError."""
    check_target(path)
    if is_pdf(path):
        raise InputProblem(translate("Messages", "a PDF is written by the window alone."))
    page = text(request(obj), control or core.Control())
    with written_beside(path) as beside, open(beside, "w", encoding="utf-8", newline="") as out:
        out.write(page)
