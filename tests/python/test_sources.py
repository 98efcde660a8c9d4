# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recorded sources of the triangles of an envelope, in Python and in the program, checked with
independent arithmetic.
"""
import csv
import pickle
import subprocess
import sys

import numpy as np
import pytest

import bodies
import source_check
from conftest import BUILD, ROOT

sys.path.insert(0, str(BUILD / "python"))
sys.path.insert(0, str(ROOT / "python"))
sv = pytest.importorskip("swept_volume")

#: Smallest distance (cells) of crossings from lattice points.
OFF = 1e-3
FACES = np.repeat(np.arange(6), 2)


def quaternion(axis, degrees):
    half = np.radians(degrees) / 2
    return np.append(np.array(axis) / np.linalg.norm(axis) * np.sin(half), np.cos(half))


@pytest.fixture
def motion():
    turns = [quaternion((1, 0, 0), 0), quaternion((1, 2, 3), 25), quaternion((2, -1, 1), 55)]
    return sv.Motion([0, 1, 2.5], turns, [(0, 0, 0), (12, 3, 5), (20, 15, 2)])


def wrong_fractions(sources, mesh, motion, cell):
    """Returns the fraction of wrong sources among the triangles with a source, and the fraction of
    triangles without a source."""
    body = source_check.BodyFaces(mesh.vertices, mesh.triangles, mesh.faces)
    poses = motion.times, motion.quaternions, motion.translations, motion.pivot
    off = source_check.residuals(sources.point, sources, body, poses)
    known = sources.kind >= 0
    return np.mean(off[known] > OFF * cell), np.mean(~known)


@pytest.mark.parametrize("named", [True, False])
@pytest.mark.parametrize("pivot", [(0, 0, 0), (5, 10, 15)])
def test_sources_are_true(box, motion, named, pivot):
    mesh, motion = sv.Mesh(*box, faces=FACES if named else None), motion.with_pivot(pivot)
    plain = sv.compute(mesh, motion, resolution=64)
    found = sv.compute(mesh, motion, resolution=64, sources=True)
    assert plain.sources is None and found.mesh == plain.mesh
    sources = found.sources
    assert len(sources) == len(found.triangles)
    assert sources.faces.shape == (len(sources), 2) and sources.point.shape == (len(sources), 3)
    assert set(sources.kind) - {-1} == {0, 1, 2}
    false, unknown = wrong_fractions(sources, mesh, motion, found.report["cell"])
    assert false < 0.01 and unknown < 0.01
    again = pickle.loads(pickle.dumps(found))
    for name in sources.__slots__:
        np.testing.assert_array_equal(getattr(again.sources, name), getattr(sources, name))
        assert not getattr(sources, name).flags.writeable


def test_planted_faults_are_seen(box, motion):
    mesh = sv.Mesh(*box, faces=FACES)
    found = sv.compute(mesh, motion, resolution=48, sources=True)
    everything = np.arange(len(found.sources))

    def after(spoil):
        rows = source_check.Rows(found.sources, everything)
        spoil(rows)
        return wrong_fractions(rows, mesh, motion, found.report["cell"])[0]

    assert after(lambda rows: None) < 0.01

    def face(rows):
        rows.faces[:, 0] = (rows.faces[:, 0] + 1) % 6

    def time(rows):
        rows.time += 0.02

    def step(rows):
        rows.step = (rows.step + 1) % 3

    def kind(rows):
        rows.kind = np.where(rows.kind == 0, 1, 0)

    for fault in (face, time, step, kind):
        assert after(fault) > 0.9, fault.__name__


def test_simplified_and_cut_again(box, motion):
    mesh = sv.Mesh(*box, faces=FACES)
    fine = sv.compute(mesh, motion, resolution=64, sources=True, tolerance=0.1)
    for result in (fine, fine.recut(0.5), fine.recut(0)):
        assert len(result.sources) == len(result.triangles)
        false, unknown = wrong_fractions(result.sources, mesh, motion, result.report["cell"])
        assert false < 0.03 and unknown < 0.03


def test_what_cannot_be_had_is_refused(box, motion):
    mesh = sv.Mesh(*box)
    for options in ({"offset": 1.0}, {"conservative": True}):
        with pytest.raises(sv.InvalidInput) as caught:
            sv.compute(mesh, motion, resolution=32, sources=True, **options)
        assert caught.value.code == "BadOption" and "sources" in str(caught.value)
    with pytest.raises(ValueError):
        sv.Mesh(*box, faces=[1, 2])
    for faces, code in ((FACES[:5], "BadFaces"), (FACES - 1, "BadFaces")):
        with pytest.raises(sv.InvalidInput) as caught:
            sv._core.compute(*box, motion._arrays(), faces=faces, sources=True, resolution=32)
        assert caught.value.code == code
    with pytest.raises(TypeError):
        sv._core.compute(*box, motion._arrays(), faces=FACES + 0.5, sources=True)


@pytest.fixture
def path(tmp_path, motion):
    file = tmp_path / "m.csv"
    rows = np.column_stack([motion.times, motion.translations, motion.quaternions])
    file.write_text("\n".join(",".join(map(repr, map(float, row))) for row in rows))
    return file


def run(program, *arguments):
    return subprocess.run(
        [program, "envelope", *map(str, arguments), "--resolution", "48"],
        capture_output=True,
        text=True,
    )


def test_program_writes_a_table(program, tmp_path, path, motion):
    if not sv.HAS_SOLIDS:
        pytest.skip("built without OpenCASCADE")
    vertices, triangles = bodies.box((0, 0, 0), (10, 20, 30))
    part, out, table = (tmp_path / name for name in ("b.step", "o.ply", "s.csv"))
    sv.write_solid(part, (vertices, triangles))
    done = run(program, part, "--motion", path, "-o", out, "--sources", table)
    assert done.returncode == 0, done.stderr
    with open(table, newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    assert [int(row["triangle"]) for row in rows] == list(range(len(sv.read_mesh(out).triangles)))
    body = sv.read_body(part, resolution=48)
    assert set(body.faces) == set(range(6))

    def column(name, kind, none):
        return np.array([kind(row[name]) if row[name] else none for row in rows])

    sources = sv.Sources(
        [sv.Sources.KINDS.index(row["kind"]) if row["kind"] else -1 for row in rows],
        np.column_stack([column("face", int, -1), column("other_face", int, -1)]),
        column("step", int, -1),
        column("time_s", float, np.nan),
        np.column_stack([column(axis, float, np.nan) for axis in "xyz"]),
    )
    false, unknown = wrong_fractions(sources, body, motion, 1.0)
    assert false < 0.01 and unknown < 0.01


def test_program_refuses_a_table_of_a_solid(program, tmp_path, path, box):
    part = tmp_path / "b.ply"
    sv.write_mesh(part, box)
    done = run(
        program, part, "--motion", path, "-o", tmp_path / "o.step", "--sources", tmp_path / "s.csv"
    )
    assert done.returncode == 2 and "--sources needs an output that is a mesh" in done.stderr
    out = tmp_path / "o.ply"
    done = run(program, part, "--motion", path, "-o", out, "--sources", out)
    assert done.returncode == 2 and "SameFile" in done.stderr
    assert not out.exists()
