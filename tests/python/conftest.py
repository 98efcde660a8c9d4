# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of the Python tests: the build, the inputs, small bodies, motions."""
import os
import pathlib
import signal
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("SWEPT_BUILD", ROOT / "build"))
SHARED = ROOT.parent / "shared" / "data"
sys.path.insert(0, str(BUILD / "python"))
# Background jobs of a shell and their children ignore this signal, but the tests interrupt programs.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def root():
    return ROOT


@pytest.fixture(scope="session")
def program():
    """Returns the path of the command line program."""
    path = BUILD / "bin" / "swept"
    assert path.exists(), f"{path} is missing: build first (cmake --build {BUILD})"
    return str(path)


@pytest.fixture(scope="session")
def shared():
    """Returns the folder of real meshes and motions beside the checkout."""
    if not SHARED.is_dir():
        pytest.skip(f"shared inputs are not here: {SHARED}")
    return SHARED


@pytest.fixture
def box():
    """Returns a box of 10 x 20 x 30 mm: vertices, triangles."""
    vertices = np.array([[x, y, z] for x in (0, 10) for y in (0, 20) for z in (0, 30)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return vertices, np.array(triangles, np.int32)


@pytest.fixture
def still():
    """Returns a motion of one pose: the part does not move."""
    return np.zeros(1), np.array([[0.0, 0.0, 0.0, 1.0]]), np.zeros((1, 3))


@pytest.fixture
def slide():
    """Returns a motion of 50 mm along x in one second: two poses."""
    translations = np.array([[0.0, 0.0, 0.0], [50.0, 0.0, 0.0]])
    return np.array([0.0, 1.0]), np.tile([0.0, 0.0, 0.0, 1.0], (2, 1)), translations
