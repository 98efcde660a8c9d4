# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours parts of the document by their verdicts while a panel is open.

A Coin material that overrides later ones is put before the drawing of an object. No property of the
object or of its view changes, so nothing is written to the document or to its undo record. When the
material is removed, the former look returns, also for faces with several colours and in every
version of FreeCAD.
"""
from ..convert import paths_to


def painted_object(root, sub):
    """Returns the object that determines the look of the part at the end of a path: the part
    itself, or the first link on this path, which draws its own copy. Returns None if the path
    leads to no object."""
    found = None
    for path in paths_to(sub):
        found = root.getSubObject(path, retType=1) if path else root
        if found is None or found.isDerivedFrom("App::Link"):
            break
    return found


class VerdictColours:
    """Keeps what it has coloured until remove()."""

    def __init__(self):
        self._painted = []  # (root node of the object, node that was put before it)

    def show(self, colours):
        """Colours these objects. colours: {object: (r, g, b)}. Objects that are not listed get
        their own colours back."""
        self.remove()
        for obj, colour in colours.items():
            root = getattr(getattr(obj, "ViewObject", None), "RootNode", None)
            if root is not None:
                paint = _paint(colour)
                root.insertChild(paint, 0)
                self._painted.append((root, paint))

    def remove(self):
        for root, paint in self._painted:
            number = root.findChild(paint)
            if number >= 0:  # the object may have been deleted; its nodes live as long as this list
                root.removeChild(number)
        self._painted = []


def _paint(colour):
    """Returns a material with one colour for all faces after it, whatever their own colours are."""
    from pivy import coin

    group, shade, binding = coin.SoGroup(), coin.SoMaterial(), coin.SoMaterialBinding()
    shade.diffuseColor = tuple(map(float, colour))
    shade.transparency.setIgnored(True)
    binding.value = coin.SoMaterialBinding.OVERALL
    for node in (shade, binding):
        node.setOverride(True)
        group.addChild(node)
    return group
