# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled module: arrays in and out, reports, errors, cancelling, signals."""
import gc
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest

import _swept

REPORT_KEYS = {
    "status", "code", "message", "vertices", "triangles", "shells", "closed", "manifold",
    "oriented", "self_intersections", "volume", "area", "cell", "grid", "placements",
    "refined_placements", "backend", "device", "threads", "seconds", "peak_memory_bytes",
    "warnings",
}  # fmt: skip


def test_slide_of_a_box_is_a_longer_box(box, slide):
    result = _swept.compute(*box, slide, resolution=60)
    report = result.report
    assert report["status"] == "Ok" and report["code"] == "" and report["message"] == ""
    assert report["closed"] and report["manifold"] and report["oriented"]
    cell, area = report["cell"], 2 * (60 * 20 + 60 * 30 + 20 * 30)
    assert report["volume"] == pytest.approx(60 * 20 * 30, abs=0.05 * area * cell)
    low, high = result.vertices.min(axis=0), result.vertices.max(axis=0)
    assert np.allclose(low, [0, 0, 0], atol=0.25 * cell)
    assert np.allclose(high, [60, 20, 30], atol=0.25 * cell)
    assert len(report["grid"]) == 3 and max(report["grid"]) >= 60
    assert report["placements"] == 2
    assert report["seconds"]["total"] > 0


def test_report_has_every_promised_key(box, still):
    report = _swept.compute(*box, still, resolution=16).report
    assert REPORT_KEYS <= set(report)


@pytest.mark.parametrize("nothing", [None, 0])
def test_none_and_0_are_values_not_given(box, still, slide, tmp_path, nothing):
    run = _swept.RunContext(threads=nothing, memory_limit_mb=nothing)
    assert run.threads is None
    run.threads = 2
    assert run.threads == 2
    run.threads = nothing
    assert run.threads is None
    limits = {"threads": nothing, "memory_limit_mb": nothing}
    plain = _swept.compute(*box, still, resolution=16)
    result = _swept.compute(*box, still, resolution=16, cell=nothing, run=run, **limits)
    assert result.report["cell"] == plain.report["cell"]
    if hasattr(_swept, "clearance"):
        arguments = (*box, slide, [("far", box[0] + [0, 30, 0], box[1])])
        near = _swept.clearance(*arguments, required=20, tolerance=0.02)
        same = _swept.clearance(*arguments, required=20, tolerance=0.02, interval_tolerance=nothing)
        assert near["neighbours"][0]["below"] == same["neighbours"][0]["below"] != []
        parts = [
            ("moving", *box, slide, "linear", 0.0),
            ("still", box[0] + [0, 30, 0], box[1], None, "linear", 0.0),
        ]
        near = _swept.mechanism(parts)
        same = _swept.mechanism(parts, range=nothing, interval_tolerance=nothing)
        assert near["range"] == same["range"] > 0
    if _swept.HAS_SOLIDS:
        _swept.write_solid(tmp_path / "box.step", *box, max_megabytes=nothing)
        assert (tmp_path / "box.step").exists()


def test_arrays_are_read_only_views_that_outlive_the_result(box, still):
    result = _swept.compute(*box, still, resolution=16)
    vertices, triangles = result.mesh.vertices, result.mesh.triangles
    assert vertices.dtype == np.float64 and vertices.shape[1] == 3
    assert triangles.dtype == np.int32 and triangles.shape[1] == 3
    assert result.vertices.ctypes.data == vertices.ctypes.data, "a copy was made"
    for array in (vertices, triangles):
        with pytest.raises(ValueError):
            array[0, 0] = 1
        with pytest.raises(ValueError):
            array.setflags(write=True)
    total = vertices.sum()
    del result
    gc.collect()
    assert vertices.sum() == total
    assert len(vertices) == _swept.check_mesh(vertices, triangles)["vertices"]


def test_inputs_are_not_changed_and_any_layout_is_taken(box, slide):
    vertices, triangles = box
    before = vertices.copy(), triangles.copy()
    expected = _swept.compute(vertices, triangles, slide, resolution=16).vertices
    odd = (np.asfortranarray(vertices), triangles.astype(np.uint8)[:, ::1])
    assert np.array_equal(_swept.compute(*odd, slide, resolution=16).vertices, expected)
    lists = (vertices.tolist(), triangles.tolist())
    assert np.array_equal(_swept.compute(*lists, slide, resolution=16).vertices, expected)
    assert np.array_equal(vertices, before[0]) and np.array_equal(triangles, before[1])


def test_matrices_and_quaternions_say_the_same(box):
    angle = 0.5
    c, s = np.cos(angle), np.sin(angle)
    matrices = np.tile(np.eye(4), (2, 1, 1))
    matrices[1] = [[c, -s, 0, 5], [s, c, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]
    quaternions = [[0, 0, 0, 1], [0, 0, np.sin(angle / 2), np.cos(angle / 2)]]
    translations = [[0, 0, 0], [5, 6, 7]]
    _, turns, places = _swept.poses_from_matrices([0, 1], matrices)
    assert np.allclose(turns, quaternions, rtol=0, atol=1e-15)
    assert np.array_equal(places, translations)
    one = _swept.compute(*box, matrices, resolution=24)
    two = _swept.compute(*box, ([0, 1], matrices), resolution=24)
    three = _swept.compute(*box, ([0, 1], quaternions, translations), resolution=24)
    assert np.array_equal(one.vertices, two.vertices)
    # Where the surface passes a lattice point, the last bit of a pose decides which element made the
    # crossing. Such a crossing is within a thousandth of a cell.
    bound = 1e-3 * one.report["cell"]
    assert one.vertices.shape == three.vertices.shape
    assert np.allclose(one.vertices, three.vertices, rtol=0, atol=bound)


def test_threads_do_not_change_a_bit(box, slide):
    one = _swept.compute(*box, slide, resolution=32, threads=1)
    for threads in (2, 3):
        other = _swept.compute(*box, slide, resolution=32, threads=threads)
        assert one.vertices.tobytes() == other.vertices.tobytes()
        assert one.triangles.tobytes() == other.triangles.tobytes()


@pytest.mark.parametrize(
    "change, status, code",
    [
        (lambda v, t: (v[:0], t[:0]), "InvalidInput", "EmptyMesh"),
        (lambda v, t: (v, t + 1), "InvalidInput", "BadIndex"),
        (lambda v, t: (v, t - 1), "InvalidInput", "BadIndex"),
        (lambda v, t: (v, t.astype(np.int64) + 2**32), "InvalidInput", "BadIndex"),
        (lambda v, t: (np.where(v == 30, np.nan, v), t), "InvalidInput", "NonFiniteVertex"),
    ],
)
def test_bad_bodies_raise_named_errors(box, still, change, status, code):
    with pytest.raises(_swept.Error) as caught:
        _swept.compute(*change(*box), still)
    assert (caught.value.status, caught.value.code) == (status, code)
    assert isinstance(caught.value, _swept.InvalidInput) and isinstance(caught.value, ValueError)


def test_bad_motions_raise_named_errors(box, still):
    times, quaternions, translations = still
    cases = [
        ((times[:0], quaternions[:0], translations[:0]), "EmptyTrajectory"),
        ((times, quaternions * 0, translations), "NotRigid"),
        ((times, quaternions, translations * np.nan), "BadPose"),
        (2 * np.eye(4)[None], "NotRigid"),
    ]
    for motion, code in cases:
        with pytest.raises(_swept.InvalidInput) as caught:
            _swept.compute(*box, motion)
        assert caught.value.code == code


def test_failed_runs_carry_their_report(box, still):
    with pytest.raises(_swept.InvalidInput) as caught:
        _swept.compute(box[0] * np.nan, box[1], still)
    assert caught.value.report["status"] == "InvalidInput"
    assert caught.value.report["code"] == caught.value.code
    assert caught.value.report["message"] == str(caught.value)


def test_shapes_types_and_names_are_checked(box, still):
    vertices, triangles = box
    with pytest.raises(ValueError, match=r"vertices has shape \(8, 2\); expected \(N, 3\)"):
        _swept.compute(vertices[:, :2], triangles, still)
    with pytest.raises(TypeError, match="integers"):
        _swept.compute(vertices, triangles.astype(float), still)
    with pytest.raises(TypeError, match="array of numbers"):
        _swept.compute("text", triangles, still)
    with pytest.raises(ValueError, match="quaternions"):
        _swept.compute(vertices, triangles, (still[0], still[1][:, :3], still[2]))
    with pytest.raises(ValueError, match="motion must be"):
        _swept.compute(vertices, triangles, (1, 2, 3, 4, 5))
    with pytest.raises(TypeError, match="unknown option 'resolutoin'"):
        _swept.compute(vertices, triangles, still, resolutoin=4)
    with pytest.raises(TypeError, match="resolution"):
        _swept.compute(vertices, triangles, still, resolution="many")
    with pytest.raises(TypeError, match="option backend cannot be 5"):
        _swept.compute(vertices, triangles, still, backend=5)
    with pytest.raises(_swept.InvalidInput, match="none, linear, screw"):
        _swept.compute(vertices, triangles, still, interpolation="cubic")
    with pytest.raises(_swept.InvalidInput, match="consistent"):
        _swept.compute(vertices, triangles, still, components="best")


def test_memory_limit_is_kept(box, still):
    with pytest.raises(_swept.ResourceLimit) as caught:
        _swept.compute(*box, still, resolution=2000, memory_limit_mb=1)
    assert caught.value.status == "ResourceLimit"


def test_estimate_runs_before(box, slide):
    found = _swept.estimate(*box, slide, resolution=64)
    report = _swept.compute(*box, slide, resolution=64).report
    assert found["grid"] == report["grid"] and found["cell"] == report["cell"]
    assert found["memory_bytes"] > 0 and found["triangles"] > 0


def test_cancel_from_another_thread(shared):
    mesh = _swept.read_mesh(shared / "meshes" / "bunny_stanford_70k.ply", unit="m")
    motion = _swept.read_trajectory_csv(
        shared / "motions" / "keyposes_16_arc_for_bunny.csv", unit="m"
    )
    run = _swept.RunContext()
    seen = []

    def watch():
        while run.progress < 0.06 and len(seen) < 2000:
            seen.append(run.progress)
            time.sleep(0.005)
        run.cancel()

    watcher = threading.Thread(target=watch)
    watcher.start()
    with pytest.raises(_swept.Cancelled):
        _swept.compute(mesh.vertices, mesh.triangles, motion, run=run, resolution=512)
    watcher.join()
    assert len(seen) > 2, "the watching thread did not run: the lock was not released"
    assert seen == sorted(seen), "progress fell"
    assert run.cancelled


def test_cancel_before_the_start_and_after_the_end(box, still):
    run = _swept.RunContext()
    run.cancel()
    with pytest.raises(_swept.Cancelled):
        _swept.compute(*box, still, run=run)
    done = _swept.RunContext()
    result = _swept.compute(*box, still, run=done, resolution=16)
    done.cancel()
    assert result.report["status"] == "Ok" and done.progress == 1.0 and done.phase == "done"


def test_cancel_at_any_checkpoint_then_run_again(box, slide):
    counted = _swept.RunContext()
    expected = _swept.compute(*box, slide, run=counted, resolution=16).vertices.tobytes()
    total = counted._checkpoints
    assert total > 3
    for k in sorted({1, 2, total // 3, total // 2, total - 1, total}):
        run = _swept.RunContext(threads=1)
        run._cancel_at_checkpoint(k)
        with pytest.raises(_swept.Cancelled) as caught:
            _swept.compute(*box, slide, run=run, resolution=16)
        assert caught.value.report["status"] == "Cancelled"
    assert _swept.compute(*box, slide, resolution=16).vertices.tobytes() == expected


def test_interrupt_stops_a_run(shared, root):
    script = textwrap.dedent(
        """
        import _swept, sys
        mesh = _swept.read_mesh(sys.argv[1], unit="m")
        motion = _swept.read_trajectory_csv(sys.argv[2], unit="m")
        print("go", flush=True)
        try:
            _swept.compute(mesh.vertices, mesh.triangles, motion, resolution=900)
        except KeyboardInterrupt:
            sys.exit(42)
        """
    )
    folder = os.path.dirname(_swept.__file__)
    child = subprocess.Popen(
        [
            sys.executable, "-c", script,
            str(shared / "meshes" / "bunny_stanford_70k.ply"),
            str(shared / "motions" / "keyposes_16_arc_for_bunny.csv"),
        ],
        env={**os.environ, "PYTHONPATH": folder},
        stdout=subprocess.PIPE,
    )  # fmt: skip
    assert child.stdout.readline() == b"go\n"
    time.sleep(0.3)
    start = time.monotonic()
    child.send_signal(signal.SIGINT)
    assert child.wait(timeout=60) == 42
    assert time.monotonic() - start < 10


def test_check_mesh_finds_a_hole(box):
    vertices, triangles = box
    whole = _swept.check_mesh(vertices, triangles)
    assert whole["passes"] and whole["volume"] == pytest.approx(6000)
    assert whole["area"] == pytest.approx(2 * (200 + 300 + 600))
    open_box = _swept.check_mesh(vertices, triangles[1:])
    assert not open_box["passes"] and not open_box["closed"] and open_box["open_edges"] == 3


@pytest.mark.parametrize("suffix", ["ply", "stl", "obj", "off"])
def test_mesh_files_round_trip(tmp_path, box, suffix):
    path = tmp_path / f"Hüllkörper 1.{suffix}"
    _swept.write_mesh(path, *box)
    mesh = _swept.read_mesh(str(path), unit="cm")
    assert len(mesh.triangles) == 12
    assert np.allclose(np.sort(mesh.vertices, axis=0), np.sort(box[0], axis=0) * 10)
    with pytest.raises(ValueError):
        mesh.vertices[0] = 0


def test_file_errors_are_named(tmp_path, box):
    with pytest.raises(_swept.InvalidInput) as caught:
        _swept.read_mesh(tmp_path / "absent.ply")
    assert caught.value.code == "BadFile" and "absent.ply" in str(caught.value)
    with pytest.raises(_swept.ExportFailed) as caught:
        _swept.write_mesh(tmp_path / "no" / "a.ply", *box)
    assert caught.value.code == "MissingFolder"
    (tmp_path / "a.csv").write_text("t,tx,ty,tz,qx,qy,qz,qw\n0,1,two,3,0,0,0,1\n")
    with pytest.raises(_swept.InvalidInput, match="line 2, column 3"):
        _swept.read_trajectory_csv(tmp_path / "a.csv")


def test_trajectory_file_to_arrays(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("t,tx,ty,tz,qx,qy,qz,qw\n0,1,2,3,0,0,0,1\n1,1,2,3,0,0,0.6,0.8\n")
    times, quaternions, translations = _swept.read_trajectory_csv(path, unit="in")
    assert times.tolist() == [0, 1]
    assert quaternions.tolist() == [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]
    assert translations[0] == pytest.approx([25.4, 50.8, 76.2])


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
def test_solid_within_a_tolerance_as_large_as_the_body(box, tmp_path):
    body = box[0] / np.ptp(box[0], axis=0) * [1, 1.5, 0.7], box[1]
    steps, axis = np.arange(4.0), np.array([1, 2, 3]) / np.sqrt(14)
    half = 0.35 * steps[:, None]
    turns = np.hstack([np.sin(half) * axis, np.cos(half)])
    shifts = np.column_stack([1.1 * steps, 0.5 * steps, 0.3 * steps**2])
    envelope = _swept.compute(*body, (steps, turns, shifts), "screw", resolution=32)
    size = float(np.ptp(envelope.vertices, axis=0).max())
    mesh = envelope.vertices, envelope.triangles
    report = _swept.write_solid(tmp_path / "envelope.step", *mesh, tolerance=size)
    assert report["valid"] and report["volume"] > 0 and 0 < report["tolerance"] <= size
    halved = "would turn inside out; the solid was made with a tolerance of" in report["note"]
    assert halved == (report["tolerance"] < size)
    tried = _swept.estimate_solid(*mesh, tolerance=size)
    assert tried["faces"] == report["faces"] and tried["tolerance"] == report["tolerance"]
    bound = _swept.estimate_solid(*mesh, quick=True, tolerance=size)
    assert not bound["tried"] and bound["faces"] >= 4
    brep = _swept.estimate_solid(*mesh, format="brep", tolerance=size)
    assert brep["faces"] == tried["faces"] and brep["megabytes"] != tried["megabytes"]
    with pytest.raises(_swept.ExportFailed, match="does not end in .step"):
        _swept.estimate_solid(*mesh, format="stl")


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
def test_solid_of_a_box(tmp_path, box):
    report = _swept.write_solid(tmp_path / "box.step", *box)
    assert 0 < report["edge_tolerance"] <= 1e-6, "edges lie on their faces"
    assert report["valid"] and report["solids"] == 1 and report["faces"] == 6
    assert report["volume"] == pytest.approx(6000)
    assert (tmp_path / "box.step").stat().st_size == report["file_bytes"]
    with pytest.raises(_swept.ExportFailed) as caught:
        _swept.write_solid(tmp_path / "no" / "box.step", *box)
    assert caught.value.code == "MissingFolder"
    assert os.listdir(tmp_path) == ["box.step"]


def test_every_public_function_has_a_docstring():
    for name in dir(_swept):
        if not name.startswith("_") and callable(getattr(_swept, name)):
            assert getattr(_swept, name).__doc__, name
    for word in ("float", "(N, 3)", "mm", "Raises"):
        assert word in _swept.compute.__doc__
