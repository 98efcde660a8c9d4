# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawing of a clearance check: the moving part at the moment of one row with the shortest line,
and the distances as colours on the envelope."""
import FreeCAD as App
import FreeCADGui as Gui
import numpy as np

from .. import convert
from ..features import clearance
from ..features.clearance_plan import envelope_arrays
from ..texts import translate
from .base import View, verdict_icon

#: Colours of the bands: clash, contact, below required, clear.
BANDS = ((0.80, 0.05, 0.10), (0.98, 0.45, 0.05), (0.98, 0.85, 0.15), (0.20, 0.65, 0.35))
GHOST, LINE = (0.20, 0.70, 0.30), (0.85, 0.0, 0.6)


def band_of(distance, contact, required):
    """Returns the index in BANDS of a distance (mm)."""
    if distance <= 0:
        return 0
    if distance <= contact:
        return 1
    return 2 if distance < required else 3


class ClearanceView(View):
    """View provider of the clearance check."""

    PARENTS = ("Envelope", "Motion")
    EDITOR = "SweptVolume_Clearance"

    def attach(self, view):
        from pivy import coin

        super().attach(view)
        self.root = coin.SoSeparator()
        self.colours = coin.SoSeparator()
        self.row = coin.SoSeparator()
        self.root.addChild(self.colours)
        self.root.addChild(self.row)
        view.addDisplayMode(self.root, "Result")

    def getDisplayModes(self, view):
        return ["Result"]

    def getDefaultDisplayMode(self):
        return "Result"

    def setDisplayMode(self, mode):
        return mode

    def getIcon(self):
        verdict = self.Object.Verdict
        if not verdict:  # computed by a version without rules
            near = self.Object.Smallest.Value < self.Object.RequiredDistance.Value
            verdict = "below" if near else "clear"
            verdict = "clash" if self.Object.Smallest.Value <= 0 else verdict
        return verdict_icon("SweptVolume_Clearance", self.Object, verdict)

    def setupContextMenu(self, view, menu):
        commands = (
            (translate("SweptVolume", "Check clearance"), self.EDITOR),
            (translate("SweptVolume", "Export report..."), "SweptVolume_ExportReport"),
        )
        self.add_commands(menu, view.Object, commands)

    def clear(self):
        """Removes the drawing, as after opening a document."""
        if hasattr(self, "row"):
            self.row.removeAllChildren()
            self.colours.removeAllChildren()

    def show_row(self, obj, index, zoom=True):
        """Shows the moving part as a ghost at the moment of a row, with the shortest line."""
        self.row.removeAllChildren()
        found = clearance.report_of(obj)["neighbours"][index]
        plan = clearance.Plan.of(obj)
        request_pose = found["pose"]
        into_base = plan.moving().into_base()
        body = convert.body_from(plan.pairs, plan.seen_deflection())
        pose = convert.placements_from(
            [request_pose["translation"]], [request_pose["quaternion_xyzw"]]
        )[0]
        points = convert.transform(convert.matrix_of(pose) @ into_base, body.vertices)
        self.row.addChild(_surface(points, body.triangles, [GHOST], None, 0.45))
        a, b = found["point_on_body"], found["point_on_neighbour"]
        if any(a) or any(b):
            self.row.addChild(_line(a, b))
        if zoom:
            zoom_to(points, found)

    def show_colours(self, obj, contact, required):
        """Shows the envelope in bands of distance. Returns False if there is nothing to colour."""
        self.colours.removeAllChildren()
        if obj.Envelope is None or not obj.MapDistances:
            return False
        points, triangles = envelope_arrays(obj.Envelope)
        if len(points) != len(obj.MapDistances):
            return False
        bands = [band_of(d, contact, required) for d in obj.MapDistances]
        self.colours.addChild(_surface(points, triangles, BANDS, bands, 0.0))
        return True

    def hide_row(self):
        self.row.removeAllChildren()

    def hide_colours(self):
        self.colours.removeAllChildren()


def _surface(points, triangles, colours, which, transparency):
    """Returns a surface in one colour, or with one of `colours` at each point."""
    from pivy import coin

    group = coin.SoSeparator()
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.creaseAngle = 0.5
    shade, binding = coin.SoMaterial(), coin.SoMaterialBinding()
    shade.diffuseColor.setValues(0, len(colours), [tuple(c) for c in colours])
    shade.transparency = transparency
    where, faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
    where.point.setValues(0, len(points), [tuple(map(float, p)) for p in points])
    indices = np.full((len(triangles), 4), -1, dtype=int)
    indices[:, :3] = triangles
    flat = indices.ravel().tolist()
    faces.coordIndex.setValues(0, len(flat), flat)
    if which is None:
        # Draws the ghost in front of the colours where both coincide.
        nearer = coin.SoPolygonOffset()
        nearer.factor, nearer.units = -1.0, -1.0
        group.addChild(nearer)
    else:
        binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
        bands = np.append(np.asarray(which, dtype=int), -1)
        chosen = bands[indices].ravel().tolist()
        faces.materialIndex.setValues(0, len(chosen), chosen)
    for node in (hints, shade, binding, where, faces):
        group.addChild(node)
    return group


def _line(a, b):
    from pivy import coin

    group = coin.SoAnnotation()  # in front of everything, because the line often lies inside a gap
    light, shade, style = coin.SoLightModel(), coin.SoBaseColor(), coin.SoDrawStyle()
    light.model = coin.SoLightModel.BASE_COLOR
    shade.rgb = LINE
    style.lineWidth, style.pointSize = 4.0, 9.0
    where, line, ends = coin.SoCoordinate3(), coin.SoLineSet(), coin.SoPointSet()
    where.point.setValues(0, 2, [tuple(a), tuple(b)])
    line.numVertices.setValue(2)
    for node in (light, shade, style, where, line, ends):
        group.addChild(node)
    return group


def zoom_to(points, found):
    """Moves the camera to the shortest line, and shows about the size of the body around it."""
    middle = [(p + q) / 2.0 for p, q in zip(found["point_on_body"], found["point_on_neighbour"])]
    size = max(float((points.max(axis=0) - points.min(axis=0)).max()) * 1.8, 4 * found["distance"])
    _look_at(middle, size)
    App.Console.PrintLog("clearance: looking at {}\n".format(found["name"]))


def zoom_to_box(points):
    """Moves the camera to the box of points (k,3), with as much space around it."""
    points = np.asarray(points, dtype=float)
    low, high = points.min(axis=0), points.max(axis=0)
    _look_at(0.5 * (low + high), max(2.5 * float((high - low).max()), 1e-3))


def _look_at(middle, size):
    """Moves the camera in front of a point so that a length `size` (mm) around it is visible."""
    from pivy import coin

    document = Gui.ActiveDocument
    view = document.ActiveView if document is not None else None
    if view is None or not hasattr(view, "getCameraNode"):
        return
    camera = view.getCameraNode()
    forward = view.getViewDirection()
    camera.position.setValue(
        coin.SbVec3f(*[float(m - 2 * size * f) for m, f in zip(middle, forward)])
    )
    camera.focalDistance.setValue(2 * size)
    if camera.isOfType(coin.SoOrthographicCamera.getClassTypeId()):
        camera.height.setValue(size)
