# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages of the core in the user's language, by code."""
import glob
import os
import re
import unittest
from unittest import mock

from conftest import ROOT
from sweptvolume import core_texts


class CoreTexts(unittest.TestCase):
    def test_untranslated_sentences_stay_as_they_are(self):
        self.assertEqual(core_texts.said("EmptyMesh", "0 triangles"), "0 triangles")
        self.assertEqual(core_texts.said("Unheard", "who knows"), "who knows")
        self.assertEqual(core_texts.said("Cancelled", ""), "Cancelled.")

    def test_translation_comes_before_the_numbers(self):
        with mock.patch.object(core_texts, "translate", lambda context, text: "Leer."):
            self.assertEqual(core_texts.said("EmptyMesh", "0 triangles"), "Leer. (0 triangles)")
            self.assertEqual(core_texts.said("EmptyMesh", ""), "Leer.")
            self.assertEqual(core_texts.said("Unheard", "who knows"), "who knows")

    def test_codes_are_those_of_the_core(self):
        """Each code that has a text exists in the core, and each code of refused input has a text."""
        if not os.path.isdir(os.path.join(ROOT, "cpp")):
            self.skipTest("the sources of the core are not here")
        found, refusals = set(), set()
        for path in glob.glob(os.path.join(ROOT, "cpp", "**", "*.cpp"), recursive=True):
            with open(path, encoding="utf-8") as file:
                text = file.read()
            found.update(re.findall(r'"([A-Z][A-Za-z]+)"', text))
            refusals.update(re.findall(r'Status::InvalidInput,\s*"([A-Za-z]+)"', text))
        self.assertEqual(set(core_texts._TEXTS) - found, set())
        #: Codes that no object of FreeCAD can cause.
        refusals -= {"BadFaces", "BadIndex", "NothingKept", "NoSurface", "SameFile", "CheckFailed"}
        refusals -= {"BadReport", "NoPython", "UnknownPart", "NoParts", "PartTwice"}
        self.assertEqual(refusals - set(core_texts._TEXTS), set())
