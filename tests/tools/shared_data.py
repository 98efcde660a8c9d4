# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shared test data: their folder, and motions scaled to a body."""
import pathlib

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parents[2].parent / "shared" / "data"
MOTIONS = (
    "static_1_pose.csv",
    "keyposes_16_from_tum_fr2_desk.csv",
    "installation_34_from_baxter_left.csv",
)


def rotate(q, x):
    """Returns points (N, 3) rotated by unit quaternions (N, 4), scalar last."""
    u, w = q[:, :3], q[:, 3:]
    return x + 2 * np.cross(u, np.cross(u, x) + w * x)


def turn(axis, degrees):
    """Returns a unit quaternion, scalar last."""
    axis, half = np.array(axis, float), np.radians(degrees) / 2
    return np.append(axis / np.linalg.norm(axis) * np.sin(half), np.cos(half))


def product(a, b):
    """Returns the product of two quaternions, scalar last."""
    u, v = a[:3], b[:3]
    return np.append(a[3] * v + b[3] * u + np.cross(u, v), a[3] * b[3] - u @ v)


def scaled_motion(swept, name, size):
    """Returns (quaternions, translations) of a recorded path, scaled so that it spans twice
    `size`."""
    _, quaternions, translations = map(
        np.asarray, swept.read_trajectory_csv(str(FOLDER / "motions" / name))
    )
    extent = np.ptp(translations, axis=0).max()
    return quaternions, translations * (2 * size / extent if extent > 0 else 1.0)


def matrices(quaternions, translations):
    """Returns poses as matrices (N, 4, 4)."""
    poses = np.tile(np.eye(4), (len(quaternions), 1, 1))
    for column in range(3):
        axis = np.tile(np.eye(3)[column], (len(quaternions), 1))
        poses[:, :3, column] = rotate(quaternions, axis)
    poses[:, :3, 3] = translations
    return poses
