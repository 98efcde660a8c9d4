# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the settings of a fresh FreeCAD that asks nothing at its start. As a program, for the pictures:

    fresh_profile.py FOLDER [Dark|Light]
"""
import glob
import os
import sys
import xml.etree.ElementTree as Tree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


def _groups(names, settings):
    """Settings in nested groups, as a tree that add() takes."""
    opened = "".join('<FCParamGroup Name="{}">'.format(name) for name in ["Root"] + names)
    text = opened + settings + "</FCParamGroup>" * (len(names) + 1)
    return Tree.fromstring("<FCParameters>" + text + "</FCParameters>")


def _theme(name):
    """The settings of a theme of this FreeCAD: since 1.0 a pack of preferences, before a style sheet."""
    packs = glob.glob("/usr/share/freecad/**/FreeCAD {}.cfg".format(name), recursive=True)
    if packs:
        return Tree.parse(packs[0]).getroot()
    sheet = '<FCText Name="StyleSheet">Behave-dark.qss</FCText>' if name == "Dark" else ""
    return _groups(["BaseApp", "Preferences", "MainWindow"], sheet)


def _docked():
    """The task panel beside the 3D view, not over it as in a fresh FreeCAD 1.1."""
    names = ["BaseApp", "MainWindow", "DockWindows", "OverlayRight"]
    return _groups(names, '<FCText Name="Widgets"></FCText><FCInt Name="Width" Value="400"/>')


def _add(settings, others):
    """Puts other settings into the tree of a profile."""
    for other in others:
        own = [e for e in settings if (e.tag, e.get("Name")) == (other.tag, other.get("Name"))]
        if own and other.tag == "FCParamGroup":
            _add(own[0], other)
            continue
        for element in own:
            settings.remove(element)
        settings.append(other)


def write(home, theme="", docked=False):
    """Writes user.cfg into the folder that FREECAD_USER_HOME is to name. theme: "Dark", "Light" or
    FreeCAD's own (""). docked: the task panel does not cover the 3D view."""
    tree = Tree.parse(os.path.join(ROOT, "resources", "demo-user.cfg"))
    if theme:
        _add(tree.getroot(), _theme(theme))
    if docked:
        _add(tree.getroot(), _docked())
    tree.write(os.path.join(home, "user.cfg"), encoding="utf-8", xml_declaration=True)


if __name__ == "__main__":
    write(*sys.argv[1:], docked=True)
