# SPDX-License-Identifier: LGPL-2.1-or-later
"""No file is trusted: nothing in it is executed. Temporary files are private, and nothing uses the network.
"""
import ast
import gzip
import re
import struct
import subprocess
import sys

import pytest

import _swept

#: Modules that run code from data, start programs or use the network.
MODULES = {
    "pickle", "marshal", "shelve", "dill", "joblib", "code", "subprocess", "multiprocessing",
    "socket", "ssl", "http", "urllib", "urllib3", "requests", "ftplib", "smtplib", "xmlrpc",
    "asyncio",
}  # fmt: skip
CALLS = {
    "eval",
    "exec",
    "compile",
    "__import__",
    "os.system",
    "os.popen",
    "tempfile.mktemp",
    "ctypes.CDLL",
}
#: Functions of the workbench that start a program, and the first arguments of what they start. It is
#: always a Python interpreter: for a study, for pip, and to ask for its version.
STARTS = {
    "workbench/sweptvolume/studies.py": ["['-m', 'swept_volume', 'study'"],
    "workbench/sweptvolume/core_install.py": [
        "[python, '-m', 'pip', 'config'",
        "[python, '-m', 'pip', 'install'",
    ],
    "workbench/sweptvolume/interpreter.py": ["[path, '-c', \"import sys; print("],
}
#: Functions of the system that the compiled module and the program may not use.
SYMBOLS = re.compile(
    r"^(socket|connect|bind|listen|accept4?|send(to|msg)?|recv(from|msg)?|getaddrinfo|gethostbyname"
    r"|system|popen|fork|vfork|exec[lv]p?e?|posix_spawnp?|tmpnam|tempnam|mktemp)$"
)
HUGE = 4_000_000_000


def breaches(source):
    """Returns the lines of Python that import or call something forbidden."""
    found = []
    for node in ast.walk(ast.parse(source)):
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and not node.level:
            names = [node.module]
        elif isinstance(node, ast.Call) and ast.unparse(node.func) in CALLS:
            found.append((node.lineno, ast.unparse(node.func)))
        found += [(node.lineno, name) for name in names if name.split(".")[0] in MODULES]
        if isinstance(node, ast.keyword) and node.arg == "allow_pickle":
            found.append((node.value.lineno, "allow_pickle"))
    return found


def test_workbench_runs_no_code_from_data_and_has_no_network(root):
    files = [root / "Init.py", root / "InitGui.py", *sorted((root / "workbench").rglob("*.py"))]
    assert len(files) > 50
    found = {str(f.relative_to(root)): breaches(f.read_text(encoding="utf-8")) for f in files}
    for name in STARTS:
        assert [word for _, word in found.pop(name)] == ["subprocess"]
    assert {name: lines for name, lines in found.items() if lines} == {}


def test_what_the_workbench_starts_is_fixed(root):
    """Checks that programs are started with a list of arguments, without a shell: first the
    interpreter, then a module of the workbench."""
    for name, beginnings in STARTS.items():
        tree = ast.parse((root / name).read_text(encoding="utf-8"))
        calls = [
            node
            for node in ast.walk(tree)
            if isinstance(node, ast.Call) and ast.unparse(node.func).startswith("subprocess.")
        ]
        assert {ast.unparse(call.func) for call in calls} <= {"subprocess.run", "subprocess.Popen"}
        for call in calls:
            assert "shell" not in [word.arg for word in call.keywords]
            words = ast.unparse(call.args[0])
            assert words in ("words", "[python] + words") or words.startswith(tuple(beginnings))
        started = {ast.unparse(n) for n in ast.walk(tree) if isinstance(n, ast.List)}
        for beginning in beginnings:
            assert any(text.startswith(beginning) for text in started), (name, beginning)


@pytest.mark.parametrize(
    "line",
    ["import pickle", "from urllib.request import urlopen", "eval(text)", "import http.client",
     "import os; os.system(text)", "np.load(f, allow_pickle=True)"],
)  # fmt: skip
def test_a_planted_breach_is_found(line):
    assert len(breaches(line)) == 1


def imported(path):
    """Returns the names that a binary uses from other libraries."""
    lines = subprocess.run(
        ["nm", "-D", "--undefined-only", path], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    return {line.split()[-1].split("@")[0] for line in lines}


def test_binaries_ask_for_no_network_and_start_no_program(program, root):
    # `swept study` replaces itself by the Python for which the program was built, and starts nothing
    # else.
    for path, allowed in ((program, ["execv"]), (_swept.__file__, [])):
        names = imported(path)
        assert "open" in names or "malloc" in names, "nm showed nothing of " + path
        assert sorted(name for name in names if SYMBOLS.match(name)) == allowed
    sources = [p for p in sorted(root.glob("cpp/**/*.cpp")) if "execv(" in p.read_text("utf-8")]
    assert [p.name for p in sources] == ["system_program.cpp"]
    assert any(map(SYMBOLS.match, imported(sys.executable))), "the pattern finds nothing at all"


def ply(vertices, faces, kind="binary_little_endian"):
    head = (
        "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    return head.format(kind, vertices, faces).encode()


PROMISES = {
    "vertices.ply": ply(HUGE, 1) + bytes(100),
    "faces.ply": ply(3, HUGE) + bytes(100),
    "text.ply": ply(HUGE, 1, "ascii") + b"0 0 0\n",
    "beyond_64_bits.ply": ply(10**30, 1) + bytes(100),
    "corners.ply": ply(3, 1).replace(b"uchar int", b"uint int")
    + bytes(36)
    + struct.pack("<I", HUGE)
    + bytes(12),
    "triangles.stl": bytes(80) + struct.pack("<I", HUGE) + bytes(50),
    "vertices.off": b"OFF\n%d 1 0\n0 0 0\n" % HUGE,
    "corners.off": b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n%d 0 1 2\n" % HUGE,
    "index.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 %d\n" % HUGE,
}
STILL = b"0,0,0,0,0,0,0,1\n1,1,0,0,0,0,0,1\n"
BOX = b"OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"


#: Runs a command with little address space, and writes its peak of memory (kB). The peak of a process
#: begins with that of its parent, so this parent must be small itself.
WATCH = """
import os, resource, subprocess, sys
def limit():
    resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
child = subprocess.Popen(sys.argv[2:], preexec_fn=limit)
_, status, used = os.wait4(child.pid, 0)
open(sys.argv[1], "w").write(str(used.ru_maxrss))
sys.exit(os.waitstatus_to_exitcode(status))
"""


def envelope(program, folder, body, motion):
    """Runs the program. Returns (exit code, output, peak of memory in MB)."""
    peak = folder / "peak.txt"
    command = [program, "envelope", body, "--motion", motion, "--output", folder / "out.ply"]
    done = subprocess.run(
        [sys.executable, "-c", WATCH, peak, *command],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    return done.returncode, done.stdout, int(peak.read_text()) / 1024


@pytest.mark.parametrize("name", PROMISES)
def test_a_promise_of_billions_takes_no_memory(program, tmp_path, name):
    body, motion = tmp_path / name, tmp_path / "m.csv"
    body.write_bytes(PROMISES[name])
    motion.write_bytes(STILL)
    code, output, megabytes = envelope(program, tmp_path, body, motion)
    assert code > 0 and "BadFile" in output and name in output, (code, output)
    assert megabytes < 100, megabytes
    assert not (tmp_path / "out.ply").exists()


@pytest.mark.parametrize("text", [b"0", b"\n", b"1,2,"])
def test_a_small_archive_of_much_takes_no_memory(program, tmp_path, text):
    body, motion = tmp_path / "b.off", tmp_path / "m.csv.gz"
    body.write_bytes(BOX)
    motion.write_bytes(gzip.compress(text * ((100 << 20) // len(text)), 1))
    assert motion.stat().st_size < 4 << 20
    code, output, megabytes = envelope(program, tmp_path, body, motion)
    assert code > 0 and re.search("BadFile|EmptyTrajectory|ResourceLimit", output), (code, output)
    assert megabytes < 100, megabytes


def test_the_same_body_and_motion_without_tricks(program, tmp_path):
    body, motion = tmp_path / "b.off", tmp_path / "m.csv.gz"
    body.write_bytes(BOX)
    motion.write_bytes(gzip.compress(STILL))
    assert envelope(program, tmp_path, body, motion)[0] == 0
