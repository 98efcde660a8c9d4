# SPDX-License-Identifier: LGPL-2.1-or-later
"""Collects the texts of the workbench into the .ts files with Qt's lupdate, and packs them with lrelease.

    python3 resources/translations/update.py

Texts that have not changed keep their translations. Needs lupdate and lrelease of Qt 6, because the lupdate
of Qt 5 reads only the first of several adjacent string literals. Debian's package is qt6-l10n-tools.
"""
import glob
import os
import shutil
import subprocess
import xml.etree.ElementTree as Tree

HERE = os.path.dirname(os.path.realpath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
LANGUAGES = ["de"]


def tool(name):
    """Returns the path of Qt 6's lupdate or lrelease. Raises FileNotFoundError."""
    folders = ["/usr/lib/qt6/bin", "/usr/lib64/qt6/bin", os.environ.get("PATH", os.defpath)]
    found = shutil.which(name, path=os.pathsep.join(folders))
    if not found:
        raise FileNotFoundError(name + " of Qt 6 was not found: install qt6-l10n-tools")
    return found


def sources():
    """Returns the files that have texts, in order."""
    found = [os.path.join(ROOT, "InitGui.py")]
    for pattern in ("workbench/sweptvolume/**/*.py", "resources/ui/*.ui"):
        found += sorted(glob.glob(os.path.join(ROOT, pattern), recursive=True))
    return found


def collect(path, language):
    """Updates the .ts file to the present texts. Known translations stay; texts that no longer exist are
    removed."""
    options = ["-silent", "-locations", "none", "-no-obsolete", "-source-language", "en"]
    command = [tool("lupdate"), *options, "-target-language", language, *sources(), "-ts", path]
    subprocess.run(command, check=True)


def translations(path):
    """Returns {(context, text): translation} of a .ts file. Without a translation, the value is ""."""
    result = {}
    for context in Tree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            key = (context.find("name").text, message.find("source").text)
            result[key] = message.find("translation").text or ""
    return result


def main():
    for language in LANGUAGES:
        path = os.path.join(HERE, "SweptVolume_{}.ts".format(language))
        collect(path, language)
        known = translations(path)
        missing = [key for key in known if not known[key]]
        print("{}: {} texts, {} without a translation".format(language, len(known), len(missing)))
        for context, text in missing:
            print("   {}: {!r}".format(context, text))
        subprocess.run([tool("lrelease"), "-silent", path, "-qm", path[:-3] + ".qm"], check=True)


if __name__ == "__main__":
    main()
