# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translation of what users read. Contexts: Workbench, Commands, Panels, Properties, Messages."""
import FreeCAD as App


def translate(context, text):
    """The text in the user's language, or as it stands where there is no translation."""
    try:
        return App.Qt.translate("SweptVolume_" + context, text)
    except (AttributeError, ImportError):  # plain Python without Qt
        return text


def language():
    """Code of the language that texts are read in: en, or de."""
    return translate("Messages", "en")


def mark(context, text):  # noqa: ARG001 (read by the translation tool)
    """Marks a text that is translated where it is shown, not where it is defined."""
    return text


def menu(text):
    """Marks the name of a menu or toolbar: FreeCAD translates it itself, in its context Workbench."""
    return text
