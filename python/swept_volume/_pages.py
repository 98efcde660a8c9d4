# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows a report to people, as one HTML file."""
from __future__ import annotations

import json
from typing import Any, Iterable, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from ._calls import RunContext
from ._values import MeshLike, MotionLike, mesh_of, motion_arguments

#: A part that stands still: (name, mesh). A part that moves: (name, mesh, motion); with the motion None,
#: the page shows the part only at the poses in the report.
PagePart = Union[Tuple[str, MeshLike], Tuple[str, MeshLike, Optional[MotionLike]]]
#: (role, name, detail, SHA-256 in hexadecimal or ""). The page translates the roles "body", "motion",
#: "neighbour" and "rules".
PageInput = Tuple[str, str, str, str]
#: (caption, "image/png" or another type, bytes of the file)
PagePicture = Tuple[str, str, bytes]


def _part(item: PagePart) -> Tuple[Any, ...]:
    parts: Sequence[Any] = item if isinstance(item, (tuple, list)) else ()
    if len(parts) not in (2, 3):
        raise TypeError("a part is (name, mesh) or (name, mesh, motion)")
    mesh = mesh_of(parts[1])
    moves = len(parts) == 3
    motion = motion_arguments(parts[2] if moves else None)
    return (parts[0], mesh.vertices, mesh.triangles, *motion, moves, False)


def report_page(
    report: Mapping[str, Any],
    *,
    parts: Iterable[PagePart] = (),
    envelope: Optional[MeshLike] = None,
    inputs: Iterable[PageInput] = (),
    pictures: Iterable[PagePicture] = (),
    title: str = "",
    language: str = "en",
    date: str = "",
    template: str = "",
    view_triangles: int = 50000,
    run: Optional[RunContext] = None,
) -> str:
    """Returns the text of an HTML file that shows a report of clearance() or mechanism(). The file needs
    no other file and no network. parts and envelope (translucent) are shown in a 3D view, with about
    view_triangles triangles. language: en or de; date: free text; template: text with {{placeholders}}
    in place of page_template(). Raises InvalidInput (BadReport, BadTemplate, BadOption), Cancelled.
    """
    shown = [_part(item) for item in parts]
    if envelope is not None:
        mesh = mesh_of(envelope)
        shown.append(
            ("envelope", mesh.vertices, mesh.triangles, None, "linear", False, True),
        )
    return _core.report_page(
        json.dumps(report),
        title,
        language,
        _core.__version__,
        date,
        template,
        list(inputs),
        shown,
        list(pictures),
        view_triangles,
        run,
    )


def page_template(name: str = "page") -> str:
    """Returns a built-in template, which can be changed and given to report_page(): "page", or "print"
    (simple HTML without a 3D view, for Qt's text documents). Raises InvalidInput (BadOption)."""
    return _core.page_template(name)
