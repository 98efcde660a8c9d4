# SPDX-License-Identifier: LGPL-2.1-or-later
"""Install the core: the compiled package that computes."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_InstallCore"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Install the core")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume", "Installs the core, the compiled package that does the computation"
    )
    NEEDS_DOCUMENT = False

    def IsActive(self):
        return True  # also while a panel is open that cannot compute

    def run(self, document):
        from ..panels import core_dialog

        core_dialog.offer()
