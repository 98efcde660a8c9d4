# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs with a lower priority than the other threads of the process."""
import os
import subprocess
import sys

import pytest

PROGRAM = """
import threading, time
import numpy as np
import _swept
_swept.stand_back()
box = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
faces = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
poses = np.tile(np.eye(4), (2, 1, 1))
poses[1, :3, 3] = 3, 2, 1
run = _swept.RunContext()
def work():
    try:
        _swept.compute(box, faces, poses, resolution=700, run=run)
    except _swept.Cancelled:
        pass
thread = threading.Thread(target=work)
thread.start()
while run.progress < 0.02 and thread.is_alive():
    time.sleep(0.005)
import os
nice = {}
for task in os.listdir("/proc/self/task"):
    words = open("/proc/self/task/%s/stat" % task).read().rsplit(")", 1)[1].split()
    nice[int(task)] = int(words[16])
run.cancel()
thread.join()
print(nice[os.getpid()], max(nice.values()))
"""


@pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="priorities of threads are Linux's"
)
def test_runs_stand_back_and_the_caller_does_not():
    import _swept

    if os.nice(0) >= 10:
        pytest.skip(
            "the tests themselves run at nice {}: nothing is left to see".format(os.nice(0))
        )
    folder = os.path.dirname(_swept.__file__)
    done = subprocess.run(
        ["nice", "-n", "0", sys.executable, "-c", PROGRAM],
        env=dict(os.environ, PYTHONPATH=folder),
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    own, highest = map(int, done.stdout.split())
    assert highest == 10 and own < 10
