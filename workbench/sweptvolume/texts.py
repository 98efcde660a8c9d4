# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translates the texts of the workbench.

The context is "SweptVolume". Two other contexts belong to FreeCAD: "App::Property" for the help of
properties, which documents store in English, and "Workbench" for menus and toolbars. FreeCAD
translates both where it shows them. Qt's lupdate collects the texts: see
resources/translations/update.py.
"""
import FreeCAD as App


def translate(context, text):
    """Returns the text in the user's language, or unchanged if it has no translation."""
    try:
        return App.Qt.translate(context, text)
    except (AttributeError, ImportError):  # plain Python without Qt
        return text


def language():
    """Returns the code of the language of the texts: en or de."""
    return translate("SweptVolume", "en")


def QT_TRANSLATE_NOOP(context, text):  # noqa: N802, ARG001 (Qt's name, which lupdate looks for)
    """Marks a text that is translated where it is shown, not where it is defined."""
    return text
