#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks which folder includes which: prints each breach of the rules as file:line, and ends with 1 if
there is any.

    base <- geometry <- motion <- grid <- stages <- pipeline <- { python, tools }

A room is a folder below cpp/src (or one of the folders beside it); a room inside a room is named by both
("solid/mesh"). Each room lists the rooms that it may include besides itself and the public headers. The
list has no cycle, which is checked as well. Each third-party library is included in one room only, and
the headers of the operating system in one file of the core and one of the tests. Usage: include_rules.py
[ROOT]
"""
import graphlib
import pathlib
import re
import sys

BELOW = {"base", "geometry", "motion", "grid"}  # what every stage may use
STAGES = set("input sampling signs crossings offset contour simplify check".split())
SAMPLERS = {"sampling/cpu", "sampling/gl", "sampling/dense"}

MAY_INCLUDE = {
    "base": set(),
    "geometry": {"base"},
    "motion": {"base", "geometry"},
    "grid": {"base", "geometry", "motion"},
    "io": {"base", "geometry"},
    # The moving part from a mesh file or, through a public header, from a solid.
    "io/body": {"base"},
    "input": BELOW,
    "signs": BELOW,
    "sampling": BELOW | {"signs"},
    "sampling/culling": BELOW | {"signs", "sampling"},
    # Two samplers compute, while they sample, which lattice points the outside reaches.
    **{sampler: BELOW | {"signs", "sampling", "sampling/culling"} for sampler in SAMPLERS},
    # Exact crossings are computed from the elements that a sampler was given.
    "crossings": BELOW | {"signs", "sampling", "sampling/culling"},
    # Covers the sweep with the elements that culling keeps.
    "offset": BELOW | {"signs", "sampling", "sampling/culling"},
    "contour": BELOW,
    # The second half of contouring checks and moves what the first half made.
    "contour/mend": BELOW | {"contour", "check"},
    "simplify": BELOW,
    "check": BELOW,
    # Independent of the pipeline; checks its inputs with the same functions.
    "clearance": BELOW | {"input"},
    # The shared volume of two solids; distances are measured by `clearance`.
    "overlap": BELOW | {"clearance", "input"},
    # Searches for a path; `clearance` checks every step.
    "path": BELOW | {"clearance", "input"},
    # Makes a page from a report. The shapes for it are thinned through a public header.
    "page": {"base", "geometry", "motion"},
    "solid/carrier": BELOW,
    # B-spline surfaces through exact points, and the motion of a body at one time.
    "solid/sweep": BELOW | {"solid/carrier"},
    "solid/mesh": BELOW | {"solid/carrier", "simplify"},
    "solid/recognise": BELOW | {"solid/carrier", "solid/mesh"},
    "solid/model": BELOW | {"solid/carrier", "solid/mesh", "solid/recognise"},
    "solid/text": BELOW | {"solid/carrier", "solid/mesh", "solid/model"},
    # Makes the solid of a sweep from the faces and edges of the body, with the kernel.
    "solid/assemble": BELOW | {"solid/carrier", "solid/sweep", "solid/mesh"},
    "solid/kernel": BELOW
    | {f"solid/{r}" for r in "carrier mesh recognise model text assemble".split()},
    "solid": BELOW
    | {"simplify"}
    | {f"solid/{r}" for r in "carrier mesh recognise model text".split()},
    "pipeline": BELOW | STAGES | SAMPLERS | {"sampling/culling", "contour/mend"},
    "python": {"base", "io"},  # besides the public headers
    "tools": {"base", "io"},
    "include": set(),
    # Benchmarks time single stages.
    "bench": BELOW | STAGES | SAMPLERS | {"sampling/culling", "contour/mend", "io", "support"},
    "support": set(),  # tests/support
}

# Third-party libraries: pattern of their headers, folders that may include them, name. The folders
# inside a listed folder may include them, too.
EVERYWHERE = {room.split("/")[0] for room in MAY_INCLUDE}
THIRD_PARTIES = [
    (re.compile(r"Eigen/"), EVERYWHERE, "Eigen"),
    (re.compile(r"tbb/|oneapi/"), EVERYWHERE - {"include", "python", "tools"}, "TBB"),
    (re.compile(r"OpenMesh/"), {"io", "geometry", "simplify"}, "OpenMesh"),
    (re.compile(r"zlib\.h|lzma\.h|minizip/"), {"io"}, "zlib, minizip and lzma"),
    # Reports are JSON; the base has the common part of them.
    (re.compile(r"nlohmann/"), {"base"}, "nlohmann-json"),
    (re.compile(r"CLI/"), {"tools"}, "CLI11"),
    (re.compile(r"openssl/"), {"tools"}, "OpenSSL"),
    (re.compile(r"pybind11/"), {"python"}, "pybind11"),
    (re.compile(r"fcl/"), {"clearance"}, "FCL"),
    (re.compile(r"EGL/|GL/|glm/"), {"sampling/gl"}, "OpenGL"),
    (re.compile(r"[A-Za-z0-9_]+\.hxx"), {"solid/kernel", "solid/assemble"}, "OpenCASCADE"),
]
# Files that may use the headers and the names of POSIX, Linux, macOS and Windows.
SYSTEM_FILES = {
    "cpp/src/base/system.cpp",
    "cpp/src/base/system_program.cpp",
    "cpp/src/base/system_windows.cpp",
    "tests/support/process.cpp",
}
SYSTEM_HEADERS = re.compile(
    r"(unistd|fcntl|dlfcn|poll|dirent|pwd|grp|spawn|termios|sched|semaphore|pthread|glob|ftw|io|"
    r"direct|process|malloc|psapi|shellapi|windows|winsock2|Windows)\.h$|(sys|mach|mach-o|linux|net)/"
)
SYSTEM_WORDS = re.compile(
    r'"/(dev|proc)/|\b_WIN32\b|\b__linux__\b|\b__APPLE__\b|\b__GLIBC__\b|'
    r"\b(SIGHUP|SIGPIPE|SIGXFSZ|SIGKILL|SIGUSR[12]|sigaction|getpid|fileno|isatty|setenv|mkstemp|"
    r"gmtime_r|localtime_r|clock_gettime|strtok_r|nanosleep)\b"
)
# Tests may name files that only some systems have; on other systems they are skipped.
MAY_NAME_DEVICES = "tests/"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def room_of(folders):
    """Returns the room: 'solid/mesh' for ('solid', 'mesh'), 'contour' for ('contour', 'qef.h'). The
    room may be unknown."""
    inner = "/".join(folders[:2])
    return inner if inner in MAY_INCLUDE else folders[0]


def room_of_file(path, root):
    """Returns the room of a file: 'contour' for cpp/src/contour/..., 'tools' for cpp/tools/..."""
    parts = path.relative_to(root).parts
    return room_of(parts[2:] if parts[1] == "src" else parts[1:])


def breach(path, root, quoted, header):
    """Returns what is wrong with one include, or None."""
    room = room_of_file(path, root)
    unknown = "/ is no known room; add it to tests/tools/include_rules.py"
    if room not in MAY_INCLUDE:
        return room + unknown
    for pattern, allowed, name in THIRD_PARTIES:
        if pattern.match(header):
            # OpenCASCADE is for two rooms in solid/, not for solid/ and its other rooms.
            part = room if name == "OpenCASCADE" else room.split("/")[0]
            return None if {part, room} & allowed else f"{name} is not for {room}/"
    if not quoted or "/" not in header or header.startswith("swept/"):
        return None
    if room == "include":
        return "public headers include only swept/ headers and Eigen"
    target = room_of(header.split("/"))
    if target not in MAY_INCLUDE:
        return target + unknown
    if target == room or target in MAY_INCLUDE[room]:
        return None
    return f"{room}/ may not include {target}/"


def breaches(root):
    """Returns all breaches below ROOT/cpp as (path, line number, text)."""
    found = []
    for path in sorted(root.glob("cpp/**/*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if match:
                text = breach(path, root, match[1] == '"', match[2])
                if text:
                    found.append((path.relative_to(root), number, f"{match[2]}: {text}"))
    return found


def system_breaches(root):
    """Returns uses of the operating system outside SYSTEM_FILES, in the form of breaches()."""
    found = []
    for path in sorted(root.glob("cpp/**/*")) + sorted(root.glob("tests/**/*")):
        name = path.relative_to(root).as_posix()
        if path.suffix not in (".h", ".cpp") or name in SYSTEM_FILES:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            code = line.split("//")[0]
            include = INCLUDE.match(code)
            header = SYSTEM_HEADERS.match(include[2]) if include and include[1] == "<" else None
            word = SYSTEM_WORDS.search(code)
            if word and word[0].startswith('"') and name.startswith(MAY_NAME_DEVICES):
                word = None
            if header or word:
                text = f"{(header or word)[0]}: the operating system is for base/system*.cpp only"
                found.append((path.relative_to(root), number, text))
    return found


def cycle(rooms):
    """Returns a cycle of rooms that may include one another, or None."""
    try:
        graphlib.TopologicalSorter(rooms).prepare()
    except graphlib.CycleError as error:
        return " -> ".join(error.args[1])
    return None


def main():
    if cycle(MAY_INCLUDE):
        print(f"include rules: a cycle of rooms, {cycle(MAY_INCLUDE)}")
        return 1
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    found = breaches(root) + system_breaches(root)
    for path, number, text in found:
        print(f"{path}:{number}: {text}")
    print(f"include rules: {len(found)} breaches in {len(list(root.glob('cpp/**/*.[hc]*')))} files")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
