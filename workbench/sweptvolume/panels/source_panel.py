# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel: a motion from an object."""
import FreeCADGui as Gui

from .. import runner
from ..convert import InputProblem
from ..features import joint_motions, motion
from ..texts import translate
from ..trajectory import driven
from ..trajectory.cam import CONVENTIONS
from ..trajectory.curve import ACCURACY, ORIENTATIONS
from ..trajectory.poses import FRAME_HELP, FRAMES, INTERPOLATIONS
from ..trajectory.sources import DEFAULTS, FROM_JOINTS, Settings, frame_of, interpolation_of
from . import focus, frames_run, guard, widgets
from .widgets import QtWidgets


class SourcePanel:
    """Shows the settings of the kind of source, for a new motion (obj None) or for an existing one."""

    def __init__(self, document, kind, objects, obj=None):
        self.document, self.kind, self.objects, self.obj = document, kind, objects, obj
        self.given = dict(DEFAULTS.get(kind, {}))
        if obj is not None:
            self.given.update(motion.settings_of(obj).values)
        self.title = translate("SweptVolume", "Motion from object")
        icon_name = "SweptVolume_MotionFromSource"
        if kind == "Driven":
            self.title = translate("SweptVolume", "Motion from driving value")
            icon_name = "SweptVolume_MotionDriven"
        self.form, layout = widgets.window(self.title, icon_name)
        rows = widgets.group(", ".join(o.Label for o in objects), layout)
        self.values, self.message = {}, widgets.message_label()
        build = getattr(self, "_build_" + kind.lower(), None)
        if build is not None:
            build(rows)
        self.shown_notes = ""  # notes about the poses that were already shown
        now = (obj.Interpolation, obj.PoseType) if obj else (interpolation_of(kind), frame_of(kind))
        self.interpolation = widgets.choice(list(INTERPOLATIONS), now[0])
        self.frame = widgets.choice(FRAMES, now[1])
        self.frame.setToolTip(translate("App::Property", FRAME_HELP))
        rows.addRow(translate("SweptVolume", "Interpolation"), self.interpolation)
        rows.addRow(translate("SweptVolume", "Pose type"), self.frame)
        if self._all_parts():  # absolute: joints give placements of the parts
            self.frame.setEnabled(False)
            text = translate(
                "SweptVolume", "No part is selected: every part that moves gets a motion."
            )
            widgets.show_message(self.message, text)
        layout.addWidget(self.message)
        layout.addStretch(1)

    # --- the fields of each kind of source

    def _build_curve(self, rows):
        accuracy = widgets.length(self.given.get("accuracy", ACCURACY), 1e-4, 0.01)
        accuracy.setObjectName("SweptVolumeAccuracy")
        widgets.hint(
            accuracy,
            translate(
                "SweptVolume",
                "How far the straight line between two poses may deviate from the "
                "curve. Each corner of the curve gets a pose",
            ),
        )
        rows.addRow(translate("SweptVolume", "Accuracy"), accuracy)
        self.values["accuracy"] = lambda: float(accuracy.property("rawValue"))
        names, now = ORIENTATIONS, self.given.get("orientation", "Fixed")
        if len(self.objects) > 1:
            names, now = ["SecondCurve"], "SecondCurve"
        else:
            names = [n for n in names if n != "SecondCurve"]
        texts = {
            "Fixed": translate("SweptVolume", "Fixed"),
            "Tangent": translate("SweptVolume", "Tangent"),
            "SecondCurve": translate("SweptVolume", "Second curve"),
        }
        orientation = widgets.choice(names, now, [texts[n] for n in names])
        orientation.setObjectName("SweptVolumeOrientation")
        widgets.hint(
            orientation,
            translate(
                "SweptVolume",
                "Fixed: the part never turns. Tangent: the x axis of the part follows the "
                "tangent. Second curve: as Tangent, and the z axis points to the second curve; "
                "select two curves, first the one that the part follows",
            ),
        )
        rows.addRow(translate("SweptVolume", "Orientation"), orientation)
        self.values["orientation"] = orientation.currentData
        self._seconds(rows, "duration", translate("SweptVolume", "Duration"), 10.0)

    def _build_robot(self, rows):
        self._count(rows)

    def _build_array(self, rows):
        self._seconds(rows, "step", translate("SweptVolume", "Step"), 1.0)

    _build_placements = _build_array

    def _build_cam(self, rows):
        texts = [translate("SweptVolume", "Tool head"), translate("SweptVolume", "Table")]
        now = self.given.get("convention", "Head")
        convention = widgets.choice(CONVENTIONS, now, texts)
        convention.setObjectName("SweptVolumeConvention")
        widgets.hint(
            convention,
            translate(
                "SweptVolume",
                "What the G-code words A, B and C rotate: the tool head, or the table with the "
                "workpiece. They are angles in degrees about the fixed axes x, then y, then z. "
                "For a tool head, X, Y and Z are coordinates of the workpiece; for a table, they "
                "are coordinates of the machine",
            ),
        )
        rows.addRow(translate("SweptVolume", "Rotary axes"), convention)
        self.values["convention"] = convention.currentData
        rapid = QtWidgets.QDoubleSpinBox()
        rapid.setRange(0, 1e12)
        rapid.setSuffix(" mm/s")
        rapid.setValue(self.given.get("rapid", 100.0))
        rows.addRow(translate("SweptVolume", "Rapid"), rapid)
        self.values["rapid"] = rapid.value

    def _build_driven(self, rows):
        names = driven.names_of(self.objects[0])
        name = widgets.choice(names, self.given.get("property", names[0] if names else ""))
        name.setObjectName("SweptVolumeValue")
        rows.addRow(translate("SweptVolume", "Value"), name)
        self.values["property"] = name.currentData
        fields = []
        for key, text in (
            ("start", translate("SweptVolume", "Start")),
            ("end", translate("SweptVolume", "End")),
        ):
            field = QtWidgets.QDoubleSpinBox()
            field.setObjectName("SweptVolume" + key.capitalize())
            field.setRange(-1e12, 1e12)
            field.setDecimals(4)
            rows.addRow(text, field)
            self.values[key] = field.value
            fields.append(field)

        def show_range(*ignored):
            """Starts the range at the present value, in its unit."""
            widgets.show_message(self.message, "")
            try:
                handle = driven.Handle(self.objects[0], name.currentData())
            except InputProblem as problem:  # an expression sets the value
                widgets.show_message(self.message, str(problem))
                return
            kept = self.given.get("property") == handle.name
            for field, key, more in zip(fields, ("start", "end"), (0.0, 90.0)):
                field.setSuffix(" " + handle.unit() if handle.unit() else "")
                field.setValue(self.given[key] if kept else handle.value() + more)

        name.currentIndexChanged.connect(show_range)
        if names:
            show_range()
        self._count(rows)
        self._seconds(rows, "duration", translate("SweptVolume", "Duration"), 10.0)

    def _count(self, rows):
        count = QtWidgets.QSpinBox()
        count.setObjectName("SweptVolumeCount")
        count.setRange(0, 999999999)
        count.setGroupSeparatorShown(True)
        count.setValue(self.given["count"])
        rows.addRow(translate("SweptVolume", "Count"), count)
        self.values["count"] = count.value

    def _seconds(self, rows, name, title, value):
        field = QtWidgets.QDoubleSpinBox()
        field.setRange(0, 1e12)
        field.setSuffix(" s")
        field.setValue(self.given.get(name, value))
        rows.addRow(title, field)
        self.values[name] = field.value

    @guard.shows_problems
    def accept(self):
        guard.check_fields(self.form)
        if self._all_parts():
            return self._take_all({name: read() for name, read in self.values.items()})
        with runner.transaction(self.document, self.title):
            obj = self._written({name: read() for name, read in self.values.items()})
            self._say_first(obj.Message)
        Gui.Control.closeDialog()
        return True

    def _say_first(self, text):
        """Raises InputProblem if there are notes about the poses that were not shown yet. The
        motion is then not created."""
        if text != self.shown_notes:
            self.shown_notes = text
            once_more = translate("SweptVolume", "Press OK again to use the motion as it is.")
            raise InputProblem("{} {}".format(text, once_more))

    def _all_parts(self):
        """Returns whether no part is chosen, so that all parts that the source moves get motions."""
        return self.obj is None and self.kind in FROM_JOINTS and len(self.objects) == 1

    def _take_all(self, values):
        """Creates motions of all parts that the source moves. Raises InputProblem."""
        settings = Settings(self.kind, objects=self.objects, **values)
        with runner.transaction(self.document, self.title):
            run = frames_run.recorded(self.document, settings)
            if run is None:
                return False
            found, notes = joint_motions.take(self.document, settings, run)
            for obj in found:
                obj.Interpolation = self.interpolation.currentData()
            self.document.recompute()
            said = notes + [obj.Message for obj in found if obj.Message]
            self._say_first(" ".join(dict.fromkeys(said)))
        Gui.Control.closeDialog()
        return True

    def _written(self, values):
        """Writes these settings to the motion and returns it."""
        rules = self.interpolation.currentData(), self.frame.currentData()
        if self.obj is None:
            obj = motion.motion_from_source(
                self.document, self.kind, self.objects, *rules, **values
            )
            obj.Label = motion.label_for(motion.parts_of(obj)) or obj.Label
            self.document.recompute([obj])
            return obj
        motion.change_source(self.obj, values)
        self.obj.Interpolation, self.obj.PoseType = rules
        motion.reload_source(self.obj)
        self.document.recompute()
        return self.obj

    def reject(self):
        Gui.Control.closeDialog()
        return True


def show(document, kind, objects, obj=None):
    panel = SourcePanel(document, kind, objects, obj)
    focus.show(panel)
    return panel
