#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists the tests of each kind of bad input, one row of docs/bad_input.md each.

Bad input can reach the core in four ways: through C++, Python, the program or FreeCAD. Each row must be
tested in all four. The name of a test has the number of its row. The code of the test and of its fixtures
shows which ways it takes. Ways that do not exist for a row are listed in the document, with the reason.
Every other missing way is printed, and the exit status is then 1.

Usage: bad_input_rows.py [--write]
--write: writes the names of the tests into the document.
"""
import ast
import pathlib
import re
import sys

#: Functions of the module that only make inputs for the program.
INPUTS = {"write_mesh", "read_mesh", "__file__", "__version__", "HAS_SOLIDS"}
WAYS = ("C++", "Python", "program", "FreeCAD")


def rows_of(name):
    """Returns the rows of the table that the name of a test mentions."""
    match = re.match(r"(?:test_)?(?:bad_input_|BadInput)(\d\d)(?:(?:_and_|And)(\d\d))?", name)
    return [int(number) for number in match.groups() if number] if match else []


def own_ways(function, scripts):
    """Returns what the code of a function tests: the Python module (calls that only make inputs do
    not count), the program, or both."""
    nodes = list(ast.walk(function))
    attributes = [n for n in nodes if isinstance(n, ast.Attribute)]
    used = {n.attr for n in attributes if ast.unparse(n.value) == "_swept"}
    names = {n.id for n in nodes if isinstance(n, ast.Name)} | {a.arg for a in function.args.args}
    ways = {"Python"} if used - INPUTS or names & scripts else set()
    return ways | ({"program"} if "program" in names else set())


def python_tests(path):
    """Returns (name, ways) of the tests of bad input in a file. The ways of its fixtures count as ways of
    the test."""
    tree = ast.parse(path.read_text(encoding="utf-8")).body
    if path.parent.name == "freecad":
        found = [n for c in tree if isinstance(c, ast.ClassDef) for n in c.body]
        found = [n.name for n in found if isinstance(n, ast.FunctionDef)]
        return [(name, {"FreeCAD"}) for name in found if name.startswith("test_bad_input_")]
    functions = {f.name: f for f in tree if isinstance(f, ast.FunctionDef)}
    # Scripts that tests run in a separate process.
    texts = [
        n for n in tree if isinstance(n, ast.Assign) and "import _swept" in ast.unparse(n.value)
    ]
    scripts = {n.targets[0].id for n in texts}

    def ways(name):
        fixtures = [a.arg for a in functions[name].args.args if a.arg in functions]
        return own_ways(functions[name], scripts).union(*map(ways, fixtures))

    return [(name, ways(name)) for name in functions if name.startswith("test_bad_input_")]


def tests(root):
    """Returns {row: {way: [names]}} of all tests."""
    found = {}
    for path in sorted((root / "tests").rglob("*")):
        if path.suffix == ".cpp":
            text = path.read_text(encoding="utf-8")
            names = re.findall(r"^TEST(?:_[FP])?\(\s*\w+,\s*(\w+)\)", text, re.M)
            named = [(name, {"C++"}) for name in names]
        elif path.suffix == ".py":
            named = python_tests(path)
        else:
            continue
        for name, ways in named:
            for row in rows_of(name):
                for way in ways:
                    names = found.setdefault(row, {}).setdefault(way, [])
                    if name not in names:
                        names.append(name)
    return found


def write(root):
    """Writes the names of the tests into the last column of the table."""
    path, found = root / "docs/bad_input.md", tests(root)
    lines = path.read_text(encoding="utf-8").split("\n")
    for n, line in enumerate(lines):
        row = re.match(r"\| (\d+) \|", line)
        if row:
            ways_of = {}
            for way in WAYS:
                for name in found.get(int(row[1]), {}).get(way, []):
                    ways_of.setdefault(name, []).append(way)
            groups = {}
            for name, ways in ways_of.items():
                groups.setdefault(", ".join(ways), []).append(f"`{name}`")
            text = "; ".join(f"{ways}: " + ", ".join(names) for ways, names in groups.items())
            lines[n] = f"{line.rsplit(' | ', 1)[0]} | {text} |"
    path.write_text("\n".join(lines), encoding="utf-8")


def out_of_reach(root):
    """Returns {way: rows}: the rows that cannot be tested in this way, according to the document."""
    text = (root / "docs/bad_input.md").read_text(encoding="utf-8")
    lists = re.findall(r"^- \*\*Not through ([^:*]+):\*\* ((?:\d+[, ]*)+)", text, re.M)
    rows = {way: set() for way in WAYS}
    for ways, numbers in lists:
        for way in ways.replace(" and ", ", ").split(", "):
            rows[way] |= {int(n) for n in re.findall(r"\d+", numbers)}
    return rows


def gaps(root):
    """Returns each (row, way) without a test, and each with a test although the document says that
    there can be none."""
    found, unreachable = tests(root), out_of_reach(root)
    return [
        (row, way)
        for row in range(1, 46)
        for way in WAYS[1:]
        if (way in found.get(row, {})) == (row in unreachable[way])
    ]


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    if "--write" in sys.argv[1:]:
        write(root)
    found, unreachable = tests(root), out_of_reach(root)
    print("row  " + "".join(f"{way:>9}" for way in WAYS))
    for row in range(1, 46):
        counts = [
            len(found.get(row, {}).get(way, [])) or ("-" if row in unreachable[way] else "none")
            for way in WAYS
        ]
        print(f"{row:3}  " + "".join(f"{count:>9}" for count in counts))
    missing = gaps(root)
    for row, way in missing:
        print(
            f"row {row}: "
            + ("tested" if row in unreachable[way] else "no test")
            + f" through {way}"
        )
    print(f"{len(missing)} gaps; '-': cannot be reached that way (docs/bad_input.md)")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
