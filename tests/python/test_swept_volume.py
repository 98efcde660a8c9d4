# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package swept_volume: values, options, errors, logging, signatures, types, threads, processes."""
import inspect
import logging
import multiprocessing
import os
import pathlib
import pickle
import shutil
import subprocess
import sys
import threading

import numpy as np
import pytest

import swept_volume as sv

OPTIONS = {"resolution": 24, "backend": "cpu"}
MEASURED = ("seconds", "peak_memory_bytes")  # in a report; all else is the same in every run


@pytest.fixture
def mesh(box):
    return sv.Mesh(*box)


@pytest.fixture
def motion(slide):
    return sv.Motion(*slide)


def outcome(result):
    report = {key: value for key, value in result.report.items() if key not in MEASURED}
    return result.vertices.tobytes(), result.triangles.tobytes(), report


def test_meshes_and_arrays_say_the_same_everywhere(box, slide, mesh, motion):
    expected = outcome(sv.compute(mesh, motion, **OPTIONS))
    assert outcome(sv.compute(box, slide, **OPTIONS)) == expected
    assert outcome(sv.compute(mesh, slide, **OPTIONS)) == expected
    matrices = np.tile(np.eye(4), (2, 1, 1))
    matrices[1, 0, 3] = 50
    for given in (matrices, ([0, 1], matrices), list(matrices), sv.Motion.from_matrices(matrices)):
        assert outcome(sv.compute(mesh, given, **OPTIONS)) == expected
    assert sv.check_mesh(mesh) == sv.check_mesh(box)
    assert sv.estimate(mesh, motion)["grid"] == sv.estimate(box, slide)["grid"]
    points = [[-5, 0, 0], [5, 10, 15]]
    assert sv.distance_to_mesh(points, mesh).tolist() == [5, -5]
    wall = sv.Mesh(mesh.vertices + [0, 30, 0], mesh.triangles)
    found = sv.clearance(mesh, motion, [("wall", wall)])
    assert found["neighbours"][0]["distance"] == pytest.approx(10)
    with_arrays = sv.clearance(box, slide, [("wall", (wall.vertices, wall.triangles), 0.5)])
    assert with_arrays["neighbours"][0]["guaranteed"] < found["neighbours"][0]["guaranteed"]


def test_the_interpolation_is_the_motions_own_unless_given(mesh):
    half = [[0, 0, 0, 1], [0, 0, np.sin(0.5), np.cos(0.5)]]
    screw = sv.Motion([0, 1], half, [[0, 0, 0], [50, 0, 0]], interpolation="screw")
    own = sv.compute(mesh, screw, **OPTIONS)
    other = sv.compute(mesh, screw, interpolation="linear", **OPTIONS)
    assert own.report["volume"] != other.report["volume"]
    with pytest.raises(sv.InvalidInput, match="none, linear, screw"):
        sv.Motion([0, 1], half, [[0, 0, 0], [50, 0, 0]], interpolation="cubic")


def test_values_cannot_be_changed_and_copies_are_taken(box):
    vertices = box[0].copy()
    mesh = sv.Mesh(vertices, box[1])
    vertices[0, 0] = 77
    assert mesh.vertices[0, 0] == 0
    with pytest.raises(ValueError):
        mesh.vertices[0, 0] = 1
    with pytest.raises(AttributeError):
        mesh.colour = "red"


def test_repr_says_what_it_is(mesh, motion):
    assert repr(mesh) == "<Mesh: 8 vertices, 12 triangles in a box of 10 x 20 x 30 mm>"
    assert repr(motion) == "<Motion: 2 poses, linear, from 0 to 1 s>"
    result = sv.compute(mesh, motion, **OPTIONS)
    assert repr(result).startswith(f"<Result: {len(result.triangles)} triangles, ")
    assert repr(sv.RunContext()) == "<RunContext: input, 0 %>"


def test_values_results_and_errors_can_be_pickled(mesh, motion):
    assert pickle.loads(pickle.dumps(mesh)) == mesh
    assert pickle.loads(pickle.dumps(motion)) == motion
    result = sv.compute(mesh, motion, tolerance=0.1, **OPTIONS)
    copy = pickle.loads(pickle.dumps(result))
    assert outcome(copy) == outcome(result)
    assert np.array_equal(copy.contact_time, result.contact_time)
    assert np.array_equal(copy.feature_edges, result.feature_edges)
    assert len(result.recut(2.0).triangles) <= len(result.triangles)
    with pytest.raises(sv.InvalidInput, match="compute the result again"):
        copy.recut(2.0)
    with pytest.raises(sv.InvalidInput) as caught:
        sv.compute(sv.Mesh(np.empty((0, 3)), np.empty((0, 3), int)), motion)
    error = pickle.loads(pickle.dumps(caught.value))
    assert (type(error), str(error)) == (type(caught.value), str(caught.value))
    assert (error.status, error.code, error.report) == (
        "InvalidInput",
        "EmptyMesh",
        caught.value.report,
    )


def test_files_that_are_not_there_raise_the_systems_own_errors(tmp_path):
    for read in (sv.read_mesh, sv.read_body, sv.read_motion, sv.Mesh.read, sv.Motion.read):
        with pytest.raises(FileNotFoundError) as caught:
            read(tmp_path / "none.ply")
        assert caught.value.filename == str(tmp_path / "none.ply")
        with pytest.raises(IsADirectoryError):
            read(tmp_path)


def test_files_that_exist_are_kept_if_asked_for(box, mesh, tmp_path):
    target = tmp_path / "a.ply"
    sv.write_mesh(target, box)
    old = target.read_bytes()
    for write in (lambda: mesh.write(target, no_clobber=True),
                  lambda: sv.write_mesh(target, mesh, no_clobber=True)):  # fmt: skip
        with pytest.raises(sv.ExportFailed, match="exists") as caught:
            write()
        assert caught.value.code == "Exists" and target.read_bytes() == old
    sv.write_mesh(tmp_path / "new.ply", mesh, no_clobber=True)
    if sv.HAS_SOLIDS:
        solid = tmp_path / "a.step"
        solid.symlink_to(tmp_path / "nowhere.step")  # a broken link counts as a file
        with pytest.raises(sv.ExportFailed, match="exists"):
            sv.write_solid(solid, mesh, no_clobber=True)
        report = sv.write_solid(tmp_path / "b.step", mesh, no_clobber=True)
        assert report["closed"] and report["warnings"] == [] and report["seconds"]["build"] >= 0


def test_masked_arrays_are_refused(box, slide, mesh):
    masked = np.ma.masked_equal(box[0], 30)
    for call in (lambda: sv.Mesh(masked, box[1]), lambda: sv.compute((masked, box[1]), slide)):
        with pytest.raises(TypeError, match="vertices is a masked array"):
            call()
    with pytest.raises(TypeError, match="triangles is a masked array"):
        sv.Mesh(box[0], np.ma.array(box[1]))
    with pytest.raises(TypeError, match="translations is a masked array"):
        sv.Motion(slide[0], slide[1], np.ma.array(slide[2]))
    import _swept

    with pytest.raises(TypeError, match="vertices is a masked array"):
        _swept.compute(masked, box[1], slide)


def test_resolution_and_cell_exclude_one_another(mesh, motion):
    for call in (sv.compute, sv.estimate):
        with pytest.raises(sv.InvalidInput, match="exclude one another") as caught:
            call(mesh, motion, resolution=64, cell=1.0)
        assert (caught.value.status, caught.value.code) == ("InvalidInput", "BadOption")
    with pytest.raises(sv.InvalidInput, match="exclude one another"):
        sv.PreviewSession(mesh, resolution=64, cell=1.0)
    with pytest.raises(sv.InvalidInput, match="exclude one another"):
        sv.read_body("part.step", resolution=64, cell=1.0)


def test_shapes_and_types_are_named(box, slide):
    with pytest.raises(ValueError, match=r"vertices has shape \(8, 2\); expected \('N', 3\)"):
        sv.Mesh(box[0][:, :2], box[1])
    with pytest.raises(TypeError, match="triangles must be an array of integers"):
        sv.Mesh(box[0], box[1].astype(float))
    with pytest.raises(ValueError, match="beyond 32 bits"):
        sv.Mesh(box[0], box[1].astype(np.int64) + 2**32)
    with pytest.raises(TypeError, match="array of numbers"):
        sv.Mesh([["a", "b", "c"]], box[1])
    with pytest.raises(TypeError, match="a mesh is a Mesh or a pair"):
        sv.compute("part.stl", slide)
    with pytest.raises(TypeError, match="a motion is a Motion"):
        sv.compute(box, "motion.csv")
    with pytest.raises(TypeError, match="a neighbour is"):
        sv.clearance(box, slide, [box[0]])
    with pytest.raises(TypeError, match="unexpected keyword argument 'resolutoin'"):
        sv.compute(box, slide, resolutoin=4)


def test_a_context_left_early_cancels_its_run(mesh, motion):
    with sv.RunContext(threads=1) as run:
        sv.compute(mesh, motion, run=run, **OPTIONS)
    assert run.progress == 1 and not run.cancelled
    with pytest.raises(KeyError):
        with sv.RunContext() as run:
            raise KeyError
    assert run.cancelled
    with pytest.raises(sv.Cancelled):
        sv.compute(mesh, motion, run=run, **OPTIONS)


def test_findings_go_to_the_log(mesh, motion, caplog):
    upside_down = sv.Mesh(mesh.vertices, mesh.triangles[:, ::-1])
    with caplog.at_level(logging.INFO, logger="swept_volume"):
        result = sv.compute(upside_down, motion, **OPTIONS)
    codes = [finding["code"] for finding in result.report["warnings"]]
    assert "Flipped" in codes
    assert [record.message.split(":")[0] for record in caplog.records] == codes


def test_every_public_name_has_a_signature_and_a_text():
    for name in sv.__all__:
        value = getattr(sv, name)
        if inspect.isfunction(value) or (
            inspect.isclass(value) and not issubclass(value, Exception)
        ):
            assert value.__doc__, name
            for parameter in inspect.signature(value).parameters.values():
                assert parameter.annotation is not inspect.Parameter.empty, (name, parameter)
    assert "resolution" in inspect.signature(sv.compute).parameters
    assert not [name for name in dir(sv.RunContext) if "checkpoint" in name and name[0] != "_"]


def test_the_types_hold(root):
    if not shutil.which("mypy"):
        pytest.skip("mypy is not installed")
    command = ["mypy", "--strict", "--no-incremental", "python/swept_volume"]
    done = subprocess.run(
        command + [str(p) for p in sorted(root.glob("examples/python/*.py"))],
        cwd=root,
        env={**os.environ, "MYPYPATH": "python"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout


def test_wrong_types_are_found(root, tmp_path):
    if not shutil.which("mypy"):
        pytest.skip("mypy is not installed")
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import swept_volume as sv\nsv.compute(sv.read_mesh('a.stl'), 'motion.csv')\n")
    environment = {**os.environ, "MYPYPATH": str(root / "python")}
    done = subprocess.run(
        ["mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), str(wrong)],
        env=environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 1 and 'Argument 2 to "compute"' in done.stdout


@pytest.fixture
def example(root, tmp_path):
    """Returns a function that runs a program of examples/python in an empty folder and returns its
    output."""
    build = pathlib.Path(sys.modules["_swept"].__file__).parent

    def run(name, *words):
        done = subprocess.run(
            [sys.executable, str(root / "examples/python" / name), *map(str, words)],
            env={**os.environ, "PYTHONPATH": str(build)},
            cwd=tmp_path,
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


def test_the_example_runs(example, tmp_path):
    text = example("sweep_box.py", "out.ply")
    assert "<Result: " in text and "1 checked" in text
    assert sv.check_mesh(sv.read_mesh(tmp_path / "out.ply"))["passes"]


def test_the_example_of_arrays_runs(example, tmp_path):
    example("from_arrays.py", "out.ply")
    mesh = sv.read_mesh(tmp_path / "out.ply")
    assert sv.check_mesh(mesh)["passes"]
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    # Cells of 1 mm: the corner that moves along an arc is accurate to some tenths of a millimetre.
    assert low == pytest.approx([-10, -10, -10], abs=0.2) and high[0] == pytest.approx(50, abs=0.2)


def test_the_example_of_a_robot_runs(example, root, tmp_path):
    data = root / "examples/data"
    example("robot.py", data / "arm.urdf", data / "arm.csv", "links")
    assert sorted(p.name for p in (tmp_path / "links").iterdir()) == [
        "bar.ply", "forearm.ply", "upper_arm.ply",
    ]  # fmt: skip
    arm = sv.read_mesh(tmp_path / "links/upper_arm.ply")
    report = sv.check_mesh(arm)
    # A block of 340 x 50 x 60 mm, from x = -20 to 320 mm, turned by 1.6 rad about z: its corner at
    # (320, 25) mm sweeps the outermost arc.
    assert report["passes"]
    assert np.linalg.norm(arm.vertices[:, :2], axis=1).max() == pytest.approx(
        np.hypot(320, 25), abs=0.5
    )
    assert np.ptp(arm.vertices[:, 2]) == pytest.approx(60, abs=0.01)
    forearm = sv.read_mesh(tmp_path / "links/forearm.ply")
    end = np.cos(0.6) * 250 + 300  # the far end of the tube's axis, 0.6 rad above the horizon
    assert np.linalg.norm(forearm.vertices[:, :2], axis=1).max() > end
    assert forearm.vertices[:, 2].max() > 200 + 250 * np.sin(0.6)


def test_the_example_of_a_cnc_program_runs(example, root, tmp_path):
    text = example("cnc.py", root / "examples/data/pocket.nc", 6, "cut.stl")
    assert "the cut spans 46 x 26 x 29 mm" in text
    assert sv.check_mesh(sv.read_mesh(tmp_path / "cut.stl"))["passes"]


def test_the_example_of_an_assembly_runs(example, tmp_path):
    output = example("assembly.py", "path.csv")
    assert (
        "slider and crank: clear" in output
        and "cover: contact" in output
        and "way: found" in output
    )
    assert len(sv.read_motion(tmp_path / "path.csv").times) > 2


def test_the_example_of_an_installation_runs(example, tmp_path):
    output = example("installation.py", "made")
    assert "order: motor, lid" in output and "lid and motor share" in output
    assert "study: 1 done, nearest 1 mm" in output
    assert (tmp_path / "made/results/study.csv").exists()


def test_a_step_file_is_a_body(mesh, motion, tmp_path):
    if not sv.HAS_SOLIDS:
        pytest.skip("built without OpenCASCADE")
    sv.write_solid(tmp_path / "part.step", mesh)
    body = sv.read_body(tmp_path / "part.step", cell=1.0)
    assert body.chord_error == pytest.approx(0.02)
    result = sv.compute(body, motion, cell=1.0, backend="cpu")
    assert result.report["warnings"][0]["code"] == "Tessellated"
    plain = sv.compute(mesh, motion, cell=1.0, backend="cpu")
    assert result.report["volume"] == pytest.approx(plain.report["volume"], rel=1e-9)
    with pytest.raises(sv.InvalidInput, match="contains its own unit"):
        sv.read_body(tmp_path / "part.step", unit="m")
    sv.write_mesh(tmp_path / "part.ply", mesh)
    assert sv.read_body(tmp_path / "part.ply").chord_error == 0


def run_alone(queue, mesh, motion):
    queue.put(outcome(sv.compute(mesh, motion, **OPTIONS)))


@pytest.mark.parametrize("way", ["fork", "spawn"])
def test_processes_give_the_same_bytes_and_their_own_reports(mesh, motion, way):
    expected = outcome(sv.compute(mesh, motion, **OPTIONS))
    context = multiprocessing.get_context(way)
    queue = context.Queue()
    jobs = [context.Process(target=run_alone, args=(queue, mesh, motion)) for _ in range(2)]
    for job in jobs:
        job.start()
    found = [queue.get(timeout=120) for _ in jobs]
    for job in jobs:
        job.join(timeout=60)
        assert job.exitcode == 0
    assert found == [expected, expected]


def test_threads_give_the_same_bytes_and_their_own_reports(mesh, motion):
    other = sv.Mesh(mesh.vertices * 0.5, mesh.triangles)
    expected = [outcome(sv.compute(m, motion, threads=2, **OPTIONS)) for m in (mesh, other)]
    found = [[], []]

    def work(i, part):
        for _ in range(3):
            found[i].append(outcome(sv.compute(part, motion, threads=2, **OPTIONS)))

    threads = [threading.Thread(target=work, args=(i, m)) for i, m in enumerate((mesh, other))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [3 * [expected[0]], 3 * [expected[1]]]
