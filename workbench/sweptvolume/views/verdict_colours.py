# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of the document in the colours of their verdicts, for as long as a panel is open.

A material of Coin that overrides those behind it is put before what an object draws. No property of the
object or of its view is touched: nothing is written to the document or to its undo record, and what was seen
before is seen again when the material is taken away, with faces of several colours too, in every version of
FreeCAD.
"""
from ..convert import paths_to


def painted_object(root, sub):
    """The object whose look a part at the end of a path has: itself, or the first link on the way, which
    draws a copy of its own. None where the path leads nowhere."""
    found = None
    for path in paths_to(sub):
        found = root.getSubObject(path, retType=1) if path else root
        if found is None or found.isDerivedFrom("App::Link"):
            break
    return found


class VerdictColours:
    """Keeps what it has painted until remove()."""

    def __init__(self):
        self._painted = []  # (root node of the object, what was put before it)

    def show(self, colours):
        """colours: {object: (r, g, b)}; others get their own back."""
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
            if number >= 0:  # the object may have been deleted, its nodes live as long as this
                root.removeChild(number)
        self._painted = []


def _paint(colour):
    """One colour for all faces behind it, whatever they ask for."""
    from pivy import coin

    group, shade, binding = coin.SoGroup(), coin.SoMaterial(), coin.SoMaterialBinding()
    shade.diffuseColor = tuple(map(float, colour))
    shade.transparency.setIgnored(True)
    binding.value = coin.SoMaterialBinding.OVERALL
    for node in (shade, binding):
        node.setOverride(True)
        group.addChild(node)
    return group
