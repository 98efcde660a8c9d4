# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP and BREP files that a function of the caller reads, as in FreeCAD with a core without OpenCASCADE."""
import numpy as np
import pytest

import _swept
import swept_volume as sv


NOTHING = np.empty((0, 3)), np.empty((0, 3), np.int32)


class Reader:
    """A reader that returns the same solids for every file, and records its arguments."""

    def __init__(self, *solids):
        self.solids, self.calls = solids, []

    def __call__(self, path, deflection, angle):
        self.calls.append((path, deflection, angle))
        return self.solids


@pytest.fixture
def step(tmp_path):
    path = tmp_path / "gehäuse.step"
    path.write_text("ISO-10303-21;\n")  # the reader ignores the content
    return path


def moved(box, shift):
    return box[0] + shift, box[1]


def test_the_reader_gives_the_body(box, step):
    faces = np.arange(12) // 2
    reader = Reader(("a", *box, faces), ("b", *moved(box, 100.0), faces + 6))
    body = sv.read_body(step, tolerance=0.1, angle=0.3, reader=reader)
    assert reader.calls == [(str(step), 0.1, 0.3)]
    assert len(body.vertices) == 16 and len(body.triangles) == 24
    np.testing.assert_array_equal(body.faces, np.r_[faces, faces + 6])
    assert body.chord_error == 0.1 and body.shape is None
    (found,) = body.findings
    assert found["code"] == "Tessellated" and found["count"] == 2


def test_without_a_tolerance_the_size_is_read_first(box, step):
    reader = Reader(("a", *box, None))
    body = sv.read_body(step, resolution=100, reader=reader)
    (_, coarse, _), (_, fine, _) = reader.calls
    longest = np.ptp(box[0], axis=0).max()
    assert coarse == 1 and fine == pytest.approx(0.02 * longest / 3**0.5 / 100)
    assert body.chord_error == fine and body.faces is None


def test_parts_keep_the_names_of_the_reader(box, step):
    reader = Reader(("left", *box, None), ("empty", *NOTHING, None), ("right", *box, None))
    parts = sv.read_parts(step, deflection=0.2, reader=reader)
    assert [name for name, _ in parts] == ["left", "right"]
    assert reader.calls[0][1] == 0.2


def test_a_mesh_file_needs_no_reader(box, tmp_path):
    path, reader = tmp_path / "box.ply", Reader()
    sv.write_mesh(path, box)
    assert len(sv.read_body(path, reader=reader).triangles) == 12
    assert len(sv.read_parts(path, reader=reader)) == 1
    assert not reader.calls


def test_what_a_reader_does_wrong_is_said(box, step):
    for solids in ((), (("a", *NOTHING, None),)):
        with pytest.raises(sv.InvalidInput, match="gehäuse.step.*no face") as caught:
            sv.read_body(step, tolerance=0.1, reader=Reader(*solids))
        assert caught.value.code == "NoSurface"
    with pytest.raises(ValueError, match="3 faces for 12 triangles of 'a'"):
        sv.read_body(step, tolerance=0.1, reader=Reader(("a", *box, [0, 1, 2])))
    with pytest.raises(ValueError, match="name, vertices, triangles, faces"):
        sv.read_body(step, tolerance=0.1, reader=Reader(("a", *box)))

    def broken(*_):
        raise OSError("the disk is gone")

    with pytest.raises(OSError, match="the disk is gone"):
        sv.read_parts(step, reader=broken)


@pytest.mark.skipif(_swept.HAS_SOLIDS, reason="built with OpenCASCADE")
def test_without_a_reader_solids_are_refused_by_name(step):
    for read in (sv.read_body, sv.read_parts):
        with pytest.raises(
            sv.InvalidInput, match="gehäuse.step.*built without OpenCASCADE"
        ) as caught:
            read(step)
        assert caught.value.code == "BadFormat"
