# SPDX-License-Identifier: LGPL-2.1-or-later
"""Picture of the offer to install the core, as if it were missing."""
import types
from unittest import mock

from driver import Gui, QtWidgets, click, find

FOLDER = "/home/ann/.local/share/FreeCAD/AdditionalPythonPackages"


def offer(picture):
    """Takes the picture of the offer; a generator. picture(name): a generator that takes a picture."""
    from sweptvolume import core, core_install
    from sweptvolume.panels import core_dialog

    for owner, name, value in (
        (core, "available", lambda: False),
        (core_install, "target", lambda: FOLDER),
        (core_install, "obstacle", lambda: ""),
        (core_install, "sources", lambda: [core_install.DEFAULT_INDEX]),
        (core_dialog, "sys", types.SimpleNamespace(modules={})),
    ):
        mock.patch.object(owner, name, value).start()
    Gui.runCommand("SweptVolume_InstallCore")
    yield lambda: core_dialog.opened.lookup is None
    yield from picture("core_offer")
    click(find(QtWidgets.QPushButton, "SweptVolumeCoreClose"))
    mock.patch.stopall()
    yield lambda: core_dialog.opened is None
