# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runs of a panel for distance checks: the check, and the search for contacts at the first
pose."""
from .. import quantities
from ..texts import translate
from . import widgets


class CheckRun:
    """The panel has `check` and `touching` (its buttons), `asked` (its table of rules), plan(), and
    the widgets `table`, `form`, `box` and `message`. Subclasses define their tasks."""

    TASK = None
    CONTACTS = None

    def label_of(self, pair):
        """Returns the text for the part, or the pair of parts, to which a rule applies."""
        raise NotImplementedError

    def check_succeeded(self, plan):
        """Called after a check of this plan succeeded."""
        raise NotImplementedError

    def start(self):
        plans = []  # both functions use one plan, because it keeps the data that it has read

        def plan():
            plans[:] = plans or [self.plan()]
            return plans[0]

        if not self.begin(
            lambda: self.TASK(self.document, plan(), self.obj),
            self.ended,
            lambda: plan().words(),
            self.start,
        ):
            return False
        self._enable(False)
        return True

    def allow_touching(self):
        """Finds the contacts at the first pose and allows them in the table."""
        if self.begin(lambda: self.CONTACTS(self.plan()), self.ended):
            self._enable(False)

    def _enable(self, on):
        for button in (self.check, self.touching):
            button.setEnabled(on)

    def _allow(self, found):
        rules = self.asked.rules()
        listed = self.asked.pairs + [pair for pair in found if pair not in self.asked.pairs]
        self.asked.show_pairs(listed, {**rules, **found})
        if not found:
            text = translate("SweptVolume", "No parts are in contact at the first pose.")
        else:
            lines = [
                "{} ({})".format(self.label_of(pair), quantities.quantity(rule.length, 3))
                if rule.length
                else self.label_of(pair)
                for pair, rule in found.items()
            ]
            text = translate(
                "SweptVolume",
                "Contact is now allowed for these parts. Check that this is intended: {0}",
            )
            text = text.format(", ".join(lines))
        widgets.show_message(self.message, text)

    def ended(self, run):
        self.run = None
        if not widgets.alive(self.document):
            return
        self._enable(True)
        if run.state != "ok":
            self.box.leave(self.form)
            widgets.show_failure(self.message, run)
        elif isinstance(run.task, self.CONTACTS):
            self.box.leave(self.asked)
            self._allow(run.task.found)
        else:
            if isinstance(run.task, self.TASK):
                self.obj = run.task.obj
                self.check_succeeded(run.task.plan)
                self.show_result()
            self.box.leave(self.table)
