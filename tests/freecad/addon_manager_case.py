# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run in FreeCAD without a window by test_addon_manager.py. Installs this add-on and its Python packages
with the code of FreeCAD's own Addon Manager. ADDON_SOURCE is the address: a git repository with the branch
main. Prints the packages that the add-on needs according to the Addon Manager.
"""
import json
import os
import sys

for folder in ("/usr/share/freecad/Mod/AddonManager", "/usr/lib/freecad/Mod/AddonManager"):
    sys.path.append(folder)

import FreeCAD as App  # noqa: E402
from PySide import QtCore  # noqa: E402

application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])

import Addon as addon_module  # noqa: E402

SOURCE, NAME = os.environ["ADDON_SOURCE"], "SweptVolume"


def new_addon():
    kinds = addon_module.Addon.Status
    addon = addon_module.Addon(NAME, SOURCE, kinds.NOT_INSTALLED, "main")
    addon.load_metadata_file(os.path.join(SOURCE, "package.xml"))
    return addon


def needed(addon):
    """Returns the Python packages that the add-on requires and that cannot be imported."""
    if hasattr(addon_module, "MissingDependencies"):  # FreeCAD 1.1 and 1.0
        kind = addon_module.MissingDependencies
        newer = hasattr(kind, "import_from_addon")
        found = kind() if newer else kind(addon, [])
        if newer:
            found.import_from_addon(addon, [])
        return sorted(found.python_requires)
    found = addon_module.Addon.Dependencies()
    addon.walk_dependency_tree({}, found)
    missing = []
    for name in sorted(found.python_required):
        try:
            __import__(name)
        except ImportError:
            missing.append(name)
    return missing


def install_of_0_20(addon, packages):
    import addonmanager_workers as workers

    failures = []
    worker = workers.InstallWorkbenchWorker(addon)
    worker.failure.connect(lambda repo, text: failures.append(text))
    worker.run()
    worker = workers.DependencyInstallationWorker([], packages, [])
    worker.failure.connect(lambda text, details: failures.append(text + str(details)))
    worker.no_pip.connect(lambda text: failures.append("no pip: " + text))
    worker.run()
    return failures


def without_constraints(call):
    """Makes FreeCAD 1.1 use the local index. Otherwise FreeCAD would make pip read the versions of
    allowed packages from the internet."""

    def pip_call(args):
        words = call(args)
        at = words.index("--constraint") if "--constraint" in words else len(words)
        return words[:at] + words[at + 2 :]

    return pip_call


def install_of_1(addon, packages):
    import addonmanager_dependency_installer as dependencies
    import addonmanager_installer as installer
    import addonmanager_utilities as utilities

    if hasattr(utilities, "create_pip_call"):
        utilities.create_pip_call = without_constraints(utilities.create_pip_call)
    failures = []
    worker = installer.AddonInstaller(addon, allow_list=packages + ["numpy"])
    worker.failure.connect(lambda repo, text: failures.append(text))
    worker.run()
    worker = dependencies.DependencyInstaller([], packages, [])
    worker.failure.connect(lambda text, details: failures.append(text + str(details)))
    worker.no_pip.connect(lambda text: failures.append("no pip: " + text))
    worker.run()
    return failures


addon = new_addon()
packages = needed(addon)
try:
    import addonmanager_installer  # noqa: F401
except ImportError:
    failures = install_of_0_20(addon, packages)
else:
    failures = install_of_1(addon, packages)
report = {"packages": packages, "failures": failures, "user": App.getUserAppDataDir()}
print("\nreport:" + json.dumps(report), flush=True)
os._exit(0)
