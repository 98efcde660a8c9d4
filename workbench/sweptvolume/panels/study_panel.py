# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panel of a study: the runs, and their rows with the state as they end. Opens the worst run.
Writes nothing to the document before a run has succeeded or was stopped."""
import os

from PySide import QtCore, QtGui

from .. import core
from ..convert import InputProblem
from ..features import study, study_export, study_plan, study_table
from ..texts import translate
from . import file_dialogs, focus, guard, widgets
from .run_panel import StayingPanel
from .study_open import Opener
from .study_rows import RowTable
from .study_tasks import StudyPageTask, StudyTask, TakeRunTask
from .widgets import QtWidgets


class StudyPanel(StayingPanel):
    """Creates a new study (obj None), or shows and repeats an existing one. sources: ticked at
    first."""

    def __init__(self, document, obj=None, sources=()):
        self.document, self.obj, self.run = document, obj, None
        plan = study.Plan.of(obj) if obj is not None else study.Plan(document, sources=sources)
        title = translate("SweptVolume", "Study")
        self.form, self.layout = widgets.window(title, "SweptVolume_Study")
        self.box = widgets.RunBox()
        self.message = widgets.message_label()
        self.layout.addWidget(self.box)
        self.layout.addWidget(self.message)
        self._build_result()
        self._build_inputs(plan)
        self.opener = Opener(self)
        self.show_result()
        if plan.lost:
            widgets.show_message(self.message, plan.lost)
        self.watch = self.watched()

    # --- building

    def _build_inputs(self, plan):
        rows = widgets.group(translate("SweptVolume", "Runs"), self.layout)
        self.kind = widgets.choice(
            ["document", "file"],
            "file" if plan.file and not plan.sources else "document",
            [
                translate("SweptVolume", "of this document"),
                translate("SweptVolume", "of a study file"),
            ],
        )
        self.kind.setObjectName("SweptVolumeStudyKind")
        rows.addRow(translate("SweptVolume", "Runs"), self.kind)
        self.list = QtWidgets.QListWidget()
        self.list.setObjectName("SweptVolumeStudySources")
        self.list.setMaximumHeight(150)
        every = [o for o in self.document.Objects if study_plan.can_run(o)]
        ticked = plan.sources or [o for o in every if study_plan.has_one_motion(o)]
        for source in every:
            item = QtWidgets.QListWidgetItem(source.ViewObject.Icon, source.Label)
            item.setData(QtCore.Qt.UserRole, source.Name)
            item.setFlags(item.flags() | QtCore.Qt.ItemIsUserCheckable)
            item.setCheckState(QtCore.Qt.Checked if source in ticked else QtCore.Qt.Unchecked)
            self.list.addItem(item)
        rows.addRow(self.list)
        text = translate("SweptVolume", "Study file")
        self.file = self._file_row(rows, text, "SweptVolumeStudyFile", plan.file, self._ask_file)
        self.file_label = rows.labelForField(self.file.parentWidget())
        text = translate("SweptVolume", "Results")
        self.folder = self._file_row(
            rows, text, "SweptVolumeStudyFolder", plan.folder, self._ask_folder
        )
        self.folder.setPlaceholderText(translate("SweptVolume", "default folder"))
        self.jobs = QtWidgets.QSpinBox()
        self.jobs.setObjectName("SweptVolumeStudyJobs")
        self.jobs.setRange(0, 256)
        self.jobs.setSpecialValueText(translate("SweptVolume", "one for each processor core"))
        self.jobs.setValue(plan.jobs)
        rows.addRow(translate("SweptVolume", "Runs at once"), self.jobs)
        self.start_button = QtWidgets.QPushButton()
        self.start_button.setObjectName("SweptVolumeRunStudy")
        self.start_button.setDefault(True)  # Enter presses this button
        rows.addRow(self.start_button)
        self.start_button.clicked.connect(lambda *ignored: self.start())
        self.kind.currentIndexChanged.connect(lambda *ignored: self._show_kind())
        self._show_kind()

    def _file_row(self, rows, label, name, text, ask):
        """Builds a field with a button that opens the dialog `ask`."""
        line = QtWidgets.QWidget()
        box = QtWidgets.QHBoxLayout(line)
        box.setContentsMargins(0, 0, 0, 0)
        field, button = QtWidgets.QLineEdit(text), QtWidgets.QPushButton("...")
        field.setObjectName(name)
        button.setObjectName(name + "Ask")
        button.setMaximumWidth(40)
        box.addWidget(field, 1)
        box.addWidget(button)
        rows.addRow(label, line)
        button.clicked.connect(lambda *ignored: ask())
        return field

    def _build_result(self):
        self.result = QtWidgets.QGroupBox(translate("SweptVolume", "Result"))
        rows = QtWidgets.QVBoxLayout(self.result)
        self.summary = QtWidgets.QLabel()
        self.summary.setWordWrap(True)
        self.summary.setObjectName("SweptVolumeStudySummary")
        self.table = RowTable()
        self.about = widgets.message_label()
        buttons = QtWidgets.QHBoxLayout()
        self.open_button, self.page_button, self.report_button = (
            QtWidgets.QPushButton(text)
            for text in (
                translate("SweptVolume", "&Open worst"),
                translate("SweptVolume", "Page"),
                translate("SweptVolume", "Report..."),
            )
        )
        for button, name in (
            (self.open_button, "SweptVolumeOpenRun"),
            (self.page_button, "SweptVolumeStudyPage"),
            (self.report_button, "SweptVolumeReport"),
        ):
            button.setObjectName(name)
            buttons.addWidget(button)
        widgets.hint(
            self.page_button,
            translate("SweptVolume", "Opens the report page of all runs in the web browser"),
        )
        for widget in (self.summary, self.table, self.about):
            rows.addWidget(widget)
        rows.addLayout(buttons)
        self.layout.addWidget(self.result)
        self.table.chose.connect(lambda *ignored: self._chosen())
        self.table.doubleClicked.connect(lambda *ignored: self.open_run())
        self.open_button.clicked.connect(lambda *ignored: self.open_run())
        self.page_button.clicked.connect(lambda *ignored: self.open_page())
        self.report_button.clicked.connect(lambda *ignored: self.export_page())

    # --- inputs

    def _show_kind(self):
        of_file = self.kind.currentData() == "file"
        self.list.setVisible(not of_file)
        for widget in (self.file.parentWidget(), self.file_label):
            widget.setVisible(of_file)

    def _ask_file(self):
        path = file_dialogs.ask_study()
        if path:
            self.file.setText(path)

    def _ask_folder(self):
        path = file_dialogs.ask_folder(self.folder.text())
        if path:
            self.folder.setText(path)

    def plan(self):
        folder, jobs = self.folder.text().strip(), self.jobs.value()
        if self.kind.currentData() == "file":
            return study.Plan(self.document, self.file.text().strip(), (), folder, jobs)
        items = [self.list.item(k) for k in range(self.list.count())]
        names = [
            item.data(QtCore.Qt.UserRole)
            for item in items
            if item.checkState() == QtCore.Qt.Checked
        ]
        sources = [obj for obj in map(self.document.getObject, names) if obj is not None]
        return study.Plan(self.document, "", sources, folder, jobs)

    # --- run

    def start(self):
        plan = self.plan()
        if not self.begin(
            lambda: StudyTask(self.document, plan, self.obj), self.ended, plan.words, self.start
        ):
            return False
        self._enable(False)
        self.begun = False
        self.result.show()
        self.summary.setText("")
        self.run.progress.connect(lambda *ignored: self._follow())
        return True

    def _follow(self):
        if self.run is None or not isinstance(self.run.task, StudyTask):
            return
        task = self.run.task
        if not self.begun and task.names is not None:
            self.table.begin(task.names)
            self.begun = True
        if self.begun:
            self.table.take(dict(task.request.rows))

    def _enable(self, on):
        for button in (self.start_button, self.open_button, self.page_button, self.report_button):
            button.setEnabled(on)

    def ended(self, run):
        self.run = None
        if not widgets.alive(self.document):
            return
        self._enable(True)
        self.box.leave(self.table)
        if isinstance(run.task, StudyTask):
            self.obj = run.task.obj or self.obj
            self.show_result()
            if run.state == "failed" or self.obj is None:
                widgets.show_failure(self.message, run)
        elif run.state != "ok":
            widgets.show_failure(self.message, run)
        elif isinstance(run.task, TakeRunTask):
            self.opener.show(run.task.found)

    # --- result

    def show_result(self):
        self.note_state()
        report = study.report_of(self.obj) if self.obj is not None else None
        self.result.setVisible(report is not None)
        left = report is not None and study_table.count(report["runs"], "not run")
        go_on = (
            translate("SweptVolume", "Continue") if left else translate("SweptVolume", "Run study")
        )
        self.start_button.setText(go_on)
        if report is None:
            return
        text = self.obj.Summary
        if self.obj.Status == study.STALE:
            text = translate("SweptVolume", "{0} (stale: run again)").format(text)
        self.summary.setText("<b>{}</b>".format(text.replace("<", "&lt;")))
        widgets.show_message(self.message, self.obj.Message)
        self.table.show_report(report)
        self.page_button.setEnabled(os.path.isfile(self._page()))
        self._chosen()

    def _chosen(self):
        """Shows the text of the chosen row. The button opens that run, or the worst one if no row
        is chosen."""
        row = self.table.chosen()
        self.open_button.setText(
            translate("SweptVolume", "&Open worst")
            if row is None
            else translate("SweptVolume", "&Open run")
        )
        widgets.show_message(self.about, "" if row is None else study_table.line_of(row))

    @guard.shows_problems
    def open_run(self):
        """Opens the chosen run, or the worst one."""
        if self.run is not None or self.obj is None:
            return
        report = study.report_of(self.obj)
        row = self.table.chosen() or study_table.worst(report)
        if row is None:
            return
        source = study.Plan.of(self.obj).source_of(row["run"])
        if source is not None:
            self.opener.show(source)
        elif self.begin(lambda: TakeRunTask(self.obj, row["run"]), self.ended):
            self._enable(False)

    def _page(self):
        return os.path.join(self.obj.Results, study_export.PAGE)

    @guard.shows_problems
    def open_page(self):
        path = self._page()
        if not QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(path)):
            text = translate(
                "SweptVolume",
                "{0} could not be opened: install a web browser, or open the file yourself.",
            )
            raise InputProblem(text.format(path))

    @guard.shows_problems
    def export_page(self):
        if self.run is not None:
            return
        path = file_dialogs.ask_report(self.obj.Label)
        if path and self.begin(lambda: StudyPageTask(self.obj, path), self.ended):
            self._enable(False)


def show(document, obj=None, sources=()):
    core.module()  # raises early, with the text how to get the core
    if obj is not None:
        study.update_status(obj)  # files of a study may have changed while the document was open
    panel = StudyPanel(document, obj, sources)
    focus.show(panel)
    return panel
