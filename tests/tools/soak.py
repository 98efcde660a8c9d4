# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many runs in one process, some cancelled at random: memory stays flat, no handle is left open.

    python3 tests/tools/soak.py [RUNS]      (200)

Makes five rounds of the same runs; only the runs that a timer cancels differ. The first round is a warm-up.
After each run, the bytes in use (as the allocator counts them) and the resident size are read. All threads
share one heap (MALLOC_ARENA_MAX=1). Otherwise each thread has a heap that keeps what its largest run needed.
The sizes of such heaps jump by up to 18 MB without a trend, and would hide a trend. The exit status is 0 only
if the largest number of bytes in use and the median resident size of the last round are at most 5 % above
those of the second, and no file handle or thread was added.
"""
import ctypes
import os
import pathlib
import random
import statistics
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [
    os.environ.get("SWEPT_CORE", str(ROOT / "build/python")),
    str(ROOT / "tests/python"),
]

import numpy as np  # noqa: E402

import _swept  # noqa: E402
import bodies  # noqa: E402

ROUNDS = 5


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class MallInfo(ctypes.Structure):
    """The struct mallinfo2 of the GNU C library."""

    _fields_ = [
        (name, ctypes.c_size_t)
        for name in "arena ordblks smblks hblks hblkhd usmblks fsmblks uordblks fordblks keepcost".split()
    ]


def in_use():
    """Returns the bytes that are allocated and not freed, in all heaps and in separately mapped memory."""
    library = ctypes.CDLL(None)
    library.mallinfo2.restype = MallInfo
    found = library.mallinfo2()
    return found.uordblks + found.hblkhd


def handles():
    return len(os.listdir("/proc/self/fd"))


def threads():
    return len(os.listdir("/proc/self/task"))


def one_run(rng, size):
    """Makes a run of one size; two of five runs are cancelled. Returns whether it ended with Ok."""
    body = bodies.joined(
        bodies.torus(2, rng.uniform(0.4, 0.9), 24, 12), bodies.box((-1, -1, -3), (1, 1, 3))
    )
    path = [np.eye(4)]
    for _ in range(3):
        axis = [rng.uniform(-1, 1) for _ in range(3)]
        path.append(path[-1] @ bodies.frame(axis, rng.uniform(5, 80), axis))
    run = _swept.RunContext(rng.choice([1, 2, 3]))
    timer = None
    if rng.random() < 0.2:
        run._cancel_at_checkpoint(rng.randrange(1, 400))
    elif rng.random() < 0.25:
        timer = threading.Timer(rng.uniform(0, 0.3), run.cancel)
        timer.start()
    try:
        _swept.compute(*body, np.array(path), run=run, resolution=size)
        return True
    except _swept.Cancelled:
        return False
    finally:
        if timer is not None:
            timer.cancel()
            timer.join()


def one_round(runs, size):
    """Makes a round of runs, the same each time. Returns (number that ended with Ok, largest number of
    bytes in use, median resident size)."""
    rng = random.Random(11)
    ok, used, sizes = 0, [], []
    for _ in range(runs):
        ok += one_run(rng, size)
        used.append(in_use())
        sizes.append(resident())
    return ok, max(used), statistics.median(sizes)


def main(runs):
    start, rounds, opened = time.time(), [], []
    for n in range(ROUNDS):
        rounds.append(one_round(max(runs // ROUNDS, 1), 96))
        opened.append((handles(), threads()))
        ok, used, size = rounds[-1]
        print(
            f"round {n + 1}: {ok} Ok, at most {used / 1e6:.2f} MB in use, resident {size / 1e6:.1f} MB, "
            f"{opened[-1][0]} handles, {opened[-1][1]} threads",
            flush=True,
        )
    (_, used, size), (_, last_used, last_size) = rounds[1], rounds[-1]
    ok, total = sum(r[0] for r in rounds), ROUNDS * max(runs // ROUNDS, 1)
    print(
        f"{total} runs in {time.time() - start:.0f} s, {ok} Ok, {total - ok} cancelled; second to last "
        f"round: in use {100 * (last_used / used - 1):+.1f} %, resident "
        f"{100 * (last_size / size - 1):+.1f} %"
    )
    flat = last_used <= 1.05 * used and last_size <= 1.05 * size
    flat = flat and all(last <= max(first) for first, last in zip(zip(*opened[:2]), opened[-1]))
    print("flat" if flat else "NOT FLAT")
    return 0 if flat and 0 < ok < total else 1


if __name__ == "__main__":
    # The variable works only if it is set before the process starts.
    if os.environ.get("MALLOC_ARENA_MAX") != "1":
        os.environ["MALLOC_ARENA_MAX"] = "1"
        os.execv(sys.executable, [sys.executable, *sys.argv])
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 200))
