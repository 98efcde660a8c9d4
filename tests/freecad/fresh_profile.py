# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes settings with which a fresh FreeCAD asks no questions at its start. As a program, for the pictures:

    fresh_profile.py FOLDER [Dark|Light]
"""
import glob
import os
import sys
import xml.etree.ElementTree as Tree

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


def _groups(names, settings):
    """Returns settings in nested groups, as a tree for _add()."""
    opened = "".join('<FCParamGroup Name="{}">'.format(name) for name in ["Root"] + names)
    text = opened + settings + "</FCParamGroup>" * (len(names) + 1)
    return Tree.fromstring("<FCParameters>" + text + "</FCParameters>")


def _theme(name):
    """Returns the settings of a theme: a pack of preferences since FreeCAD 1.0, a style sheet before."""
    packs = glob.glob("/usr/share/freecad/**/FreeCAD {}.cfg".format(name), recursive=True)
    if packs:
        return Tree.parse(packs[0]).getroot()
    sheet = '<FCText Name="StyleSheet">Behave-dark.qss</FCText>' if name == "Dark" else ""
    return _groups(["BaseApp", "Preferences", "MainWindow"], sheet)


def _docked():
    """Returns the settings that put the task panel beside the 3D view. In a fresh FreeCAD 1.1 it covers
    the view."""
    names = ["BaseApp", "MainWindow", "DockWindows", "OverlayRight"]
    return _groups(names, '<FCText Name="Widgets"></FCText><FCInt Name="Width" Value="400"/>')


def _add(settings, others):
    """Adds settings to the tree of a profile; existing ones are replaced."""
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
