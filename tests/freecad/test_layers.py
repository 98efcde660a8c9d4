# SPDX-License-Identifier: LGPL-2.1-or-later
"""The direction of imports inside the workbench (docs: sweptvolume/__init__.py)."""
import ast
import glob
import os
import unittest

import sweptvolume

HERE = os.path.dirname(os.path.realpath(sweptvolume.__file__))
#: From the lowest layer up; a module may import what stands above its own group in this list.
ORDER = [
    ["texts", "settings", "safe_file", "quantities", "interpreter"],
    ["core_texts", "core_search"],
    ["core", "body"],
    ["core_install", "core_overlap", "core_paths", "core_previews", "meshes", "studies", "targets"],
    ["apart"],
    ["convert", "joined"],
    ["contents"],
    ["trajectory"],
    ["features"],
    ["export", "page", "runner", "demo_parts"],
    ["reading"],
    ["views", "demo"],
    ["panels"],
    ["commands", "demo_run"],
]
GUI_FROM = ORDER.index(["views", "demo"])
LEVEL = {name: i for i, names in enumerate(ORDER) for name in names}


def imports(path):
    """Yields (module, node) for each module that is imported; relative imports are made
    absolute."""
    package = os.path.relpath(os.path.dirname(path), HERE).replace(os.sep, ".").strip(".")
    with open(path, encoding="utf-8") as file:
        tree = ast.parse(file.read())
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield alias.name, node
        elif isinstance(node, ast.ImportFrom):
            if not node.level:
                yield node.module, node
                continue
            base = [p for p in package.split(".") if p]
            base = base[: len(base) - (node.level - 1)]
            parts = base + ([node.module] if node.module else [])
            if parts:
                yield "sweptvolume." + ".".join(parts), node
            else:
                for alias in node.names:
                    yield "sweptvolume." + alias.name, node


def modules():
    for path in sorted(glob.glob(os.path.join(HERE, "**", "*.py"), recursive=True)):
        group = os.path.relpath(path, HERE).split(os.sep)[0].replace(".py", "")
        if group != "__init__":
            yield path, group


def names_in(module):
    """Returns the names that a module of the workbench defines, including the modules below a package;
    None for other modules."""
    parts = module.split(".")
    if parts[0] != "sweptvolume":
        return None
    place = os.path.join(HERE, *parts[1:])
    found = set()
    if os.path.isdir(place):
        found = {name.replace(".py", "") for name in os.listdir(place)}
        place = os.path.join(place, "__init__")
    with open(place + ".py", encoding="utf-8") as file:
        top = list(ast.parse(file.read()).body)
    while top:
        node = top.pop()
        if isinstance(node, (ast.If, ast.Try, ast.With)):
            top += node.body + getattr(node, "orelse", [])
            top += [n for handler in getattr(node, "handlers", []) for n in handler.body]
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found.add(node.name)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            found |= {(alias.asname or alias.name).split(".")[0] for alias in node.names}
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found |= {n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)}
    return found


def _is_set(name):
    return isinstance(name.ctx, ast.Store)


class Layers(unittest.TestCase):
    def test_every_module_has_a_place(self):
        for path, group in modules():
            self.assertIn(group, LEVEL, path)

    def test_nothing_imports_upwards(self):
        for path, group in modules():
            for name, node in imports(path):
                parts = name.split(".")
                if parts[0] == "sweptvolume" and len(parts) > 1 and parts[1] in LEVEL:
                    text = "{}:{} imports {}".format(path, node.lineno, name)
                    self.assertLessEqual(LEVEL[parts[1]], LEVEL[group], text)

    def test_what_is_imported_is_there(self):
        """All names exist, also in code that no test without a window runs."""
        for path, _ in modules():
            for name, node in imports(path):
                if not isinstance(node, ast.ImportFrom) or node.module is None:
                    continue  # imports modules, not names of a module
                known = names_in(name)
                for alias in node.names if known is not None else ():
                    text = "{}:{} {} has no {}".format(path, node.lineno, name, alias.name)
                    self.assertIn(alias.name, known, text)

    def test_what_is_asked_of_a_module_is_there(self):
        """Each `module.name` in the code exists, where `module` was imported from a package of the
        workbench."""
        for path, _ in modules():
            with open(path, encoding="utf-8") as file:
                tree = ast.parse(file.read())
            known = {}
            for name, node in imports(path):
                for alias in node.names if isinstance(node, ast.ImportFrom) else ():
                    module = name if node.module is None else name + "." + alias.name
                    file = os.path.join(HERE, *module.split(".")[1:]) + ".py"
                    if module.startswith("sweptvolume.") and os.path.isfile(file):
                        if module.endswith("." + alias.name):
                            known[alias.asname or alias.name] = names_in(module)
            stored = {n.id for n in ast.walk(tree) if isinstance(n, ast.Name) and _is_set(n)}
            stored |= {n.arg for n in ast.walk(tree) if isinstance(n, ast.arg)}
            for node in ast.walk(tree):
                if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                    here = node.value.id
                    if here in known and here not in stored and not node.attr.startswith("__"):
                        text = "{}:{} {}.{}".format(path, node.lineno, here, node.attr)
                        self.assertIn(node.attr, known[here], text)

    def test_what_starts_processes_is_not_loaded_with_the_workbench(self):
        """Only code that runs a study imports `studies` at its top."""
        found = {
            os.path.relpath(path, HERE).replace(os.sep, "/")
            for path, _ in modules()
            for name, node in imports(path)
            if name == "sweptvolume.studies" and node.col_offset == 0
        }
        self.assertEqual(found, {"features/study_import.py", "panels/study_tasks.py"})

    def test_gui_only_in_views_panels_commands(self):
        for path, group in modules():
            for name, node in imports(path):
                root = name.split(".")[0]
                text = "{}:{} imports {}".format(path, node.lineno, name)
                if root in ("FreeCADGui", "pivy"):
                    self.assertGreaterEqual(LEVEL[group], GUI_FROM, text)
                self.assertNotIn(root, ("PySide2", "PySide6"), text)

    def test_only_core_knows_the_compiled_module(self):
        for path, group in modules():
            with open(path, encoding="utf-8") as file:
                if group != "core_search":
                    self.assertNotIn('import_module("_swept")', file.read(), path)
            for name, _ in imports(path):
                self.assertNotEqual(name.split(".")[0], "_swept", path)
