# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of a solid, before it is made or written to a file: tolerance, limits of faces and
megabytes, estimate, run."""
import os

from PySide import QtCore

from .. import core, export, quantities, targets
from ..features import solid
from ..texts import translate
from . import focus, guard, tasks, widgets
from .background_estimate import BackgroundEstimate
from .run_panel import StartPanel
from .widgets import QtWidgets

#: Time (ms) from the last change to a new estimate.
ESTIMATE_DELAY = 250

#: The panel opened last, for tests and macros. FreeCAD does not give access to it.
opened = []


class SolidPanel(StartPanel):
    """Creates the solid of `source` (or converts obj again), or writes it to a path."""

    def __init__(self, source, obj=None, path=""):
        self.mesh = solid.request_for(source, world=bool(path))
        self.document, self.source, self.obj, self.path = source.Document, source, obj, path
        self.run, self.buttons = None, []
        self.background = BackgroundEstimate(
            self.document, self.show_estimate, self.report_estimate
        )
        values = solid.settings(obj) if obj is not None else solid.first_settings(source)
        if path:
            head = translate("SweptVolume", "Export envelope"), "SweptVolume_Export"
        else:
            head = translate("SweptVolume", "Make solid"), "SweptVolume_Solid"
        self.form, self.layout = widgets.window(*head)
        self.box, self.message = widgets.RunBox(), widgets.message_label()
        for widget in (self.box, self.message):
            self.layout.addWidget(widget)
        self._build(values)
        self.layout.addStretch(1)
        self.timer = QtCore.QTimer(self.form)
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(self.estimate)
        self.timer.start(0)

    def _build(self, values):
        rows = widgets.group(translate("SweptVolume", "Solid"), self.layout)
        self.fields = rows.parentWidget()
        self.merge = widgets.check_box(
            translate("SweptVolume", "Merge coplanar"),
            values["merge"],
            translate("SweptVolume", "Merges adjacent coplanar triangles into one flat face"),
        )
        self.tolerance = widgets.length(values["tolerance"])
        self.tolerance.setObjectName("SweptVolumeSolidTolerance")
        widgets.hint(
            self.tolerance,
            translate(
                "SweptVolume",
                "Largest deviation from the mesh to aim at. Not guaranteed: the "
                "property Deviation of the solid is the measured value. 0: exact, unless Max "
                "faces requires a tolerance",
            ),
        )
        self.faces = QtWidgets.QSpinBox()
        self.faces.setObjectName("SweptVolumeMaxFaces")
        self.faces.setRange(0, 999999999)
        self.faces.setSingleStep(1000)
        self.faces.setGroupSeparatorShown(True)
        self.faces.setValue(values["max_faces"])
        widgets.hint(
            self.faces,
            translate(
                "SweptVolume",
                "Largest number of faces of the solid. If the tolerance is 0 and the exact solid "
                "would have more faces, the solid is simplified with the smallest tolerance that "
                "is enough",
            ),
        )
        self.megabytes = QtWidgets.QDoubleSpinBox()
        self.megabytes.setObjectName("SweptVolumeMaxMegabytes")
        self.megabytes.setRange(0, 1e9)
        self.megabytes.setSuffix(" MB")
        self.megabytes.setSpecialValueText(translate("SweptVolume", "no limit"))
        self.tessellated = QtWidgets.QCheckBox(translate("SweptVolume", "Tessellated (AP242)"))
        self.tessellated.setObjectName("SweptVolumeTessellated")
        widgets.hint(
            self.tessellated,
            translate(
                "SweptVolume",
                "Writes the triangles themselves instead of faces. This is exact and fast, and "
                "there is no limit on the number of triangles. Only programs that read "
                "tessellated STEP can open the file: FreeCAD 1.1 can, FreeCAD 0.20 cannot",
            ),
        )
        step = self.path.lower().endswith((".step", ".stp"))
        if step and core.available() and core.has_solids():
            rows.addRow(self.tessellated)
        rows.addRow(self.merge)
        rows.addRow(translate("SweptVolume", "Tolerance"), self.tolerance)
        rows.addRow(translate("SweptVolume", "Max faces"), self.faces)
        if self.path:
            rows.addRow(translate("SweptVolume", "Max file size"), self.megabytes)
            where = QtWidgets.QLabel(os.path.basename(self.path))
            widgets.hint(where, self.path)
            rows.addRow(translate("SweptVolume", "File"), where)
            written = self.what_is_written()
            if written:
                note = QtWidgets.QLabel(written)
                note.setObjectName("SweptVolumeWritten")
                note.setWordWrap(True)
                rows.addRow(note)
        self.expected = QtWidgets.QLabel()
        self.expected.setObjectName("SweptVolumeSolidEstimate")
        self.expected.setWordWrap(True)
        rows.addRow(self.expected)
        self.merge.toggled.connect(self._changed)
        self.tessellated.toggled.connect(self._kind_changed)
        for field in (self.tolerance, self.faces, self.megabytes):
            field.valueChanged.connect(self._changed)

    def what_is_written(self):
        """Returns what the file contains, if people may expect something else."""
        found = []
        if self.obj is not None:
            text = translate(
                "SweptVolume",
                'The file gets a new solid, made from the mesh of "{0}". The stored solid is not '
                "used.",
            )
            found.append(text.format(self.source.Label))
        found.append(export.outdated_note(self.source))
        return " ".join(filter(None, found))

    def settings(self):
        """Returns the settings, as a dict like features.solid.DEFAULTS."""
        return {
            "merge": self.merge.isChecked(),
            "tolerance": float(self.tolerance.property("rawValue")),
            "max_faces": self.faces.value(),
            "max_megabytes": self.megabytes.value(),
            "tessellated": self.tessellated.isChecked(),
        }

    # --- estimate

    def _kind_changed(self, tessellated):
        for field in (self.merge, self.tolerance, self.faces):
            field.setEnabled(not tessellated)
        self._changed()

    def _changed(self, *ignored):
        """Removes an estimate that belongs to other settings."""
        self.background.stop()
        widgets.show_message(self.expected, translate("SweptVolume", "Estimating the solid ..."))
        self.timer.start(ESTIMATE_DELAY)

    def estimate(self):
        """Starts the estimate."""
        if self.run is not None or not widgets.alive(self.document):
            return
        try:
            guard.check_fields(self.form)
            suffix = os.path.splitext(self.path)[1].lstrip(".").lower() or "brep"
            self.background.want(*self.mesh.with_settings(self.settings()).estimates(suffix))
        except Exception as problem:
            guard.show_problem(self.expected, problem)

    def report_estimate(self, text):
        widgets.show_message(self.expected, text)

    def show_estimate(self, found):
        if found["tried"]:
            text = translate("SweptVolume", "{0} triangles: {1} faces,\nabout {2}, {3}")
        else:
            text = translate(
                "SweptVolume", "{0} triangles: at most {1} faces,\nup to about {2}, {3}"
            )
        text = text.format(
            quantities.count(found["triangles"]),
            quantities.count(found["faces"]),
            quantities.megabytes(found["megabytes"] * 1e6),
            quantities.seconds(found["seconds"]),
        )
        if self.background.has_more():
            text += "\n" + translate("SweptVolume", "Estimating the solid ...")
        elif found["tried"] and found["tolerance"] > 0 and not self.settings()["tolerance"]:
            asked = translate("SweptVolume", "A tolerance of {0} is needed to meet the limits")
            text += "\n" + asked.format(quantities.quantity(found["tolerance"]))
        widgets.show_message(self.expected, text)

    # --- run

    def task(self):
        if self.path:
            return tasks.ExportTask(self.source, self.path, self.settings())
        return tasks.SolidTask(self.document, self.source, self.obj, self.settings())

    def start(self):
        # Otherwise the estimate would do the same work at the same time as the run.
        self.timer.stop()
        self.background.stop()
        if self.begin(self.task, self.ended):
            self._enable(False)
        else:
            self._changed()

    def _enable(self, on):
        self.fields.setEnabled(on)
        self.enable_buttons(on)

    def ended(self, run):
        self.run = None
        if run.state == "ok" or not widgets.alive(self.document):
            self._close()
            return
        self._enable(True)
        self._changed()
        self.box.leave(self.form)
        widgets.show_failure(self.message, run)

    def _close(self):
        self.timer.stop()
        self.background.stop()
        self.close_dialog()
        return True


def show(source, obj=None, path=""):
    """Opens the panel. obj: the solid to convert again; path: the STEP or BREP file to write.
    Raises InputProblem."""
    if path:
        export.check_target(path)
        targets.check_not_read(path)
    panel = SolidPanel(source, obj, path)
    opened[:] = [panel]
    focus.show(panel)
    return panel
