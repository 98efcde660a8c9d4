# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of docs/bad_input.md through the Python module and the program."""
import contextlib
import gzip
import json
import os
import re
import resource
import subprocess
import sys
import threading

import numpy as np
import pytest

import _swept
import bodies

STILL = np.eye(4)[None]


def slide(x=50.0, y=0.0, z=0.0):
    """Returns two poses as matrices. Without times, they are one second apart."""
    motion = np.tile(np.eye(4), (2, 1, 1))
    motion[1, :3, 3] = x, y, z
    return motion


@pytest.fixture
def both(program, tmp_path):
    """Returns a function that runs body and motion through the module, and through files and the
    program. Both must end in the same way. The function returns the report."""

    program_names = {"memory_limit_mb": "--memory-limit"}

    def run(vertices, triangles, motion, **options):
        vertices, triangles = np.asarray(vertices, float), np.asarray(triangles, np.int64)
        try:
            report = _swept.compute(vertices, triangles, motion, **options).report
        except _swept.Error as error:  # inputs refused while arrays are read have no report
            report = error.report or {
                "status": error.status,
                "code": error.code,
                "message": str(error),
            }
        body = tmp_path / "body.off"
        lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
        lines += [" ".join(map(repr, map(float, v))) for v in vertices]
        lines += ["3 " + " ".join(map(str, t)) for t in triangles]
        body.write_text("\n".join(lines) + "\n")
        path = tmp_path / "motion.csv"
        rows = [" ".join(repr(float(x)) for x in matrix.ravel()) for matrix in motion]
        path.write_text("\n".join(rows) + "\n")
        words = [
            word
            for name, value in options.items()
            for word in (program_names.get(name, "--" + name), str(value))
        ]
        output = tmp_path / "out.ply"
        output.unlink(missing_ok=True)
        done = subprocess.run(
            [
                program, "envelope", body, "--motion", path, "--output", output,
                "--report", tmp_path / "report.json", *words,
            ],
            capture_output=True, text=True, timeout=120,
        )  # fmt: skip
        from_program = json.loads((tmp_path / "report.json").read_text())
        assert from_program["status"] == report["status"], (
            from_program["message"],
            report["message"],
        )
        assert (done.returncode == 0) == (report["status"] == "Ok") == output.exists()
        if report["status"] != "Ok":
            assert done.stderr.count("\n") == 1 and from_program["message"] in done.stderr
            assert len(report["message"]) > 30, "what, where, how much, what to do"
        run.program_code = from_program["code"]
        return report

    return run


def refused(report, code, *words, status="InvalidInput"):
    assert (report["status"], report["code"]) == (status, code), report["message"]
    for word in words:
        assert word in report["message"], report["message"]


def accepted(report, *warnings):
    assert report["status"] == "Ok", report["message"]
    assert report["closed"] and report["manifold"] and report["oriented"]
    found = {w["code"]: w for w in report["warnings"]}
    for code in warnings:
        assert code in found and found[code]["count"] > 0 and found[code]["text"], found
    return found


def test_bad_input_01_empty_mesh(both, box):
    refused(both(np.zeros((0, 3)), np.zeros((0, 3)), STILL), "EmptyMesh")
    refused(both(box[0], np.zeros((0, 3)), STILL), "EmptyMesh", "8 vertices")


def test_bad_input_02_index(both, box):
    triangles = box[1].copy()
    triangles[3, 1] = 99
    refused(both(box[0], triangles, STILL), "BadIndex", "triangle 3", "99")
    assert both.program_code == "BadFile"
    triangles[3, 1] = -4
    refused(both(box[0], triangles, STILL), "BadIndex", "triangle 3", "-4")


def test_bad_input_03_not_a_number(both, box):
    for value in (np.nan, np.inf):
        vertices = box[0].copy()
        vertices[[2, 5], 1] = value
        refused(both(vertices, box[1], STILL), "NonFiniteVertex", "2 vertices", "2, 5")


def test_bad_input_04_degenerate_triangles(both, box):
    triangles = np.vstack([box[1], [[0, 0, 1], [2, 2, 2]]])
    found = accepted(both(box[0], triangles, slide(), resolution=24), "DegenerateTriangles")
    assert found["DegenerateTriangles"]["count"] == 2
    line = [[0, 0, 0], [1, 0, 0], [2, 0, 0]]
    refused(both(line, [[0, 1, 2]], slide()), "NoVolume", "without area")


def test_bad_input_05_soup(both, box):
    soup = box[0][box[1]].reshape(-1, 3)
    index = np.arange(len(soup)).reshape(-1, 3)
    welded = both(soup, index, slide(), resolution=24)
    found = accepted(welded, "Welded")
    assert "before: 36, after: 8" in found["Welded"]["text"]
    assert welded["volume"] == both(*box, slide(), resolution=24)["volume"]
    gap = soup + np.arange(len(soup))[:, None] * 1e-7
    accepted(both(gap, index, slide(), resolution=24, **{}), "WeldedWithinTolerance")


def test_bad_input_06_open_mesh(both, box):
    refused(both(box[0], box[1][2:], STILL), "OpenMesh", "%", "close the gaps")
    sheet = [[0, 0, 0], [30, 0, 0], [30, 20, 0], [0, 20, 0]]
    report = both(sheet, [[0, 1, 2], [0, 2, 3]], slide(3, 2, 20), resolution=32)
    accepted(report, "OpenEdges")
    assert report["volume"] == pytest.approx(12000, rel=0.05)


def test_bad_input_07_inward(both, box):
    accepted(both(box[0], box[1][:, ::-1], slide(), resolution=24), "Flipped")


def test_bad_input_08_mixed_orientation(both, box):
    triangles = box[1].copy()
    triangles[[1, 6, 7]] = triangles[[1, 6, 7]][:, ::-1]
    report = both(box[0], triangles, slide(), resolution=24)
    accepted(report, "MixedOrientation")
    assert report["volume"] == pytest.approx(both(*box, slide(), resolution=24)["volume"])


def test_bad_input_09_non_manifold(both, box):
    other = box[0] + [10, 20, 0]  # shares one edge
    body = np.vstack([box[0], other]), np.vstack([box[1], box[1] + 8])
    report = both(*body, slide(0, 0, 30), resolution=32)
    accepted(report, "NonManifoldEdges")
    texts = [w["text"] for w in report["warnings"] if w["code"] == "NonManifoldEdges"]
    assert all("of the part" in text for text in texts), "it would read like a broken result"


def test_bad_input_10_overlap(both, box):
    body = np.vstack([box[0], box[0] + 5]), np.vstack([box[1], box[1] + 8])
    report = both(*body, STILL, resolution=48)
    accepted(report)
    assert report["volume"] == pytest.approx(2 * 6000 - 5 * 15 * 25, rel=0.02)


def test_bad_input_11_duplicates(both, box):
    report = both(box[0], np.vstack([box[1], box[1][:3]]), slide(), resolution=24)
    assert accepted(report, "DuplicateTriangles")["DuplicateTriangles"]["count"] == 3
    sheet = np.vstack([box[0], box[0][:3] + [0, 0, 200]])
    pair = np.vstack([box[1], [[8, 9, 10], [8, 10, 9]]])
    accepted(both(sheet, pair, slide(), resolution=24), "OppositeTriangles")


def test_bad_input_12_cavity(both, box):
    inner = box[0] * 0.5 + [2.5, 5, 7.5]
    body = np.vstack([box[0], inner]), np.vstack([box[1], box[1][:, ::-1] + 8])
    report = both(*body, STILL, resolution=48)
    accepted(report, "Cavities")
    assert report["shells"] == 1 and report["volume"] == pytest.approx(6000, rel=0.01)


def test_bad_input_13_thin_wall(both, box):
    report = both(box[0] * [1, 1, 0.001], box[1], slide(), resolution=32)
    accepted(report)
    assert report["volume"] < 3 * 60 * 20 * report["cell"]


def test_bad_input_14_far_away(both, box):
    report = both(box[0] + [1e6, -2e6, 3e6], box[1], slide(), resolution=24)
    accepted(report)
    assert report["volume"] == pytest.approx(36000, rel=0.01)
    refused(both(box[0] + 4e9, box[1], slide()), "OutOfRange", "1e9 mm")
    refused(both(box[0] * 1e-7 + 5e8, box[1], STILL), "PrecisionTooCoarse", "mm")


def test_bad_input_15_cell_against_body(both, box):
    refused(both(*box, STILL, cell=100), "CellTooLarge", "mm")
    refused(
        both(*box, STILL, cell=1e-5), "ResourceLimit", "smallest cell", "mm", status="ResourceLimit"
    )


@pytest.mark.parametrize("cell", [-1.0, float("nan"), float("inf")])
def test_bad_input_16_cell(program, box, cell):
    with pytest.raises(_swept.InvalidInput) as caught:
        _swept.compute(*box, STILL, cell=cell)
    assert caught.value.code == "BadOption" and f"the cell size is {cell:g} mm" in str(caught.value)
    done = subprocess.run(
        [program, "envelope", "a.ply", "--motion", "b.csv", "--output", "c.ply"]
        + [f"--cell={cell}"],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 2 and "--cell" in done.stderr


def test_bad_input_17_no_poses(both, box):
    refused(both(*box, np.zeros((0, 4, 4))), "EmptyTrajectory")


def test_bad_input_18_one_pose(both, box):
    report = both(*box, STILL, resolution=40)
    accepted(report)
    assert report["volume"] == pytest.approx(6000, abs=0.05 * 2200 * report["cell"])


def test_bad_input_19_repeated_poses(both, box):
    motion = slide()[[0, 0, 0, 1, 1]]
    found = accepted(both(*box, motion, resolution=24), "RepeatedPoses")
    assert found["RepeatedPoses"]["count"] == 3


def test_bad_input_20_small_drift(both, box):
    motion = slide()
    motion[1, :3, :3] *= 1 + 2e-5
    accepted(both(*box, motion, resolution=24))
    refused(
        both(*box, slide() * [[[1.01], [1], [1], [1]]]), "NotRigid", "pose 1", "scale", "0.0001"
    )


@pytest.mark.parametrize(
    "change, word",
    [
        (np.diag([2, 2, 2, 1.0]), "scale"),
        (np.diag([1, 1, -1, 1.0]), "mirror"),
        (np.array([[1, 0.2, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]]), ""),
        (np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1.0]]), "last row"),
    ],
)
def test_bad_input_21_not_rigid(both, box, change, word):
    motion = slide()
    motion[1] = change
    refused(both(*box, motion), "NotRigid", "pose 2", word)


def test_bad_input_22_bad_pose(both, box, program, tmp_path):
    motion = slide()
    motion[1, 1, 3] = np.nan
    refused(both(*box, motion), "BadPose", "pose 2")
    with pytest.raises(_swept.InvalidInput, match="pose 2.*is earlier than") as caught:
        _swept.compute(*box, ([1.0, 0.5], slide()))
    assert caught.value.code == "BadPose"


def test_bad_input_23_jump_and_half_turn(both, box):
    report = both(*box, slide(400), resolution=60)
    accepted(report)
    assert report["largest_step_travel"] > report["cell"] and report["chord_error"] >= 0
    turn = slide(0)
    turn[1] = np.diag([-1, -1, 1, 1.0])
    refused(both(*box, turn), "AmbiguousTurn", "pose 1 and pose 2", "180")


def test_bad_input_24_and_25_cancel(box):
    run = _swept.RunContext(1)
    run.cancel()
    run.cancel()
    with pytest.raises(_swept.Cancelled):
        _swept.compute(*box, slide(), run=run)
    run = _swept.RunContext(1)
    run._cancel_at_checkpoint(7)
    with pytest.raises(_swept.Cancelled):
        _swept.compute(*box, slide(), run=run, resolution=24)
    assert _swept.compute(*box, slide(), resolution=24).report["status"] == "Ok"


def test_bad_input_26_memory_budget(both, box):
    report = both(*box, slide(), resolution=4000, memory_limit_mb=1)
    refused(report, "ResourceLimit", "MB", "smallest cell", status="ResourceLimit")


def test_bad_input_26_plate_that_turns_often():
    """The estimate is within the limit, but a run with hundreds of overlapping copies is not. With
    interpolation, the run stays within the limit: it follows the motion less closely, and a finding
    says so."""
    plate = bodies.box((-20, -20, -1), (20, 20, 1))
    motion = np.array([bodies.frame((1, 2, 3), a, (a / 40, 0, 0)) for a in range(0, 1440, 10)])
    run = _swept.RunContext(memory_limit_mb=100)
    with pytest.raises(_swept.ResourceLimit, match="cross the grid .* limit of 104 MB; use a cell"):
        _swept.compute(*plate, motion, "none", run=run, resolution=256)
    run = _swept.RunContext(memory_limit_mb=100)
    report = _swept.compute(*plate, motion, run=run, resolution=256).report
    (finding,) = [w for w in report["warnings"] if w["code"] == "ChordCapped"]
    assert report["chord_error"] > 0.02 * report["cell"] and "memory" in finding["text"]


def test_bad_input_27_out_of_memory(program, box, tmp_path):
    _swept.write_mesh(tmp_path / "b.ply", *box)
    (tmp_path / "m.csv").write_text("0,0,0,0,0,0,0,1\n1,50,20,10,0,0,0.6,0.8\n")

    def call(resolution, megabytes):
        return subprocess.run(
            [
                program, "envelope", tmp_path / "b.ply", "--motion", tmp_path / "m.csv",
                "--output", tmp_path / "o.ply", "--report", tmp_path / "r.json", "--backend", "cpu",
                "--threads", "1", "--memory-limit", "100000", "--resolution", str(resolution),
            ],
            capture_output=True, text=True, timeout=120,
            preexec_fn=lambda: resource.setrlimit(
                resource.RLIMIT_AS, (megabytes << 20, megabytes << 20)
            ),
        )  # fmt: skip

    done = call(1200, 400)
    assert done.returncode == 1 and "OutOfMemory" in done.stderr, done.stderr
    assert json.loads((tmp_path / "r.json").read_text())["status"] == "OutOfMemory"
    assert not (tmp_path / "o.ply").exists()
    assert call(24, 400).returncode == 0


WITHOUT_ROOM = """
import resource
import numpy as np
import _swept
corners = np.array([[x, y, z] for x in (0, 10) for y in (0, 20) for z in (0, 30)], float)
quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
motion = np.tile(np.eye(4), (2, 1, 1))
motion[1, :3, 3] = 50, 20, 10
def compute(resolution):
    run = _swept.RunContext(1, 100000)  # a limit that refuses nothing
    try:
        return _swept.compute(corners, triangles, motion, resolution=resolution, run=run).report
    except _swept.Error as error:
        return error.report
compute(16)
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (60 << 20), resource.RLIM_INFINITY))
print(compute(1500)["status"])
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
print(compute(24)["status"])
"""


def test_bad_input_27_out_of_memory_in_a_process_that_goes_on():
    environment = {**os.environ, "PYTHONPATH": os.path.dirname(_swept.__file__)}
    command = [sys.executable, "-c", WITHOUT_ROOM]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)
    assert done.stdout == "OutOfMemory\nOk\n", done.stdout + done.stderr


ON_A_DEVICE = """
import numpy as np
import _swept
corners = np.array([[x, y, z] for x in (0, 10) for y in (0, 20) for z in (0, 30)], float)
quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
for backend in ("gpu", "auto"):
    try:
        report = _swept.compute(
            corners, triangles, np.eye(4)[None], resolution=16, backend=backend
        ).report
        print(report["backend"], report["device"])
    except _swept.Error as error:
        print(error.status, error)
"""


@pytest.fixture
def on_a_device(program, box, tmp_path):
    """Returns a function that runs a small job with backend gpu, then auto, in processes with this
    environment. The function returns the two lines of the module and the two reports of the
    program."""

    def run(**environment):
        environment = {**os.environ, "PYTHONPATH": os.path.dirname(_swept.__file__), **environment}
        options = {"env": environment, "capture_output": True, "text": True, "timeout": 120}
        output = subprocess.run([sys.executable, "-c", ON_A_DEVICE], **options)
        assert output.returncode == 0, output.stderr
        _swept.write_mesh(tmp_path / "b.ply", *box)
        (tmp_path / "m.csv").write_text("0,0,0,0,0,0,0,1\n")
        reports = []
        for backend in ("gpu", "auto"):
            subprocess.run(
                [
                    program, "envelope", tmp_path / "b.ply", "--motion", tmp_path / "m.csv",
                    "--output", tmp_path / "o.ply", "--report", tmp_path / "r.json",
                    "--resolution", "16", "--backend", backend,
                ],
                **options,
            )  # fmt: skip
            reports.append(json.loads((tmp_path / "r.json").read_text()))
        return output.stdout.splitlines(), reports

    return run


def test_bad_input_28_no_gpu(on_a_device):
    """A machine without a driver: `gpu` is refused, `auto` computes on the CPU."""
    output, reports = on_a_device(__EGL_VENDOR_LIBRARY_FILENAMES="/nowhere.json")
    assert re.match("DeviceUnavailable .*EGL", output[0]), output
    assert output[1].strip() == "cpu"
    assert reports[0]["status"] == "DeviceUnavailable" and "EGL" in reports[0]["message"]
    assert reports[1]["status"] == "Ok" and reports[1]["backend"] == "cpu"


def test_bad_input_28_importing_never_touches_gl():
    maps = "any('libEGL' in line or 'libGL' in line for line in open('/proc/self/maps'))"
    script = f"import _swept; assert not {maps}"
    folder = os.path.dirname(_swept.__file__)
    done = subprocess.run([sys.executable, "-c", script], env={"PYTHONPATH": folder})
    assert done.returncode == 0


def test_bad_input_29_software_only(on_a_device):
    output, reports = on_a_device(LIBGL_ALWAYS_SOFTWARE="1")
    if output[0].startswith("DeviceUnavailable"):
        pytest.skip(f"no software rasteriser: {output[0]}")
    assert re.match("gpu .*llvmpipe", output[0]) and output[1].strip() == "cpu", output
    assert reports[0]["status"] == "Ok" and "llvmpipe" in reports[0]["device"]
    assert reports[1]["backend"] == "cpu"


BROKEN_TABLES = [
    (b"t,tx,ty,tz,qx,qy,qz,qw\n0,1,2,3,0,0,0\n", "BadFile", "line 2"),
    (b"0,1,two,3,0,0,0,1\n1,1,2,3,0,0,0,1\n", "BadFile", "line 1, column 3"),
    (b"0;1,5,5;2;3;0;0;0;1\n", "BadFile", "column 2"),
    (b"0,0,0,0,0,0,0,1\n1,0,0", "BadFile", "line 2"),
    (b"0,0,0,0,0,0,0,1\n1,0,\0,0,0,0,0,1\n", "BadFile", "line 2"),
    ("0,0,0,0,0,0,0,1\n".encode("utf-16"), "BadFile", "UTF-16"),
    (gzip.compress(b"0,0,0,0,0,0,0,1\n")[:-9], "BadFile", "gzip"),
]


@pytest.fixture
def refused_table(program, box, tmp_path):
    """Returns a function that checks that the module and the program refuse a motion file with the
    same error. The function returns the error."""

    def refuse(text):
        (tmp_path / "m.csv").write_bytes(text)
        with pytest.raises(_swept.InvalidInput) as caught:
            _swept.read_trajectory_csv(tmp_path / "m.csv")
        _swept.write_mesh(tmp_path / "b.ply", *box)
        done = subprocess.run(
            [
                program, "envelope", tmp_path / "b.ply", "--motion", tmp_path / "m.csv",
                "--output", tmp_path / "o.ply",
            ],
            capture_output=True, text=True,
        )  # fmt: skip
        assert done.returncode == 1 and str(caught.value) in done.stderr
        assert not (tmp_path / "o.ply").exists()
        return caught.value

    return refuse


@pytest.mark.parametrize("text, code, says", BROKEN_TABLES)
def test_bad_input_34_broken_table(refused_table, text, code, says):
    error = refused_table(text)
    assert error.code == code and says in str(error)


@pytest.mark.parametrize("text", [b"", b"t,tx,ty,tz,qx,qy,qz,qw\n", b"\n# nothing\n\n"])
def test_bad_input_35_empty_table(refused_table, text):
    assert refused_table(text).code == "EmptyTrajectory"


FULL_DISK = """
import resource, signal, sys
import numpy as np
import _swept
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))
points = np.random.default_rng(1).random((900, 3))
try:
    _swept.write_mesh(sys.argv[1], points, np.arange(900).reshape(-1, 3))
except _swept.ExportFailed as error:
    print(error.code)
"""


@pytest.mark.parametrize("suffix", ["ply", "stl", "obj", "off"])
def test_bad_input_36_full_disk_for_the_module(tmp_path, suffix):
    target = tmp_path / f"o.{suffix}"
    target.write_text("old")
    environment = {**os.environ, "PYTHONPATH": os.path.dirname(_swept.__file__)}
    command = [sys.executable, "-c", FULL_DISK, str(target)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    assert done.stdout == "WriteFailed\n", done.stdout + done.stderr
    assert target.read_text() == "old" and list(tmp_path.iterdir()) == [target]


@contextlib.contextmanager
def damaged(folder, *kept):
    """Writes into every new file of the folder, except the given ones, as another program could."""
    done = threading.Event()

    def damage():
        while not done.is_set():
            for path in folder.iterdir():
                with contextlib.suppress(FileNotFoundError):  # it may go at any moment
                    if path not in kept and path.stat().st_size > 100:
                        with open(path, "r+b") as file:
                            file.write(b"garbage")

    thread = threading.Thread(target=damage)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()


TRIES = 5


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
def test_bad_input_37_solid_that_reads_back_wrong(program, tmp_path, box):
    """The file is damaged between writing and reading back. It must not replace the target."""
    # Many faces, so that writing takes long enough for the header to be damaged meanwhile.
    result = _swept.compute(*box, slide(20, 9, 4), resolution=48)
    target, report = tmp_path / "o.step", tmp_path / "r.json"
    # On a busy machine, the damage may come too late, even after the file was read back.
    error = None
    for _ in range(TRIES):
        target.write_text("old")
        try:
            with damaged(tmp_path, target):
                _swept.write_solid(
                    target,
                    result.vertices,
                    result.triangles,
                    max_faces=10**6,
                    merge_coplanar=False,
                )
        except _swept.ExportFailed as failure:
            error = failure
            break
    assert error is not None, "damaged files were accepted"
    assert error.code.startswith("Reread"), error
    assert target.read_text() == "old" and list(tmp_path.iterdir()) == [target]
    body, path = tmp_path / "b.ply", tmp_path / "m.csv"
    _swept.write_mesh(body, *box)
    path.write_text("0,0,0,0,0,0,0,1\n1,20,9,4,0,0,0.6,0.8\n")
    for _ in range(TRIES):
        target.write_text("old")
        with damaged(tmp_path, target, body, path, report):
            done = subprocess.run(
                [
                    program, "envelope", body, "--motion", path, "--output", target, "--resolution",
                    "48", "--max-faces", "100000", "--report", report,
                ],
                capture_output=True, text=True,
            )  # fmt: skip
        if done.returncode != 0:
            break
    assert done.returncode == 1 and "ExportFailed/Reread" in done.stderr, done.stderr
    assert target.read_text() == "old"
    assert set(tmp_path.iterdir()) == {target, body, path, report}


@pytest.mark.parametrize(
    "name, code",
    [
        ("no/such/o.ply", "MissingFolder"),
        ("folder.ply", "BadTarget"),
        ("o.xyz", "BadFormat"),
        ("o", "BadFormat"),
    ],
)
def test_bad_input_38_targets_of_the_module(tmp_path, box, name, code):
    (tmp_path / "folder.ply").mkdir()
    with pytest.raises(_swept.ExportFailed) as caught:
        _swept.write_mesh(tmp_path / name, *box)
    assert caught.value.code == code and name.split("/")[0] in str(caught.value)
    assert list(tmp_path.iterdir()) == [tmp_path / "folder.ply"]


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
@pytest.mark.parametrize("limit, tolerance", [(100, 0.005), (8, 0)])
def test_bad_input_39_too_many_faces(tmp_path, box, limit, tolerance):
    """Tests solids with more faces than the limit, with the given tolerance or with the largest
    automatic one."""
    turned = slide(20, 9, 4)
    turned[1, :3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    result = _swept.compute(*box, turned, resolution=24)
    target = tmp_path / "o.step"
    target.write_text("old")
    options = {"max_faces": limit, "tolerance": tolerance, "recognise": False}
    words = rf"\d+ faces .* MB.* limit is {limit} faces.*STL"
    with pytest.raises(_swept.ExportFailed, match=words) as caught:
        _swept.write_solid(target, result.vertices, result.triangles, **options)
    assert caught.value.code == "TooManyFaces", caught.value
    assert target.read_text() == "old" and list(tmp_path.iterdir()) == [target]


@pytest.mark.skipif(not _swept.HAS_SOLIDS, reason="built without OpenCASCADE")
def test_bad_input_39_too_many_faces_and_the_program(program, tmp_path, box):
    _swept.write_mesh(tmp_path / "b.ply", *box)
    (tmp_path / "m.csv").write_text("0,0,0,0,0,0,0,1\n1,20,9,4,0,0,0.6,0.8\n")
    target = tmp_path / "o.step"
    target.write_text("old")
    done = subprocess.run(
        [
            program, "envelope", tmp_path / "b.ply", "--motion", tmp_path / "m.csv", "--output",
            target, "--resolution", "24", "--max-faces", "8",
        ],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 1 and "ExportFailed/TooManyFaces" in done.stderr
    assert re.search(r"\d+ faces .* MB.* limit is 8 faces.*STL", done.stderr), done.stderr
    assert target.read_text() == "old"


def test_bad_input_40_names(program, box, tmp_path):
    folder = tmp_path / "Hüllkörper 扫掠 (1)" / ("x" * 120)
    folder.mkdir(parents=True)
    _swept.write_mesh(folder / "tělo.ply", *box)
    (folder / "pohyb ž.csv").write_text("0,0,0,0,0,0,0,1\n1,50,0,0,0,0,0,1\n")
    done = subprocess.run(
        [
            program, "envelope", folder / "tělo.ply", "--motion", folder / "pohyb ž.csv",
            "--resolution", "16", "--output", folder / "obálka.stl",
        ],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert len(_swept.read_mesh(folder / "obálka.stl").triangles) > 100
    assert len(_swept.read_trajectory_csv(folder / "pohyb ž.csv")[0]) == 2


def test_bad_input_42_two_runs_at_once(box):
    expected = [
        _swept.compute(*box, slide(x), resolution=40, threads=2).vertices.tobytes()
        for x in (20, 40, 60)
    ]
    found = [None] * 3
    threads = [
        threading.Thread(
            target=lambda n=n: found.__setitem__(
                n, _swept.compute(*box, slide(20 * (n + 1)), resolution=40, threads=n + 1)
            )
        )
        for n in range(3)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [result.vertices.tobytes() for result in found] == expected


def test_bad_input_42_two_programs_at_once(program, box, tmp_path):
    _swept.write_mesh(tmp_path / "b.ply", *box)
    (tmp_path / "m.csv").write_text("0,0,0,0,0,0,0,1\n1,50,20,10,0,0,0.6,0.8\n")

    def start(name):
        words = [program, "envelope", tmp_path / "b.ply", "--motion", tmp_path / "m.csv"]
        return subprocess.Popen(words + ["--resolution", "40", "--output", tmp_path / name])

    assert start("alone.ply").wait(120) == 0
    both = [start(f"{n}.ply") for n in (1, 2)]
    assert [process.wait(120) for process in both] == [0, 0]
    alone = (tmp_path / "alone.ply").read_bytes()
    assert all((tmp_path / f"{n}.ply").read_bytes() == alone for n in (1, 2))


def test_bad_input_45_thinner_than_the_cell(both):
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    report = both(corners * [1e-4, 1e-4, 40], triangles, STILL, resolution=16)
    if report["status"] != "Ok":
        refused(report, "CellTooLarge", "smaller cell")
    else:
        accepted(report)
