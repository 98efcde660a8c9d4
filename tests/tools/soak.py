# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many runs in one process, some cancelled at random: memory stays flat, no handle is left open.

    python3 tests/tools/soak.py [RUNS]      (200)

Exit status 0 only if the resident size after the last runs is within 5 % of that after the first
fifth of them, and no file handle or thread was added.
"""
import os
import pathlib
import random
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


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def handles():
    return len(os.listdir("/proc/self/fd"))


def threads():
    return len(os.listdir("/proc/self/task"))


def one_run(rng, size):
    """A run of one size, which in two of five cases is cancelled. True if it ended Ok."""
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
        run.cancel_at_checkpoint = rng.randrange(1, 400)
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


def main(runs):
    rng = random.Random(11)
    warm = max(runs // 5, 1)
    ok, sizes, start = 0, [], time.time()
    first = None
    for n in range(runs):
        ok += one_run(rng, 96)
        sizes.append(resident())
        if n + 1 == warm:
            first = max(sizes[-10:]), handles(), threads()
        if (n + 1) % max(runs // 10, 1) == 0:
            print(f"{n + 1:5} runs, {ok} Ok, {sizes[-1] / 1e6:.1f} MB, {handles()} handles")
    last = max(sizes[-10:]), handles(), threads()
    print(
        f"{runs} runs in {time.time() - start:.0f} s, {ok} Ok, {runs - ok} cancelled; after "
        f"{warm}: {first[0] / 1e6:.1f} MB, at the end {last[0] / 1e6:.1f} MB "
        f"({100 * (last[0] / first[0] - 1):+.1f} %); handles {first[1]} -> {last[1]}, threads "
        f"{first[2]} -> {last[2]}"
    )
    flat = last[0] <= 1.05 * first[0] and last[1] <= first[1] and last[2] <= first[2]
    print("flat" if flat else "NOT FLAT")
    return 0 if flat and 0 < ok < runs else 1


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 200))
