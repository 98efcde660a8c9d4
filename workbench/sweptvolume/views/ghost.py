# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings of the panels in the 3D view that belong to no document: the part at each key and along
its path, the path itself, a coarse envelope."""
import FreeCADGui as Gui
import numpy as np

from ..convert import InputProblem, matrix_of
from ..texts import translate
from . import path, surface

KEY_COLOUR, MOVING_COLOUR = (0.95, 0.75, 0.20), (0.20, 0.70, 0.30)
ENVELOPE_COLOUR, CLASH_COLOUR = (0.35, 0.60, 0.90), (0.90, 0.10, 0.10)
#: Triangles of the part in motion, and at its keys, where it is drawn many times.
MOVING_TRIANGLES, KEY_TRIANGLES = 6000, 1500


def view_of(document):
    """Returns the active 3D view of a document, or its first one if another window, such as a
    spreadsheet, is active. Raises InputProblem if there is none."""
    gui = Gui.getDocument(document.Name)
    active = gui.activeView()
    views = [active] if hasattr(active, "getSceneGraph") else []
    views += gui.mdiViewsOfType("Gui::View3DInventor")
    if not views:
        text = translate(
            "SweptVolume",
            'The document "{0}" has no open 3D view: open one with "Create new view" in the menu View.',
        )
        raise InputProblem(text.format(document.Label))
    return views[0]


class Overlay:
    """Nodes in the active view of a document, until remove(). The mouse cannot pick them."""

    def __init__(self, document):
        from pivy import coin

        self.graph = view_of(document).getSceneGraph()
        self.root = coin.SoSeparator()
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        self.root.addChild(pick)
        self.root.addChild(surface.unsorted_blending())
        self.graph.addChild(self.root)

    def add(self, colour, transparency, *nodes):
        from pivy import coin

        part, material = coin.SoSeparator(), coin.SoMaterial()
        material.diffuseColor = colour
        material.transparency = transparency
        part.addChild(material)
        for node in nodes:
            part.addChild(node)
        self.root.addChild(part)
        return material

    def remove(self):
        if self.root is not None:
            self.graph.removeChild(self.root)
            self.root = None


class CoarseEnvelope(Overlay):
    """One translucent surface."""

    def __init__(self, document):
        from pivy import coin

        super().__init__(document)
        self.surface = coin.SoGroup()
        self.add(ENVELOPE_COLOUR, 0.5, self.surface)

    def show(self, drawn):
        """Draws a result of surface.drawn()."""
        if self.root is not None:
            self.clear()
            self.surface.addChild(surface.group_of(drawn, solid=True))

    def clear(self):
        self.surface.removeAllChildren()


class MovingPart(Overlay):
    """A part (vertices, triangles) at one placement. Not drawn before the first show()."""

    def __init__(self, document, vertices, triangles):
        from pivy import coin

        super().__init__(document)
        drawn = surface.drawn(vertices, triangles, MOVING_TRIANGLES)
        shape = surface.group_of(drawn, surface.is_solid(vertices, triangles))
        self.moving, self.shown = coin.SoMatrixTransform(), coin.SoSwitch()
        self.shown.addChild(self.moving)
        self.shown.addChild(shape)
        self.add(MOVING_COLOUR, 0.35, self.shown)

    def show(self, placement):
        self.moving.matrix = _matrix(placement)
        self.shown.whichChild = -3  # -3: all children


class MovingParts(Overlay):
    """Parts that move at the same time, each with its own placement. Not drawn before the first
    show(). parts: for each part (result of surface.drawn(), whether it is solid)."""

    def __init__(self, document, parts):
        from pivy import coin

        super().__init__(document)
        self.transforms, self.paints, self.shown = [], [], []
        for drawn, solid in parts:
            transform, shown = coin.SoMatrixTransform(), coin.SoSwitch()
            shown.addChild(transform)
            shown.addChild(surface.group_of(drawn, solid))
            self.paints.append(self.add(KEY_COLOUR, 0.45, shown))
            self.transforms.append(transform)
            self.shown.append(shown)

    def show(self, placements, marked=()):
        """Shows the parts at these placements. marked: indices of the parts in another colour."""
        for k, placement in enumerate(placements):
            self.transforms[k].matrix = _matrix(placement)
            self.paints[k].diffuseColor = MOVING_COLOUR if k in marked else KEY_COLOUR
            self.shown[k].whichChild = -3  # -3: all children

    def hide(self):
        for shown in self.shown:
            shown.whichChild = -1


class Ghosts(Overlay):
    """A part (vertices, triangles) at its keys and along its path, and the path with its frames."""

    def __init__(self, document, vertices, triangles):
        from pivy import coin

        super().__init__(document)
        solid = surface.is_solid(vertices, triangles)
        at_keys, shape = (
            surface.group_of(surface.drawn(vertices, triangles, most), solid)
            for most in (KEY_TRIANGLES, MOVING_TRIANGLES)
        )
        self.copies, self.moving = coin.SoMultipleCopy(), coin.SoMatrixTransform()
        self.copies.addChild(at_keys)
        self.path_lines, seen = path.PathLines(), coin.SoAnnotation()  # visible through the parts
        seen.addChild(self.path_lines.root)
        self.root.addChild(seen)
        self.add(KEY_COLOUR, 0.6, self.copies)
        self.paint = self.add(MOVING_COLOUR, 0.35, self.moving, shape)

    def show_clash(self, on):
        """Shows the moving part in red (on), or in its usual colour."""
        self.paint.diffuseColor = CLASH_COLOUR if on else MOVING_COLOUR

    def show_keys(self, placements):
        # Coin multiplies row vectors, so it needs the transposes.
        rows = [matrix_of(p).T.ravel() for p in placements]
        surface.fill(self.copies.matrix, np.array(rows, np.float32).reshape(-1, 16))

    def show_path(self, poses, interpolation):
        """Draws the path as a line with frames."""
        self.path_lines.show(poses, interpolation)

    def show_moving(self, placement):
        self.moving.matrix = _matrix(placement)


def _matrix(placement):
    """Converts a placement for Coin, which multiplies row vectors and needs the transpose."""
    from pivy import coin

    return coin.SbMatrix(*[float(x) for x in matrix_of(placement).T.ravel()])
