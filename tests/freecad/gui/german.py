# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window in German: menu, demo and panels. Also: a document is closed while a panel is open."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from driver import (  # noqa: E402
    App,
    Cancel,
    Gui,
    QtWidgets,
    click,
    find,
    no_panel,
    open_workbench,
    panel_button,
    run,
    select,
    shot,
)


def texts_of_panel():
    """Returns the texts of all labels, buttons and titles of the open panel."""
    found = []
    for kind, read in (
        (QtWidgets.QLabel, "text"),
        (QtWidgets.QAbstractButton, "text"),
        (QtWidgets.QGroupBox, "title"),
    ):
        widgets = Gui.getMainWindow().findChildren(kind)
        found += [getattr(w, read)().replace("&", "") for w in widgets if w.isVisible()]
    return found


def scenario():
    from sweptvolume import core, page, runner
    from sweptvolume.features import clearance, envelope
    from sweptvolume.panels import motion_panel

    Gui.setLocale("German")
    open_workbench()
    yield
    Gui.runCommand("SweptVolume_Demo")
    yield 1.0
    doc = App.ActiveDocument
    starter, path = doc.getObject("Starter"), doc.getObject("Motion")
    assert starter is not None and path.Count == 12
    assert starter.Label == "Anlasser" and path.Label == "Einbaubahn"
    checked = clearance.make_clearance(doc, MovingParts=[starter], Motion=path)
    doc.recompute()
    clearance.compute(checked)
    text = page.text(page.request(checked), core.Control())
    assert '<html lang="de"' in text and "Urteile" in text and " Dreiecke<" in text
    doc.removeObject(checked.Name)
    doc.recompute()
    menus = [action.text() for action in Gui.getMainWindow().menuBar().actions()]
    assert "Überstri&chener Raum" in menus, menus
    for name, items, expected in (
        ("EditMotion", (starter, path), ("Art der Lage", "Aufnehmen")),
        ("Envelope", (starter, path), ("Genauigkeit",)),
        ("Clearance", (starter, path), ("Sollabstand",)),
    ):
        select(*items)
        Gui.runCommand("SweptVolume_" + name)
        yield 0.8
        Gui.Selection.clearSelection()
        shot("70_german_" + name)
        yield 0.8
        texts = texts_of_panel()
        for text in expected:
            assert any(text in line for line in texts), (text, texts)
        click(panel_button(Cancel if name != "Clearance" else QtWidgets.QDialogButtonBox.Close))
        yield no_panel

    hull = envelope.make_envelope(doc, [starter], path, Resolution=32)
    envelope.compute(hull)
    select(hull)
    Gui.runCommand("SweptVolume_Solid")
    yield
    label = find(QtWidgets.QLabel, "SweptVolumeSolidEstimate")
    yield lambda: "Dreiecke" in label.text()
    Gui.Selection.clearSelection()
    shot("70_german_Solid")
    yield 0.8
    assert "Max. Flächen" in texts_of_panel()
    click(panel_button(Cancel))
    yield no_panel

    # Reserved spaces, and the result of a check with its player.
    block = doc.getObject("Engine") or starter
    select(hull, block)
    Gui.runCommand("SweptVolume_Overlap")
    yield 0.3
    click(find(QtWidgets.QPushButton, "SweptVolumeCheckSpaces"))
    yield lambda: any("Geprüfte Paare" in line for line in texts_of_panel())
    yield 0.3
    shot("70_german_Overlap")
    yield 0.8
    assert "Gemeinsames Volumen behalten" in texts_of_panel()
    click(panel_button(QtWidgets.QDialogButtonBox.Close))
    yield no_panel
    checked = clearance.make_clearance(doc, Envelope=hull)
    doc.recompute()
    clearance.compute(checked)
    select(checked)
    Gui.runCommand("SweptVolume_Clearance")
    yield 0.8
    shot("70_german_places")
    yield 0.8
    for text in ("Nächstschlimmste Stelle", "Kollisionsvolumen behalten"):
        assert text in texts_of_panel(), texts_of_panel()
    click(panel_button(QtWidgets.QDialogButtonBox.Close))
    yield no_panel

    # Input that the core refuses: a German message, followed by the core's own sentence with the
    # numbers.
    hull.CellSize = 5000
    doc.recompute()
    select(hull)
    Gui.runCommand("SweptVolume_Recompute")
    yield lambda: not runner.running()
    yield 0.3
    text = "Die Zelle ist zu groß für das Teil: Das Teil ist kleiner als eine Zelle oder an jeder "
    text += (
        "Stelle dünner als eine Zelle. Wählen Sie eine höhere Genauigkeit (kleinerer Wert), eine "
    )
    text += "kleinere Zelle oder eine höhere Auflösung. (the cell"
    assert hull.Message.startswith(text), hull.Message
    assert any(text in line for line in texts_of_panel())
    shot("70_german_refusal")
    yield 0.8
    click(panel_button(Cancel))
    yield no_panel

    # The document is closed while the motion editor is open and its preview runs.
    select(starter, path)
    Gui.runCommand("SweptVolume_EditMotion")
    yield 0.1
    panel = motion_panel.opened[-1]
    find(QtWidgets.QPushButton, "SweptVolumeEven").click()
    App.closeDocument(doc.Name)
    yield lambda: not runner.running()
    yield no_panel
    assert panel.preview.settled()


run(scenario)
