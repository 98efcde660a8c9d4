# SPDX-License-Identifier: LGPL-2.1-or-later
"""`python -m swept_volume study FILE`: the program `swept` calls this for `swept study`."""
from __future__ import annotations

import argparse
import json
import signal
import sys
from typing import Any, List, NoReturn, Sequence

from . import Error, ExportFailed, RunContext, __version__
from ._report_file import check_report, silence_output, write_report
from ._study import Row, run_study
from ._study_checks import RESERVED
from ._study_file import read_study
from ._study_run import Report, json_text
from ._values import bad_option, core_error

USAGE, FAILED = 2, 1
EXAMPLES = """Exit status 0 if all runs are done and all their rules are met, 3 if a rule is not met,
1 if a run failed.

Examples:
  swept study doors.toml --jobs 4 --page
  swept study doors.toml --scheduler tcp://cluster:8786 --send-files"""


class _Parser(argparse.ArgumentParser):
    """Reports wrong arguments in one line, as the program `swept` does."""

    def error(self, message: str) -> NoReturn:
        raise bad_option(f"{message}; see {self.prog} --help")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser("swept")
    parser.add_argument("-V", "--version", action="version", version=f"swept {__version__}")
    commands = parser.add_subparsers(dest="command", required=True)
    study = commands.add_parser(
        "study",
        help="computes the runs of a study file",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    study.add_argument("file", metavar="FILE", help="study file (TOML)")
    study.add_argument("-o", "--output", metavar="FOLDER", help="folder for the results")
    study.add_argument("--jobs", type=int, metavar="N", help="number of runs at the same time")
    study.add_argument("--scheduler", metavar="ADDRESS", help="address of a Dask scheduler")
    study.add_argument("--send-files", action="store_true", help="send files through the scheduler")
    study.add_argument("--again", action="store_true", help="compute all runs again")
    study.add_argument("--page", action="store_true", help="also write study.html, an HTML page")
    study.add_argument("--rows", action="store_true", help="write a line of JSON for each run")
    study.add_argument(
        "--no-clobber", action="store_true", help="refuse to replace existing results"
    )
    study.add_argument("--strict", action="store_true", help="count less accurate runs as failed")
    study.add_argument("--report", metavar="FILE", help="write a report of the study as JSON")
    study.add_argument(
        "-q", "--quiet", action="store_true", help="print no progress and no summary"
    )
    return parser


def _line(row: Row) -> str:
    text = f"{row['state']:<9} {row['run']}"
    if "distance" in row:
        text += f": {row['verdict']}, {row['distance']:.6g} mm to {row['neighbour']}"
    return text + (f": {row['message']}" if "message" in row else "")


def _print_progress(done: int, all_runs: int, row: Row) -> None:
    print(f"{done}/{all_runs} {_line(row)}", file=sys.stderr)


def _print_row(done: int, all_runs: int, row: Row) -> None:
    print(json.dumps({"done": done, "runs": all_runs, "row": row}), flush=True)


def _print_kept_rows(rows: Sequence[Row]) -> None:
    for row in rows:
        print(json.dumps({"row": row}), flush=True)


def _check_outputs(options: argparse.Namespace) -> None:
    """Raises an error before anything is computed if existing results or an input would be
    overwritten."""
    if not (options.report or options.no_clobber):
        return
    study = read_study(options.file, options.output)
    for name in RESERVED:
        if options.no_clobber and (study.output / name).exists():
            text = (
                f"'{study.output / name}' exists already, and --no-clobber forbids replacing it; "
                "name another folder"
            )
            raise core_error(ExportFailed, "Exists", text)
    if options.report:
        inputs = [options.file, *(file for run in study.runs for file in run.files())]
        results = [*RESERVED, *(run.name for run in study.runs)]
        check_report(options.report, inputs, str(study.output), results, options.no_clobber)


def _exit_status(report: Report) -> int:
    if report["status"] == "Cancelled":
        return 130
    return 1 if report["failed"] else 3 if report["not_clear"] else 0


def _study(options: argparse.Namespace) -> int:
    if options.rows and options.report == "-":
        raise bad_option("--rows and --report - both take standard output; name a file")
    _check_outputs(options)
    context = RunContext()
    received: List[int] = []

    def cancel(number: int, _: Any) -> None:
        received.append(number)
        context.cancel()

    numbers = [signal.SIGINT, signal.SIGTERM]
    # Under nohup, SIGHUP stays ignored.
    if sys.platform != "win32" and signal.getsignal(signal.SIGHUP) != signal.SIG_IGN:
        numbers.append(signal.SIGHUP)
    for number in numbers:
        signal.signal(number, cancel)
    report = run_study(
        options.file,
        output=options.output,
        jobs=options.jobs,
        scheduler=options.scheduler,
        send_files=options.send_files,
        again=options.again,
        page=options.page,
        strict=options.strict,
        progress=_print_row if options.rows else None if options.quiet else _print_progress,
        kept=_print_kept_rows if options.rows else None,
        run=context,
    )
    if options.report:
        write_report(options.report, json_text(report))
    if not (options.quiet or options.rows or options.report == "-"):
        print(
            f"{report['name']}: {report['done']} done, {report['not_clear']} not clear, "
            f"{report['failed']} failed, {report['not_run']} left; results in {report['output']}"
        )
        if report["done"] < len(report["runs"]):
            worst = next(row for row in report["runs"] if row["run"] == report["worst"])
            print("look first at: " + _line(worst))
    if report["status"] != "Ok":
        print(f"swept: {report['message']}", file=sys.stderr)
    return 128 + received[0] if received else _exit_status(report)


def main(words: List[str]) -> int:
    """Runs a command; returns its exit status."""
    try:
        return _study(_parser().parse_args(words))
    except Error as error:
        print(f"swept: {error.status}/{error.code}: {error}", file=sys.stderr)
        return USAGE if error.code in ("BadOption", "SameFile") else FAILED
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            silence_output()
        file_name = f"'{error.filename}': " if error.filename else ""
        print(f"swept: {file_name}{error.strerror or error}", file=sys.stderr)
        return FAILED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
