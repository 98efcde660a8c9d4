# SPDX-License-Identifier: LGPL-2.1-or-later
"""Install the core: the compiled package that computes."""
from ..texts import mark
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_InstallCore"
    TEXT = mark("Commands", "Install the core")
    TIP = mark("Commands", "Installs the compiled package with which the workbench computes")
    NEEDS_DOCUMENT = False

    def IsActive(self):
        return True  # also while a panel is open that cannot compute

    def run(self, document):
        from ..panels import core_dialog

        core_dialog.offer()
