# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translates the texts of the workbench. Contexts: Workbench, Commands, Panels, Messages, and
Properties, the help of properties: documents store it in English, and FreeCAD translates it where
it shows it."""
import FreeCAD as App

#: Contexts whose name is given by FreeCAD.
_GIVEN = {"Properties": "App::Property"}


def translate(context, text):
    """Returns the text in the user's language, or unchanged if it has no translation."""
    try:
        return App.Qt.translate(_GIVEN.get(context, "SweptVolume_" + context), text)
    except (AttributeError, ImportError):  # plain Python without Qt
        return text


def language():
    """Returns the code of the language of the texts: en or de."""
    return translate("Messages", "en")


def mark(context, text):  # noqa: ARG001 (read by the translation tool)
    """Marks a text that is translated where it is shown, not where it is defined."""
    return text


def menu(text):
    """Marks the name of a menu or toolbar. FreeCAD translates it itself, in the context Workbench."""
    return text
