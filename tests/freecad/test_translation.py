# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the workbench stands in the .ts files, translated, with the same placeholders."""
import os
import re
import sys
import unittest
from unittest import mock

import FreeCAD as App

import sweptvolume
from sweptvolume.features import motion

FOLDER = sweptvolume.resource("translations")
sys.path.insert(0, FOLDER)
import update  # noqa: E402


class Translation(unittest.TestCase):
    def test_texts_are_collected_and_translated(self):
        found = update.texts()
        for language in update.LANGUAGES:
            path = os.path.join(FOLDER, "SweptVolume_{}.ts".format(language))
            known = update.known(path)
            missing = [(c, t) for c in found for t in found[c] if not known.get((c, t))]
            self.assertEqual(missing, [], "run resources/translations/update.py")

    def test_placeholders_survive(self):
        for language in update.LANGUAGES:
            path = os.path.join(FOLDER, "SweptVolume_{}.ts".format(language))
            for (_, text), translation in update.known(path).items():
                fields = sorted(re.findall(r"{[^}]*}", text))
                self.assertEqual(fields, sorted(re.findall(r"{[^}]*}", translation)), text)

    def test_help_of_properties_is_stored_in_english_and_translated_where_it_is_shown(self):
        doc = App.newDocument("Help")
        try:
            with mock.patch.object(App.Qt, "translate", lambda context, text: "auf deutsch"):
                obj = motion.motion_from_poses(doc, [0, 1], [App.Placement(), App.Placement()])
            name = "PoseType"
            text = obj.getDocumentationOfProperty(name)
            self.assertIn(text, update.texts()["App::Property"])
            self.assertNotEqual(text, "auf deutsch")
            known = update.known(os.path.join(FOLDER, "SweptVolume_de.ts"))
            self.assertTrue(known["App::Property", text])
            obj.setDocumentationOfProperty(name, "auf deutsch")  # as earlier versions did
            obj.Proxy.onDocumentRestored(obj)
            self.assertEqual(obj.getDocumentationOfProperty(name), text)
        finally:
            App.closeDocument(doc.Name)

    def test_packed_files_are_there(self):
        for language in update.LANGUAGES:
            path = os.path.join(FOLDER, "SweptVolume_{}.qm".format(language))
            self.assertGreater(os.path.getsize(path), 1000)
