# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes one page about all runs of a study."""
from __future__ import annotations

import os
import pathlib
import time
import urllib.parse
from typing import Any, Dict, List, Mapping, Optional, Sequence

from ._calls import RunContext
from ._pages import PageInput, report_page
from ._study_file import Study
from ._study_run import PAGE_FILE, Report, output_names
from ._values import bad_option


def page_date() -> str:
    """Returns the time that a page shows: the value of the environment variable SOURCE_DATE_EPOCH
    (seconds since 1970) if it is set, otherwise the current time. Raises InvalidInput (BadOption).
    """
    given = os.environ.get("SOURCE_DATE_EPOCH")
    try:
        now = time.gmtime(int(given)) if given else time.gmtime()
    except (ValueError, OverflowError):
        text = (
            f"the environment variable SOURCE_DATE_EPOCH is '{given}', but must be a whole number of "
            "seconds since 1970-01-01; correct or unset it"
        )
        raise bad_option(text) from None
    return time.strftime("%Y-%m-%d %H:%M UTC", now)


def _inputs(study: Study, hashes: Mapping[str, str]) -> List[PageInput]:
    """Returns the files of the study as rows of the page, each once with its first role."""
    rows: Dict[str, PageInput] = {}

    def add(role: str, file: str) -> None:
        rows.setdefault(file, (role, pathlib.PurePath(file).name, "", hashes[file]))

    add("study", str(study.file))
    for run in study.runs:
        add("body", run.part)
        add("motion", run.motion)
        for file in run.neighbours:
            add("neighbour", file)
    return list(rows.values())


def study_text(
    study: Study,
    summary: Report,
    reports: Sequence[Optional[Report]],
    hashes: Mapping[str, str],
    order: Sequence[int],
    folder: str = "",
    run: Optional[RunContext] = None,
) -> str:
    """Returns the page as text. summary: the report of the study; reports: those of its runs;
    order: indices of the runs, the worst first; folder: path from the page to the folder of
    results, which ends in a slash."""
    rows = []
    for number in order:
        one, report = study.runs[number], reports[number]
        row: Dict[str, Any] = dict(summary["runs"][number])
        if report is not None and report["status"] == "Ok" and "clearance" in report:
            row["clearance"] = report["clearance"]
            if PAGE_FILE in output_names(one):
                row["page"] = urllib.parse.quote(f"{folder}{one.name}/{PAGE_FILE}")
        rows.append(row)
    return report_page(
        {**summary, "runs": rows},
        inputs=_inputs(study, hashes),
        title=study.name,
        language=study.language,
        template=study.template,
        date=page_date(),
        run=run,
    )
