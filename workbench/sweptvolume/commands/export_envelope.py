# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export envelope: STEP, BREP or a mesh file."""
from ..texts import QT_TRANSLATE_NOOP
from .base import BaseCommand


class Command(BaseCommand):
    NAME = "SweptVolume_Export"
    TEXT = QT_TRANSLATE_NOOP("SweptVolume", "Export envelope...")
    TIP = QT_TRANSLATE_NOOP(
        "SweptVolume",
        "Writes the selected envelope as STEP, BREP, STL, PLY, OBJ, OFF or 3MF and checks the "
        "file. You can also select a solid that was made from an envelope: the panel then begins "
        "with the settings of this solid",
    )

    def missing(self, document):
        from ..panels import selection

        if selection.source() is not None or selection.solid() is not None:
            return ""
        return selection.missing_envelope_text(document)

    def run(self, document):
        from .. import export
        from ..panels import file_dialogs, mesh_file_panel, selection, solid_panel

        source, solid = selection.source(), selection.solid()
        if source is None and solid is not None:
            source = solid.Source
        if source is None:
            source = selection.the_envelope(document)
        path = file_dialogs.ask_export(source.Label)
        if path and export.is_solid_file(path):
            solid_panel.show(source, solid, path)
        elif path:
            mesh_file_panel.show(source, path)
