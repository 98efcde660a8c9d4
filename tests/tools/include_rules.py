#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who may include whom: prints each breach as file:line and ends with 1 if there is any.

    base <- data <- stages <- pipeline <- { python, tools }

Stages never include one another; they meet in data/. Each third party is seen by one part only.
Usage: include_rules.py [ROOT]
"""
import pathlib
import re
import sys

STAGES = {"input", "sampling", "octree", "contour", "simplify", "check"}

# Part of the source tree -> parts whose headers it may include (besides its own and swept/).
MAY_INCLUDE = {
    "base": set(),
    "data": {"base"},
    **{stage: {"base", "data"} for stage in STAGES},
    "io": {"base", "data"},
    # The loop between the two: contours again where the checker found an intersection.
    "mend": {"base", "data", "contour", "check"},
    # A consumer beside the pipeline: it checks its own inputs with the same two functions.
    "clearance": {"base", "data", "input"},
    "pipeline": {"base", "data", "mend"} | STAGES,
    "step": {"base", "data", "simplify"},
    "python": {"base", "io"},
    "tools": {"base", "io"},
    "include": set(),
    # Benchmarks time single stages.
    "bench": {"base", "data", "mend", "io", "support"} | STAGES,
    "support": set(),  # tests/support
}

# Third party -> parts that may see it.
EVERYWHERE = set(MAY_INCLUDE)
THIRD_PARTIES = [
    (re.compile(r"Eigen/"), EVERYWHERE, "Eigen"),
    (re.compile(r"tbb/|oneapi/"), EVERYWHERE - {"include", "python", "tools"}, "TBB"),
    (re.compile(r"OpenMesh/"), {"io", "simplify"}, "OpenMesh"),
    (re.compile(r"zlib\.h|lzma\.h"), {"io"}, "zlib and lzma"),
    (re.compile(r"pybind11/"), {"python"}, "pybind11"),
    (re.compile(r"fcl/"), {"clearance"}, "FCL"),
    (re.compile(r"EGL/|GL/|glm/"), {"sampling/gl"}, "OpenGL"),
    (re.compile(r"[A-Za-z0-9_]+\.hxx"), {"step"}, "OpenCASCADE"),
]
BACKENDS = ("gl", "cpu", "fake")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def part_of(path, root):
    """'contour' for cpp/src/contour/..., 'tools' for cpp/tools/..., None outside of cpp."""
    parts = path.relative_to(root).parts
    if parts[0] != "cpp" or len(parts) < 3:
        return None
    return parts[2] if parts[1] == "src" else parts[1]


def breach(path, root, quoted, header):
    """What is wrong with one include, or None."""
    part = part_of(path, root)
    if part not in MAY_INCLUDE:
        return f"{part}/ is no known part; add it to tests/tools/include_rules.py"
    for pattern, allowed, name in THIRD_PARTIES:
        if not pattern.match(header):
            continue
        inner = "/".join(path.relative_to(root).parts[2:4])
        if part in allowed or inner in allowed:
            return None
        return f"{name} is not for {part}/"
    first = header.split("/")[0]
    if not quoted or "/" not in header or first in ("swept", part):
        backend = re.match(r"sampling/(\w+)/", header)
        own = path.relative_to(root).parts[3:4]
        if backend and backend[1] in BACKENDS and own != (backend[1],):
            return f"a backend ({header}) is known to itself and to pipeline/ only"
        return None
    if part == "include":
        return "public headers include only swept/ headers and Eigen"
    if first not in MAY_INCLUDE:
        return f"{first}/ is no known part; add it to tests/tools/include_rules.py"
    if first not in MAY_INCLUDE[part]:
        return f"{part}/ may not include {first}/"
    return None


def breaches(root):
    """All breaches below ROOT/cpp as (path, line number, text)."""
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


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    found = breaches(root)
    for path, number, text in found:
        print(f"{path}:{number}: {text}")
    print(f"include rules: {len(found)} breaches in {len(list(root.glob('cpp/**/*.[hc]*')))} files")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
