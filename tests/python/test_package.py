# SPDX-License-Identifier: LGPL-2.1-or-later
"""package.xml: what FreeCAD reads from it, and what the Addon Manager requires."""
import ast
import functools
import pathlib
import re
import subprocess
import sys
import types
import typing
import xml.etree.ElementTree

import pytest

import _swept

from conftest import BUILD

MANAGERS = ("/usr/share/freecad/Mod/AddonManager", "/usr/lib/freecad/Mod/AddonManager")
SPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}


def test_package_xml_names_this_project(root):
    text = (root / "package.xml").read_text(encoding="utf-8")
    space = {"p": "https://wiki.freecad.org/Package_Metadata"}
    package = xml.etree.ElementTree.fromstring(text)
    assert package.find("p:version", space).text == _swept.__version__
    for key in ("name", "date", "description", "maintainer", "license", "icon", "content"):
        assert package.find(f"p:{key}", space) is not None, key
    bench = package.find("p:content/p:workbench", space)
    name = bench.find("p:classname", space).text
    assert f"class {name}(" in (root / "InitGui.py").read_text(encoding="utf-8")
    for icon in package.iterfind(".//p:icon", space):
        assert (root / icon.text).is_file(), icon.text
    licence = package.find("p:license", space)
    assert licence.text == "LGPL-2.1-or-later" and (root / licence.get("file")).is_file()


def test_freecad_reads_package_xml(root):
    folder = "/usr/lib/freecad-python3/lib"
    script = (
        f"import sys; sys.path.append({folder!r})\n"
        "try:\n    import FreeCAD\nexcept ImportError as error:\n    print(error); sys.exit(77)\n"
        f"data = FreeCAD.Metadata({str(root / 'package.xml')!r})\n"
        "bench = data.Content['workbench'][0]\n"
        "assert data.Name == 'Swept Volume' and data.supportsCurrentFreeCAD()\n"
        "assert bench.Classname == 'SweptVolumeWorkbench', bench.Classname\n"
        "assert bench.Subdirectory == './' and data.Maintainer and data.License and data.Icon\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    if done.returncode == 77:
        pytest.skip(f"FreeCAD is not installed: {done.stdout}")
    assert done.returncode == 0, done.stdout + done.stderr


def complaints(text):
    """Returns the messages of the developer checks of FreeCAD's Addon Manager about a package.xml.
    Their file also contains windows, so only the checks are taken from it. Nothing uses the network.
    """
    files = [p for folder in MANAGERS for p in sorted(pathlib.Path(folder).glob("*.py"))]
    sources = [p.read_text(encoding="utf-8") for p in files]
    source = next((s for s in sources if "def validate_package_xml(" in s), None)
    if source is None:
        pytest.skip("no manager of add-ons with checks in " + " or ".join(MANAGERS))
    checks = [
        node
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.FunctionDef) and node.name.startswith("validate_")
    ]
    messages = []
    page = types.SimpleNamespace(data=lambda: b"<html>")
    console = types.SimpleNamespace(PrintLog=messages.append, PrintError=messages.append)
    names = {
        "FreeCAD": types.SimpleNamespace(Console=console),
        "NetworkManager": types.SimpleNamespace(
            AM_NETWORK_MANAGER=types.SimpleNamespace(blocking_get=lambda location: page)
        ),
        "List": typing.List,
        "Addon": object,
        "Metadata": object,
    }
    manager = types.SimpleNamespace()
    for node in checks:
        alone, node.decorator_list = bool(node.decorator_list), []
        exec(compile(ast.Module([node], []), "AddonManager", "exec"), names)
        check = names[node.name]
        setattr(manager, node.name, check if alone else functools.partial(check, manager))
    manager.validate_package_xml(types.SimpleNamespace(metadata=read(text), name="it"))
    return {line.strip(" *\n") for line in messages[1:]}


class Record(dict):
    """A record as the Addon Manager's readers give it: those of FreeCAD 0.20 (Name,
    entry["name"]) and of 1.0 (name)."""

    def __getattr__(self, name):
        return self[name.lower().replace("urls", "url")]


def read(text):
    """Returns a package.xml as FreeCAD's reader gives it to the Addon Manager."""
    package = xml.etree.ElementTree.fromstring(text)
    one = lambda element, key: element.findtext(f"p:{key}", "", SPACE)  # noqa: E731
    every = lambda key: package.iterfind(f"p:{key}", SPACE)  # noqa: E731
    return Record(
        {key: one(package, key) for key in ("name", "version", "description", "icon")},
        maintainer=[Record(name=m.text, email=m.get("email", "")) for m in every("maintainer")],
        license=[Record(name=item.text) for item in every("license")],
        url=[
            Record(type=u.get("type"), location=u.text, branch=u.get("branch", ""))
            for u in every("url")
        ],
        content={
            "workbench": [
                Record(classname=one(bench, "classname"), icon=one(bench, "icon"))
                for bench in package.iterfind("p:content/p:workbench", SPACE)
            ]
        },
    )


def test_the_manager_of_addons_misses_nothing_but_addresses(root):
    """The project has no public address yet, and must not name a false one."""
    text = (root / "package.xml").read_text(encoding="utf-8")
    assert "example.org" not in text and "<url" not in text
    assert complaints(text) == {
        "No email address specified for maintainer 'The Swept Volume maintainers'",
        "No <url> elements found, at least a repo url must be provided",
    }


def test_with_addresses_the_manager_of_addons_misses_nothing(root):
    text = (root / "package.xml").read_text(encoding="utf-8")
    text = text.replace("<maintainer>", '<maintainer email="somebody@somewhere.test">')
    place = "https://somewhere.test/it"
    text = text.replace(
        "  <icon>",
        f'  <url type="repository" branch="main">{place}</url>\n'
        f'  <url type="readme">{place}/README.md</url>\n  <icon>',
        1,
    )
    assert complaints(text) == set()


def test_the_plug_ins_that_draw_icons_are_named(root):
    """Without these plug-ins, FreeCAD with Qt 6 has buttons without icons. cpack recommends them in the
    package, and the installation page names them."""
    text = (BUILD / "CPackConfig.cmake").read_text(encoding="utf-8")
    recommended = re.search(r'set\(CPACK_DEBIAN_PACKAGE_RECOMMENDS "(.*)"\)', text)[1].split(", ")
    assert "qt6-svg-plugins" in recommended and "freecad" in recommended, recommended
    assert "`qt6-svg-plugins`" in (root / "README.md").read_text(encoding="utf-8")
