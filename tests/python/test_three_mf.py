# SPDX-License-Identifier: LGPL-2.1-or-later
"""3MF files of the core: valid ZIP archives that keep every digit of the mesh."""
import xml.etree.ElementTree as Tree
import zipfile

import numpy as np

import _swept

NAMESPACE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def read(path):
    with zipfile.ZipFile(path) as file:
        assert file.testzip() is None
        assert file.namelist()[0] == "[Content_Types].xml"
        relations = Tree.fromstring(file.read("_rels/.rels"))
        target = relations[0].get("Target")
        model = Tree.fromstring(file.read(target.lstrip("/")))
    assert model.get("unit") == "millimeter"
    points = [[float(v.get(k)) for k in "xyz"] for v in model.iter(NAMESPACE + "vertex")]
    corners = [
        [int(t.get(k)) for k in ("v1", "v2", "v3")] for t in model.iter(NAMESPACE + "triangle")
    ]
    items = [item.get("objectid") for item in model.iter(NAMESPACE + "item")]
    assert items == [obj.get("id") for obj in model.iter(NAMESPACE + "object")]
    return np.array(points), np.array(corners)


def test_the_mesh_to_the_last_digit(box, tmp_path):
    vertices = np.asarray(box[0], dtype=float) / 3 + 1e-7
    path = tmp_path / "a box.3mf"
    _swept.write_mesh(str(path), vertices, box[1])
    points, corners = read(path)
    assert np.array_equal(points, vertices) and np.array_equal(corners, box[1])


def test_large_meshes_go_through_in_pieces(tmp_path):
    # The mesh has more text than is compressed at once.
    rows = 150
    grid = np.arange(rows * rows)
    vertices = np.stack([grid % rows, grid // rows, np.sin(grid)], axis=1).astype(float)
    first = grid[(grid % rows < rows - 1) & (grid < rows * (rows - 1))]
    triangles = np.concatenate(
        [
            np.stack([first, first + 1, first + rows], axis=1),
            np.stack([first + 1, first + rows + 1, first + rows], axis=1),
        ]
    )
    path, again = tmp_path / "large.3mf", tmp_path / "again.3mf"
    _swept.write_mesh(str(path), vertices, triangles)
    points, corners = read(path)
    assert np.array_equal(points, vertices) and np.array_equal(corners, triangles)
    _swept.write_mesh(str(again), vertices, triangles)
    assert path.read_bytes() == again.read_bytes()
