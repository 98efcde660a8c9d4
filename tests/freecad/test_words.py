# SPDX-License-Identifier: LGPL-2.1-or-later
"""One word for one thing: fields of panels are labelled with the words of their properties, and verdicts have
the same words everywhere (docs/handbook/glossary.md)."""
import os
import re
import sys
import unittest

from conftest import ROOT
from sweptvolume.features import (
    clearance,
    clearance_properties,
    clearance_table,
    envelope_properties,
    mechanism_properties,
    motion_properties,
    sequence_properties,
    solid_properties,
)
from sweptvolume.features.renamed import RENAMED

#: Properties that no panel shows under their label, and what shows them instead.
NO_LABEL = {
    "CellSize": "its label is there, but the choice before it names it too",
    "Motions": "a column of the table of parts",
    "Times": "the table of keys",
    "Placements": "the table of keys",
    "Tangents": "the box for the tangent of a key",
    "Velocities": "the box for the tangent of a key",
    "Parts": "the field Part",
    "SourceType": "the title of the panel",
    "SourceObjects": "the selection",
    "SourceSettings": "hidden",
    "RuleParts": "the table of rules",
    "RuleKinds": "the table of rules",
    "RuleLengths": "the table of rules",
}


#: Terms with another German word than the text: the name of the workbench.
OTHER_GERMAN = {"Swept volume"}


def literals_of_the_core():
    """Returns the string literals of each source file of the core, adjacent ones joined."""
    found = []
    for folder in ("cpp/src", "cpp/tools", "cpp/include"):
        for base, _, names in os.walk(os.path.join(ROOT, folder)):
            for name in names:
                with open(os.path.join(base, name), encoding="utf-8", errors="replace") as file:
                    text = re.sub(r'"\s*\n\s*"', "", file.read())
                found.append("\n".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', text)))
    return found


def words(name):
    """Returns the name of a property as FreeCAD's property editor shows it, in sentence case. The
    prefix Source is dropped: SourceAccuracy is "Accuracy" in the panel of the source."""
    name = re.sub("^Source(?=[A-Z])", "", name)
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).capitalize()


def inputs():
    """Returns the names of the properties that users set."""
    found = [row[1] for row in envelope_properties.INPUT + envelope_properties.ACCURACY]
    for module in (clearance_properties, mechanism_properties, sequence_properties):
        found += [row[1] for row in module.INPUT]
    found += [row[1] for row in solid_properties.PROPERTIES if row[2] == "Solid"]
    found += [row[1] for row in motion_properties.PROPERTIES if row[2] != "Result"]
    found += list(motion_properties.NAMES.values())
    return sorted(set(found) - {"SourceHash", "MovedToo", "Missing"})


class Words(unittest.TestCase):
    def setUp(self):
        folder = os.path.join(ROOT, "resources", "translations")
        if not os.path.isdir(folder):
            self.skipTest("the translations are not here")
        sys.path.insert(0, folder)
        try:
            import update
        finally:
            sys.path.remove(folder)
        known = update.translations(os.path.join(folder, "SweptVolume_de.ts"))
        bare = lambda text: re.sub(r": \{0\}$|\.+$", "", text.replace("&", ""))  # noqa: E731
        self.translated = {
            bare(text): bare(known[context, text])
            for context, text in known
            if context == "SweptVolume"
        }
        self.texts = {text.replace("&", "") for context, text in known if context == "SweptVolume"}

    def test_labels_are_the_words_of_their_properties(self):
        wrong = [n for n in inputs() if words(n) not in self.texts and n not in NO_LABEL]
        self.assertEqual(wrong, [])

    def test_words_are_those_of_the_glossary(self):
        """Checks the terms that are also texts of the workbench, in English and German. Each label in
        the last column of the glossary must be such a text."""
        path = os.path.join(ROOT, "docs", "handbook", "glossary.md")
        with open(path, encoding="utf-8") as file:
            page = file.read()
        german = {}
        for text, translated in self.translated.items():
            german.setdefault(text.lower(), set()).add(translated.lower())
        rows = re.findall(r"^\| \*\*(.*?)\*\* \|.*\| ([^|]*?) \|([^|]*)\|$", page, re.M)
        self.assertGreater(len(rows), 40)
        self.assertEqual(len(rows), len(re.findall(r"^\| \*\*", page, re.M)))
        shared = [row for row in rows if row[0].lower() in german and row[0] not in OTHER_GERMAN]
        self.assertGreater(len(shared), 30)
        wrong = [
            (t, w, german[t.lower()]) for t, w, _ in shared if w.lower() not in german[t.lower()]
        ]
        self.assertEqual(wrong, [])
        labels = {label for _, _, seen in rows for label in re.findall(r"(?<!\*)\*([^*]+)\*", seen)}
        properties = set(inputs())
        unknown = [
            label
            for label in labels - {"Motion from ...", "Placement"}
            if label.lower() not in german and label not in properties
        ]
        self.assertEqual(unknown, [])

    def test_words_of_before_are_gone(self):
        before = (
            "Between poses|A pose is|Simplification|Contain the sweep|Faces at most|[Tt]oo near"
        )
        before += "|List pairs|Path editor|path editor"
        self.assertEqual([text for text in self.texts if re.search(before, text)], [])

    def test_nothing_has_an_old_name(self):
        old = {name for names in RENAMED.values() for name in names} - {"Tolerance"}
        self.assertEqual(old & set(inputs()), set())

    def test_verdicts_are_those_of_the_glossary(self):
        with open(os.path.join(ROOT, "docs", "handbook", "glossary.md"), encoding="utf-8") as file:
            page = file.read().split("## Verdicts")[1].split("##")[0]
        rows = re.findall(r"^\| \*\*(.*?)\*\* \|.*\| (.*?) \| `(.*?)` \|$", page, re.M)
        self.assertEqual({code: name for name, _, code in rows}, clearance.VERDICTS)
        for name, _, code in rows:
            self.assertEqual(clearance_table.verdict_word(code), name.lower())
        path = os.path.join(ROOT, "cpp", "src", "page", "words.cpp")
        if os.path.isfile(path):
            with open(path, encoding="utf-8") as file:
                source = file.read()
            for name, german, code in rows:
                self.assertIn('Word{{"{}", "{}", "{}"}}'.format(code, name.lower(), german), source)

    def test_words_on_the_page_for_troubleshooting_are_those_of_the_core(self):
        """The page quotes each message as it stands in the sources of the core."""
        from sweptvolume import core_texts

        if not os.path.isdir(os.path.join(ROOT, "cpp", "src")):
            self.skipTest("the sources of the core are not here")
        sources = literals_of_the_core()
        path = os.path.join(ROOT, "docs", "handbook", "troubleshooting.md")
        with open(path, encoding="utf-8") as file:
            page = file.read()
        codes, silent = set(), set()
        for table in re.findall(
            r"^\| code \| words of the message .*?(?=\n\n|\Z)", page, re.M | re.S
        ):
            for row in table.splitlines()[2:]:
                cells = row.strip("|").split("|")
                here = re.findall(r"`(\w+)`", cells[0])
                quoted = re.findall(r'"(.+?)"(?:; | $)', cells[1])
                codes.update(here)
                if not quoted:
                    silent.update(here)
                for words in quoted:
                    parts = words.split(" ... ")
                    held = [text for text in sources if all(part in text for part in parts)]
                    self.assertTrue(held, (here, words))
        # The messages of these codes differ from case to case.
        self.assertEqual(silent, {"BadOption", "BadFile"})
        self.assertEqual(set(core_texts._TEXTS) - codes, set())

    def test_every_code_of_the_core_is_in_the_page_for_troubleshooting(self):
        from sweptvolume import core_texts

        path = os.path.join(ROOT, "docs", "handbook", "troubleshooting.md")
        with open(path, encoding="utf-8") as file:
            codes_named = set(re.findall(r"`([A-Z][A-Za-z]+)`", file.read()))
        self.assertEqual(set(core_texts._TEXTS) - codes_named, set())
        if not os.path.isdir(os.path.join(ROOT, "cpp", "src")):
            return
        found = set()
        for folder in ("cpp/src", "cpp/tools"):
            for base, _, names in os.walk(os.path.join(ROOT, folder)):
                for name in names:
                    if name.endswith((".cpp", ".h")):
                        with open(os.path.join(base, name), encoding="utf-8") as file:
                            text = file.read()
                        found.update(
                            re.findall(r'(?:Status::[A-Za-z]+,|refuse\()\s*"([A-Z]\w+)"', text)
                        )
                        found.update(re.findall(r'\{\s*"([A-Z][a-z]+[A-Z]\w+)",\s*[\w(]', text))
        self.assertEqual(sorted(found - codes_named - {"Ok"}), [])
