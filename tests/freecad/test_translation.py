# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the workbench is in the .ts files with a translation that has the same placeholders."""
import os
import re
import shutil
import sys
import tempfile
import unittest
from unittest import mock

import FreeCAD as App

import sweptvolume
from sweptvolume.features import motion

FOLDER = sweptvolume.resource("translations")
sys.path.insert(0, FOLDER)
import update  # noqa: E402


def files():
    return [
        (name, os.path.join(FOLDER, "SweptVolume_{}.ts".format(name))) for name in update.LANGUAGES
    ]


class Translation(unittest.TestCase):
    def test_texts_are_collected_and_translated(self):
        for language, path in files():
            with tempfile.TemporaryDirectory() as folder:
                copy = shutil.copy(path, folder)
                update.collect(copy, language)
                now = update.translations(copy)
            self.assertGreater(len(now), 500)
            self.assertEqual(
                [key for key in now if not now[key]], [], "run resources/translations/update.py"
            )
            gone = set(update.translations(path)) - set(now)
            self.assertEqual(gone, set(), "run resources/translations/update.py")

    def test_a_new_text_is_found_and_has_no_translation(self):
        with tempfile.TemporaryDirectory() as folder:
            source = os.path.join(folder, "new.py")
            with open(source, "w", encoding="utf-8") as file:
                file.write(
                    'translate("SweptVolume", "one text "\n    "in two pieces: {0} \N{DEGREE SIGN}")\n'
                )
            copy = shutil.copy(files()[0][1], folder)
            with mock.patch.object(update, "sources", lambda: [source]):
                update.collect(copy, "de")
            text = "one text in two pieces: {0} \N{DEGREE SIGN}"
            self.assertEqual(update.translations(copy), {("SweptVolume", text): ""})

    def test_placeholders_survive(self):
        for _, path in files():
            for (_, text), translation in update.translations(path).items():
                fields = sorted(re.findall(r"{[^}]*}", text))
                self.assertEqual(fields, sorted(re.findall(r"{[^}]*}", translation)), text)

    def test_help_of_properties_is_stored_in_english_and_translated_where_it_is_shown(self):
        doc = App.newDocument("Help")
        try:
            with mock.patch.object(App.Qt, "translate", lambda context, text: "auf deutsch"):
                obj = motion.motion_from_poses(doc, [0, 1], [App.Placement(), App.Placement()])
            name = "PoseType"
            text = obj.getDocumentationOfProperty(name)
            known = update.translations(os.path.join(FOLDER, "SweptVolume_de.ts"))
            self.assertTrue(known["App::Property", text])
            self.assertNotEqual(text, "auf deutsch")
            obj.setDocumentationOfProperty(name, "auf deutsch")  # as earlier versions did
            obj.Proxy.onDocumentRestored(obj)
            self.assertEqual(obj.getDocumentationOfProperty(name), text)
        finally:
            App.closeDocument(doc.Name)

    def test_packed_files_are_there(self):
        for _, path in files():
            self.assertGreater(os.path.getsize(path[:-3] + ".qm"), 1000)
