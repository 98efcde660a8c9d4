# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workers of a study: processes of this machine, or the workers of a dask cluster.

A process of this machine (serve()) reads pickled tasks from its standard input and writes pickled
reports. If a process dies, its run has failed, and a new process computes the next run.
"""
from __future__ import annotations

import importlib
import os
import pathlib
import pickle
import queue
import signal
import subprocess
import sys
import tempfile
import threading
import time
from typing import Any, Callable, Dict, Iterator, Mapping, NamedTuple, Optional, Sequence, Tuple

from ._study_file import Run
from ._study_run import REPORT_FILE, Report, execute, failed, output_names, partial_folder
from ._values import bad_option

_POLL = 0.1  # time (s) between two checks whether the study was cancelled
#: Removes the current folder from the module path, because it may contain modules of any name.
_SERVE = (
    "import sys; sys.path[:] = [p for p in sys.path if p]; "
    "from swept_volume import _study_workers; _study_workers.serve(int(sys.argv[1]))"
)
Done = Tuple[int, Report, Optional[str]]  # number of the run, its report, its folder if it has one


class Task(NamedTuple):
    """The data that a worker needs to compute one run."""

    number: int
    run: Run
    key: str
    output: str
    hashes: Mapping[str, str]  # SHA-256 of each file of the run


def cores() -> int:
    """Returns the number of cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _ended(code: int) -> str:
    if code >= 0:
        return f"the process of the run ended with status {code}"
    text = f"the process of the run was ended by {signal.Signals(-code).name}"
    return text + (", as systems do when memory runs out" if code == -9 else "")


class _Process:
    """One worker process of this machine. If the process dies, the next task starts a new one."""

    def __init__(self, threads: int) -> None:
        self._threads = threads
        self._child: Optional[subprocess.Popen[bytes]] = None
        self._lock = threading.Lock()
        self._stopped = False

    def _running(self) -> Optional[subprocess.Popen[bytes]]:
        with self._lock:
            if self._stopped:
                return None
            if self._child is None:
                package = str(pathlib.Path(__file__).resolve().parents[1])
                paths = [package, os.environ.get("PYTHONPATH", "")]
                environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
                self._child = subprocess.Popen(
                    [sys.executable, "-c", _SERVE, str(self._threads)],
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    env=environment,
                )
            return self._child

    def compute(self, task: Task) -> Optional[Done]:
        """Computes a task. Returns None if the process was stopped."""
        child = self._running()
        if child is None:
            return None
        assert child.stdin and child.stdout
        try:
            pickle.dump(task, child.stdin)
            child.stdin.flush()
            done: Done = pickle.load(child.stdout)
            return done
        except (EOFError, OSError, pickle.UnpicklingError):
            code = child.wait()
            self._child = None
            if self._stopped:
                return None
            text = _ended(code)
            report = failed(task.run, task.key, "InternalError", "ProcessEnded", text)
            return task.number, report, None

    def stop(self) -> None:
        """Ends the process, without the result of its run. Any thread may call this."""
        with self._lock:
            self._stopped = True
            child = self._child
        if child is not None:
            child.kill()
            child.wait()


def compute_here(tasks: Sequence[Task], jobs: int, cancelled: Callable[[], bool]) -> Iterator[Done]:
    """Computes tasks in `jobs` processes of this machine. Yields the results in the order in which the
    runs end. Ends early if cancelled() returns True."""
    jobs = min(jobs, len(tasks))
    todo: queue.SimpleQueue[Task] = queue.SimpleQueue()
    results: queue.SimpleQueue[Optional[Done]] = queue.SimpleQueue()
    for task in tasks:
        todo.put(task)
    processes = [_Process(max(1, cores() // jobs)) for _ in range(jobs)]

    def work(process: _Process) -> None:
        try:
            while (done := process.compute(todo.get_nowait())) is not None:
                results.put(done)
        except queue.Empty:
            pass
        finally:
            process.stop()
            results.put(None)

    threads = [threading.Thread(target=work, args=(p,), daemon=True) for p in processes]
    for thread in threads:
        thread.start()
    working = jobs
    try:
        while working > 0 and not cancelled():
            try:
                found = results.get(timeout=_POLL)
            except queue.Empty:
                continue
            if found is None:
                working -= 1
            else:
                yield found
    finally:
        for process in processes:
            process.stop()
        for thread in threads:
            thread.join()


def _distributed() -> Any:
    try:
        return importlib.import_module("distributed")
    except ImportError as error:
        raise bad_option(
            "a scheduler needs dask.distributed, which is not installed; install it (on Debian: the "
            "package python3-distributed)"
        ) from error


def _threads_of_worker() -> int:
    threads: int = _distributed().get_worker().state.nthreads
    return max(1, cores() // max(1, threads))


def _on_worker(task: Task) -> Tuple[Report, Optional[str]]:
    """Computes a task on a machine that has access to the folders of the study."""
    return execute(task.run, task.key, task.output, task.hashes, _threads_of_worker())


Sent = Tuple[Report, Dict[str, bytes]]


def _on_worker_with_files(task: Task, files: Dict[str, bytes]) -> Sent:
    """Computes a task on a machine without access to the folders of the study. `files`: the contents of
    the input files. Returns the report and the contents of the result files."""
    with tempfile.TemporaryDirectory(prefix="swept-study-") as place:
        where = {}
        for number, (name, data) in enumerate(files.items()):
            folder = pathlib.Path(place) / str(number)
            folder.mkdir()
            where[name] = (
                folder / pathlib.PurePath(name).name
            )  # the report names a part after its file
            where[name].write_bytes(data)
        locate = {name: str(path) for name, path in where.items()}
        report, filled = execute(
            task.run, task.key, place, task.hashes, _threads_of_worker(), locate.__getitem__
        )
        names = [REPORT_FILE, *output_names(task.run)]
        names = [name for name in names if (pathlib.Path(filled) / name).exists()]
        return report, {name: (pathlib.Path(filled) / name).read_bytes() for name in names}


def _identity(data: bytes) -> bytes:
    return data


def _received(task: Task, sent: Sent) -> Tuple[Report, str]:
    report, files = sent
    folder = pathlib.Path(partial_folder(task.output))
    for name, data in files.items():
        (folder / name).write_bytes(data)
    return report, str(folder)


def compute_on_cluster(
    tasks: Sequence[Task], address: str, send_files: bool, cancelled: Callable[[], bool]
) -> Iterator[Done]:
    """Computes tasks on the workers of the dask scheduler at `address`. Yields the results in the order
    in which the runs end. If a worker is lost, the scheduler gives its runs to another worker. With
    send_files=True, inputs and results go through the scheduler; otherwise all machines must have
    access to the same folders."""
    client = _distributed().Client(address, timeout=20, set_as_default=False)
    with client, client.as_current():
        sent: Dict[str, Any] = {}  # the content of each file, sent to the cluster only once
        futures: Dict[Any, Task] = {}
        for task in tasks:
            if not send_files:
                futures[client.submit(_on_worker, task, pure=False)] = task
                continue
            for file in task.run.files():
                if file not in sent:
                    data = pathlib.Path(file).read_bytes()
                    sent[file] = client.submit(_identity, data, pure=False)
            inputs = {file: sent[file] for file in task.run.files()}
            futures[client.submit(_on_worker_with_files, task, inputs, pure=False)] = task
        try:
            yield from _as_they_end(futures, send_files, cancelled)
        finally:
            client.cancel(list(futures))


def _as_they_end(
    futures: Dict[Any, Task], send_files: bool, cancelled: Callable[[], bool]
) -> Iterator[Done]:
    ends, left = _distributed().as_completed(futures), len(futures)
    while left > 0 and not cancelled():
        ended = ends.next_batch(block=False)
        if not ended:
            time.sleep(_POLL / 10)
        for future in ended:
            if future.status in ("pending", "lost"):  # its worker died; another worker computes it
                ends.add(future)
                continue
            task = futures[future]
            left -= 1
            if future.status == "finished":
                result = future.result()
                report, folder = _received(task, result) if send_files else result
            else:  # its workers died repeatedly, or the cluster was closed
                error = future.exception() if future.status == "error" else "it was cancelled"
                text = f"the cluster gave up this run: {error}"
                report = failed(task.run, task.key, "InternalError", "WorkerLost", text)
                folder = None
            yield task.number, report, folder


def serve(threads: int) -> None:
    """Reads tasks from standard input and writes reports to standard output, until the input ends."""
    # Ctrl-C reaches all processes, but the study ends its workers itself.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    reports = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # other output goes to standard error, not between the reports
    while True:
        try:
            task: Task = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        report, folder = execute(task.run, task.key, task.output, task.hashes, threads)
        pickle.dump((task.number, report, folder), reports)
        reports.flush()
