# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the envelope of each link of a robot from a URDF file and a table of joint positions over time.

    python3 robot.py ../data/arm.urdf ../data/arm.csv envelopes

Writes envelopes/LINK.ply for every link with a box or a cylinder. URDF uses m and rad; results are in mm.
"""
import csv
import pathlib
import sys
import xml.etree.ElementTree as ElementTree
from typing import Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

import swept_volume as sv
from sweep_box import box

Array = npt.NDArray[np.float64]
MM = 1000.0
#: Largest step of a joint between two poses (rad or m). Between two poses, a link moves along a
#: screw. If several joints move at once, this is only an approximation.
STEP = 0.02


def turned(axis: Array, angle: float) -> Array:
    """Returns the matrix (3, 3) of a turn about a unit axis (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix: Array = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return matrix


def numbers(element: Optional[ElementTree.Element], name: str, default: str) -> Array:
    text = default if element is None else element.get(name, default)
    return np.array([float(word) for word in text.split()])


def origin_of(element: ElementTree.Element) -> Array:
    """Returns the matrix (4, 4) of the element `origin`; lengths in mm."""
    origin = element.find("origin")
    roll, pitch, yaw = numbers(origin, "rpy", "0 0 0")
    matrix = np.eye(4)
    x, y, z = np.eye(3)
    matrix[:3, :3] = turned(z, yaw) @ turned(y, pitch) @ turned(x, roll)
    matrix[:3, 3] = numbers(origin, "xyz", "0 0 0") * MM
    return matrix


def cylinder(radius: float, length: float, sides: int = 48) -> sv.Mesh:
    """Returns a cylinder (mm) about the z axis, centred at the origin."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([radius * np.cos(angles), radius * np.sin(angles)])
    low, high = (np.column_stack([ring, np.full(sides, z)]) for z in (-length / 2, length / 2))
    ends = [[0, 0, -length / 2], [0, 0, length / 2]]
    triangles = []
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [(i, j, sides + j), (i, sides + j, sides + i)]
        triangles += [(2 * sides, j, i), (2 * sides + 1, sides + i, sides + j)]
    return sv.Mesh(np.vstack([low, high, ends]), triangles)


def shape_of(link: ElementTree.Element) -> Optional[Tuple[sv.Mesh, Array]]:
    """Returns the mesh of a link's visual element and its placement in the link, or None."""
    visual = link.find("visual")
    geometry = None if visual is None else visual.find("geometry")
    if visual is None or geometry is None:
        return None
    if (block := geometry.find("box")) is not None:
        size = numbers(block, "size", "0 0 0") * MM
        return box(list(size), list(-size / 2)), origin_of(visual)
    if (tube := geometry.find("cylinder")) is not None:
        radius, length = (float(tube.get(name, "0")) * MM for name in ("radius", "length"))
        return cylinder(radius, length), origin_of(visual)
    return None


def link_poses(robot: ElementTree.Element, positions: Dict[str, float]) -> Dict[str, Array]:
    """Returns the matrix (4, 4) of every link for one position of the joints."""
    joints = {joint.find("child").get("link"): joint for joint in robot.iter("joint")}  # type: ignore

    def pose(name: str) -> Array:
        joint = joints.get(name)
        if joint is None:
            return np.eye(4)
        moved, value = np.eye(4), positions.get(joint.get("name", ""), 0.0)
        axis = numbers(joint.find("axis"), "xyz", "1 0 0")
        if joint.get("type") in ("revolute", "continuous"):
            moved[:3, :3] = turned(axis / np.linalg.norm(axis), value)
        elif joint.get("type") == "prismatic":
            moved[:3, 3] = axis * value * MM
        parent = joint.find("parent").get("link", "")  # type: ignore
        return pose(parent) @ origin_of(joint) @ moved

    return {link.get("name", ""): pose(link.get("name", "")) for link in robot.iter("link")}


def positions_over_time(path: str) -> Tuple[Array, List[Dict[str, float]]]:
    """Returns times (s) and joint positions. Where a joint moves farther than STEP, adds rows between
    those of the file."""
    with open(path, newline="") as file:
        rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
    dense = [rows[0]]
    for a, b in zip(rows, rows[1:]):
        far = max(abs(b[name] - a[name]) for name in a if name != "time")
        count = max(1, int(np.ceil(far / STEP)))
        for n in range(1, count + 1):
            dense.append({name: a[name] + (b[name] - a[name]) * n / count for name in a})
    return np.array([row["time"] for row in dense]), dense


def main(urdf: str, table: str, folder: str) -> None:
    robot = ElementTree.parse(urdf).getroot()
    times, rows = positions_over_time(table)
    poses = [link_poses(robot, row) for row in rows]
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    for link in robot.iter("link"):
        shape, name = shape_of(link), link.get("name", "")
        if shape is None:
            continue
        mesh, place = shape
        matrices = np.array([pose[name] @ place for pose in poses])
        motion = sv.Motion.from_matrices(matrices, times, interpolation="screw")
        result = sv.compute(mesh, motion, resolution=96)
        result.mesh.write(pathlib.Path(folder) / f"{name}.ply")
        print(f"{name}: {result.report['volume'] / 1e6:.4g} litres along {len(motion)} poses")


if __name__ == "__main__":
    main(*sys.argv[1:4])
