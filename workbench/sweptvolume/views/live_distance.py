# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shortest line from a part to its nearest neighbour, with the distance beside the dragger."""
import FreeCAD as App
import numpy as np

from .ghost import Overlay
from .surface import fill

#: Colours of the line, of the text on a dark background, and on a light one: for parts that are
#: apart, and for a clash.
APART = (0.85, 0.0, 0.6), (1.0, 0.95, 0.45), (0.4, 0.0, 0.28)
CLASH = (0.95, 0.05, 0.1), (1.0, 1.0, 1.0), (0.6, 0.0, 0.0)
#: FreeCAD's preferences for the background of the 3D view, and their values in a fresh profile
#: (red, green, blue, alpha in 32 bits).
_PLAIN, _GRADIENT = {"BackgroundColor": 3940932863}, {
    "BackgroundColor2": 859006463,
    "BackgroundColor3": 2543364607,
}
#: In pixels: size of the text and width of the line. The blanks keep the text away from the
#: dragger.
TEXT, LINE, BESIDE = 17, 3.0, "     "


def on_light():
    """Returns whether the 3D view has a light background."""
    view = App.ParamGet("User parameter:BaseApp/Preferences/View")
    names = _PLAIN if view.GetBool("Simple", False) else _GRADIENT
    colours = [view.GetUnsigned(name, known) for name, known in names.items()]
    parts = [c >> shift & 255 for c in colours for shift in (24, 16, 8)]
    return sum(parts) > 128 * len(parts)


class LiveDistance(Overlay):
    """Not drawn before the first show()."""

    def __init__(self, document):
        from pivy import coin

        super().__init__(document)
        self.shown, seen = coin.SoSwitch(), coin.SoAnnotation()  # visible through the parts
        light = coin.SoLightModel()
        light.model = coin.SoLightModel.BASE_COLOR
        self.line_colour, self.text_colour = coin.SoBaseColor(), coin.SoBaseColor()
        style, font = coin.SoDrawStyle(), coin.SoFont()
        style.lineWidth = LINE
        font.size, font.name = TEXT, "Arial:Bold"
        self.ends, self.lines = coin.SoCoordinate3(), coin.SoLineSet()
        self.text_position, self.text = coin.SoTranslation(), coin.SoText2()
        line, text = coin.SoSeparator(), coin.SoSeparator()
        for node in (self.line_colour, style, self.ends, self.lines):
            line.addChild(node)
        for node in (self.text_colour, font, self.text_position, self.text):
            text.addChild(node)
        for node in (light, line, text):
            seen.addChild(node)
        self.shown.addChild(seen)
        self.root.addChild(self.shown)

    def show(self, at, text, points, clash):
        """Shows text (lines) at a point, and a line between two points (None: no line)."""
        line, *letters = CLASH if clash else APART
        self.line_colour.rgb, self.text_colour.rgb = line, letters[on_light()]
        self.text_position.translation = tuple(at)
        self.text.string.setValues(0, len(text), [BESIDE + part for part in text])
        drawn = points[0] is not None
        fill(self.ends.point, np.array(points if drawn else np.zeros((0, 3)), np.float32))
        fill(self.lines.numVertices, np.array([2] if drawn else [0], np.int32))
        self.shown.whichChild = -3  # -3: all children

    def show_between(self, ends, text, clash):
        """Shows a line with a text ("": no text) at its middle."""
        middle = [(a + b) / 2.0 for a, b in zip(*ends)]
        self.show(middle, [text] if text else [], ends, clash)

    def hide(self):
        self.shown.whichChild = -1
