# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD without the core: the workbench offers to install it and says what it downloads. The installation
can be stopped and does not freeze the window. Afterwards the workbench computes, also after a restart.
"""
import glob
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]
from driver import (  # noqa: E402
    App,
    Gaps,
    Gui,
    Ok,
    QtWidgets,
    click,
    find,
    new_document,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    shot,
)
from package_index import Index, make_wheel  # noqa: E402

AGAIN = """
import os, sys
from sweptvolume import core, core_search
core_search.searched_first = lambda: []
print("found:" + core.module().__file__, flush=True)
os._exit(0)
"""


def button(name):
    return find(QtWidgets.QPushButton, "SweptVolumeCore" + name)


def text(name):
    return find(QtWidgets.QLabel, "SweptVolumeCore" + name).text()


def in_folder(folder):
    return sorted(os.path.basename(path) for path in glob.glob(os.path.join(folder, "*")))


def start_again():
    """Returns the core that another FreeCAD with the same profile finds."""
    with tempfile.NamedTemporaryFile("w", suffix=".py") as script:
        script.write(AGAIN)
        script.flush()
        done = subprocess.run(
            ["freecadcmd", script.name], stdin=subprocess.DEVNULL, capture_output=True, text=True
        )
    return done.stdout.split("found:")[-1].strip()


def scenario():
    import sweptvolume
    from sweptvolume import core, core_install, core_search, runner
    from sweptvolume.features import envelope, motion
    from sweptvolume.panels import core_dialog, envelope_panel

    build = core_search.searched_first()[-1]
    given = os.environ.pop("SWEPT_CORE", None)
    build = given or build
    core_search.searched_first = lambda: []
    os.environ["PYTHONPATH"] = ""
    served = tempfile.mkdtemp()
    index = Index(served)
    for name in ("PIP_FIND_LINKS", "PIP_NO_INDEX", "PIP_EXTRA_INDEX_URL"):
        os.environ.pop(name, None)
    os.environ.update(index.environment())
    folder = core_install.target()
    assert folder.startswith(os.environ["FREECAD_USER_HOME"]), folder

    # When the workbench is opened, it offers the core and says what it would download, and from where.
    open_workbench()
    yield lambda: core_dialog.opened is not None
    yield lambda: index.address in text("Source")
    package = "swept-volume, version {}, for Python {}.{}"
    assert text("Package") == package.format(sweptvolume.__version__, *sys.version_info[:2])
    assert text("Folder") == folder and "not installed" in text("State")
    assert index.requests == [], "the index was asked before the user wanted it"
    default, published = core_install.DEFAULT_INDEX, core_install.PUBLISHED
    assert ("not published" in core_dialog.source_text(default)) == (not published)
    assert core_dialog.source_text(index.address) == index.address
    shot("80_core_offer")
    yield 0.6

    # The index has no core: a message says so, and no files are left behind.
    click(button("Install"))
    yield lambda: "There is no core of version" in text("Message") if no_run() else False
    assert in_folder(folder) == [], in_folder(folder)
    shot("81_core_not_there")
    yield 0.6

    # A slow download is stopped; the window responds meanwhile.
    make_wheel(build, sweptvolume.__version__, served)
    index.may_download.clear()
    gaps = Gaps()
    click(button("Install"))
    yield lambda: any(path.endswith(".whl") for path in index.requests)
    yield 0.5
    shot("82_core_download")
    yield 0.6
    assert not button("Install").isEnabled() and not button("Close").isEnabled()
    click(button("Stop"))
    yield no_run
    gaps.stop()
    assert gaps.busy < 0.2, gaps.busy
    assert "Nothing was changed" in text("Message"), text("Message")
    assert in_folder(folder) == [] and not core.available()
    index.may_download.set()

    # A panel without the core offers it as well, and works as soon as it is installed.
    click(button("Close"))
    yield lambda: core_dialog.opened is None
    doc = new_document("Install")
    box = doc.addObject("Part::Box", "Box")
    path = motion.make_motion(doc)
    path.Placements = [App.Placement(), App.Placement(App.Vector(30, 0, 0), App.Rotation())]
    path.Times = [0.0, 1.0]
    doc.recompute()
    select(box, path)
    Gui.runCommand("SweptVolume_Envelope")
    yield 0.6
    assert "Install the core" in envelope_panel.opened[-1].estimate_label.text()
    click(panel_button(Ok))
    yield lambda: core_dialog.opened is not None
    yield lambda: index.address in text("Source")
    click(button("Install"))
    yield no_run
    assert "You can use the workbench now" in text("Message"), text("Message")
    assert core.module().__file__.startswith(folder), core.module().__file__
    shot("83_core_installed")
    yield 0.6
    click(button("Close"))
    yield lambda: core_dialog.opened is None
    click(panel_button(Ok))
    yield lambda: not runner.running() and no_panel()
    hulls = [o for o in doc.Objects if envelope.is_envelope(o)]
    assert len(hulls) == 1 and hulls[0].Mesh.CountFacets > 100, hulls

    # After the installation it is not offered again, and another start of FreeCAD finds it.
    Gui.runCommand("SweptVolume_InstallCore")
    yield 0.3
    assert "is installed" in text("State") and not button("Install").isEnabled()
    click(button("Close"))
    yield lambda: core_dialog.opened is None
    assert start_again().startswith(folder), start_again()

    # A file of another version is refused, and so is a file that is no core; the message names it.
    other = make_wheel(build, "0.0.7", served)
    for path, expected in ((other, "0.0.7"), (__file__, "cannot be read")):
        installation = core_install.Installation(path)
        installation.start()
        yield lambda: not installation.is_alive()
        assert expected in installation.problem, installation.problem
    App.closeDocument(doc.Name)
    yield


def no_run():
    from sweptvolume.panels import core_dialog

    return core_dialog.opened is not None and core_dialog.opened.run is None


run(scenario)
