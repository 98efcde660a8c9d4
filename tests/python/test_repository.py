# SPDX-License-Identifier: LGPL-2.1-or-later
"""The source tree: which folder may depend on which, licences, sizes of files."""
import importlib.util
import re
import subprocess
import sys

import pytest

SPDX = "SPDX-License-Identifier: LGPL-2.1-or-later"


def load(root, name):
    """Imports a script of tests/tools."""
    path = root / "tests" / "tools" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def rules(root):
    return load(root, "include_rules")


def test_dependencies_run_in_one_direction(rules, root):
    assert rules.breaches(root) == []


@pytest.mark.parametrize(
    "path, line, says",
    [
        (
            "cpp/src/contour/a.cpp",
            '#include "sampling/sampler.h"',
            "contour/ may not include sampl",
        ),
        ("cpp/src/base/a.h", '#include "grid/grid_plan.h"', "base/ may not include grid/"),
        ("cpp/src/check/a.h", '#include "pipeline/compute.h"', "check/ may not include pipeline/"),
        ("cpp/src/check/a.h", '#include "io/safe_file.h"', "check/ may not include io/"),
        ("cpp/src/pipeline/a.cpp", "#include <OpenMesh/Core/IO/MeshIO.hh>", "OpenMesh is not for"),
        ("cpp/src/pipeline/a.cpp", "#  include <TopoDS.hxx>", "OpenCASCADE is not for pipeline/"),
        ("cpp/src/check/a.cpp", "#include <pybind11/numpy.h>", "pybind11 is not for check/"),
        ("cpp/src/sampling/a.cpp", '#include "sampling/gl/gl_context.h"', "may not include"),
        (
            "cpp/src/sampling/cpu/a.cpp",
            '#include "sampling/gl/gl_context.h"',
            "cpu/ may not include sampling/gl",
        ),
        ("cpp/src/sampling/cpu/a.cpp", "#include <EGL/egl.h>", "OpenGL is not for sampling/"),
        ("cpp/include/swept/a.h", '#include "base/memory.h"', "public headers"),
        (
            "cpp/tools/swept/a.cpp",
            '#include "pipeline/stages.h"',
            "tools/ may not include pipeline",
        ),
        ("cpp/src/solid/a.cpp", '#include "contour/qef.h"', "solid/ may not include contour/"),
        ("cpp/src/solid/mesh/a.h", '#include "solid/model/model.h"', "mesh/ may not include sol"),
        ("cpp/src/solid/model/a.cpp", "#include <TopoDS.hxx>", "OpenCASCADE is not for solid/"),
        ("cpp/src/solid/a.cpp", "#include <TopoDS.hxx>", "OpenCASCADE is not for solid/"),
        ("cpp/src/solid/a.cpp", '#include "solid/kernel/brep.h"', "may not include solid/kernel/"),
        ("cpp/src/contour/a.cpp", '#include "contour/mend/mend.h"', "contour/ may not include"),
        ("cpp/src/geometry/a.h", '#include "motion/motion.h"', "geometry/ may not include motion/"),
        ("cpp/src/novelty/a.cpp", "#include <vector>", "novelty/ is no known room"),
    ],
)
def test_a_planted_breach_is_found(rules, root, tmp_path, path, line, says):
    file = tmp_path / path
    file.parent.mkdir(parents=True)
    file.write_text(f"// x\n{line}\n")
    found = rules.breaches(tmp_path)
    assert len(found) == 1 and found[0][1] == 2 and says in found[0][2], found
    script = root / "tests" / "tools" / "include_rules.py"
    done = subprocess.run([sys.executable, script, tmp_path], capture_output=True, text=True)
    assert done.returncode == 1 and f"{path}:2:" in done.stdout


@pytest.mark.parametrize(
    "path, line",
    [
        ("cpp/src/contour/a.cpp", '#include "grid/hermite_grid.h"'),
        ("cpp/src/pipeline/a.cpp", '#include "sampling/gl/gl_sampler.h"'),
        ("cpp/src/sampling/gl/a.cpp", "#include <EGL/egl.h>"),
        ("cpp/src/sampling/cpu/a.cpp", '#include "sampling/sampler.h"'),
        ("cpp/src/solid/kernel/a.cpp", "#include <TopoDS.hxx>"),
        ("cpp/src/solid/model/a.cpp", '#include "solid/mesh/half_edge.h"'),
        ("cpp/src/contour/mend/a.cpp", '#include "check/mesh_check.h"'),
        ("cpp/tools/swept/a.cpp", '#include "arguments.h"'),
    ],
)
def test_what_is_allowed_is_not_found(rules, tmp_path, path, line):
    file = tmp_path / path
    file.parent.mkdir(parents=True)
    file.write_text(line + "\n")
    assert rules.breaches(tmp_path) == []


@pytest.mark.parametrize(
    "path, line",
    [
        ("cpp/src/contour/a.cpp", "#include <unistd.h>"),
        ("cpp/tools/swept/a.cpp", "#include <windows.h>"),
        ("cpp/src/base/memory.cpp", "#include <sys/resource.h>"),
        ("cpp/src/base/memory.cpp", '  open("/proc/self/statm", 0);'),
        ("cpp/python/a.cpp", "#ifdef _WIN32"),
        ("cpp/src/solid/a.cpp", "gmtime_r(&now, &utc);"),
        ("cpp/src/base/timer.h", "::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);"),
        ("cpp/tools/swept/a.cpp", "std::signal(SIGPIPE, SIG_IGN);"),
        ("tests/unit/base/a_test.cpp", "const int own = getpid();"),
        ("tests/support/shapes.cpp", "#include <dlfcn.h>"),
    ],
)
def test_the_operating_system_is_met_in_one_file_only(rules, root, tmp_path, path, line):
    assert rules.system_breaches(root) == []
    file = tmp_path / path
    file.parent.mkdir(parents=True)
    file.write_text(f"// getpid() in a comment is none\n{line}\n")
    assert [found[1] for found in rules.system_breaches(tmp_path)] == [2]


@pytest.mark.parametrize(
    "path, line",
    [
        ("cpp/src/base/system.cpp", "#include <unistd.h>"),
        ("tests/support/process.cpp", "#include <sys/mman.h>"),
        ("tests/unit/io/a_test.cpp", 'if (!exists("/dev/full")) return;'),
        ("cpp/src/io/a.cpp", "file.open(name);"),
    ],
)
def test_what_may_meet_the_operating_system(rules, tmp_path, path, line):
    file = tmp_path / path
    file.parent.mkdir(parents=True)
    file.write_text(line + "\n")
    assert rules.system_breaches(tmp_path) == []


def test_a_planted_circle_of_rooms_is_found(rules):
    assert rules.cycle(rules.MAY_INCLUDE) is None
    planted = rules.MAY_INCLUDE | {"geometry": {"base", "contour"}}
    assert "geometry" in rules.cycle(planted)


def source_files(root):
    listed = subprocess.run(
        ["git", "-C", root, "ls-files", "--cached", "--others", "--exclude-standard"],
        capture_output=True,
        text=True,
    )
    if listed.returncode != 0:
        pytest.skip("not a git checkout")
    return [root / name for name in listed.stdout.splitlines() if (root / name).is_file()]


def test_every_source_file_names_its_licence(root):
    suffixes = (".h", ".cpp", ".py", ".glsl", ".comp", ".vert", ".frag", ".geom")
    bare = [
        path.relative_to(root)
        for path in source_files(root)
        if path.suffix in suffixes and SPDX not in path.read_text(encoding="utf-8")
    ]
    assert not bare


def test_sources_stay_readable_in_size(root):
    long = {}
    for path in source_files(root):
        if path.suffix in (".h", ".cpp", ".py"):
            lines = path.read_text(encoding="utf-8").count("\n")
            if lines > 700:  # 600 is the aim
                long[str(path.relative_to(root))] = lines
    assert not long


def test_headers_open_with_what_they_are_for(root):
    for path in root.glob("cpp/**/*.h"):
        first = path.read_text(encoding="utf-8").splitlines()[0]
        assert first.startswith("// ") and len(first) > 20, path


@pytest.fixture(scope="module")
def rows(root):
    return load(root, "bad_input_rows")


def test_every_row_of_bad_input_is_tested_every_way(rows, root):
    assert rows.gaps(root) == []


def test_a_row_without_a_test_is_found(rows, root, tmp_path):
    (tmp_path / "docs").mkdir()
    (tmp_path / "tests").mkdir()
    table = (root / "docs" / "bad_input.md").read_text(encoding="utf-8")
    (tmp_path / "docs" / "bad_input.md").write_text(table, encoding="utf-8")
    test = "def both(program):\n    _swept.compute(program)\n\n\n"
    test += "def test_bad_input_07_and_08_both(both):\n    both()\n"
    (tmp_path / "tests" / "test_it.py").write_text(test)
    missing = set(rows.gaps(tmp_path))
    assert (9, "Python") in missing and (7, "FreeCAD") in missing and (41, "FreeCAD") in missing
    assert not missing & {(7, "Python"), (8, "program"), (41, "Python"), (2, "FreeCAD")}


def test_the_table_of_bad_input_names_its_tests(rows, root):
    found = rows.tests(root)
    table = (root / "docs" / "bad_input.md").read_text(encoding="utf-8")
    numbers = []
    for line in table.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if cells[0].isdigit():
            numbers.append(int(cells[0]))
            named = set(re.findall(r"`(\w+)`", cells[-1]))
            there = {name for names in found[numbers[-1]].values() for name in names}
            assert named == there, f"row {numbers[-1]}"
    assert numbers == list(range(1, 46))


def test_every_command_has_a_page_with_a_picture(root):
    book = root / "docs" / "handbook"
    contents = (book / "README.md").read_text(encoding="utf-8")
    commands = sorted((root / "workbench" / "sweptvolume" / "commands").glob("*.py"))
    commands = [path.stem for path in commands if path.stem not in ("__init__", "base")]
    assert len(commands) >= 14
    for command in commands:
        page = book / f"{command}.md"
        assert f"({page.name})" in contents, f"{page.name} is not in the handbook's table"
        assert "](images/" in page.read_text(encoding="utf-8"), f"{page.name} has no picture"
    for page in book.glob("*.md"):
        for target in re.findall(r"\]\(([^)#]+)\)", page.read_text(encoding="utf-8")):
            assert (book / target).exists(), f"{page.name}: {target} is not there"
