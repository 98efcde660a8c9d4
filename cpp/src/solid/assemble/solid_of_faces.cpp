// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/solid_of_faces.h"

#include <BOPTools_AlgoTools.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>

#include "solid/assemble/divide_faces.h"

namespace swept::step {
namespace {

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

// Returns the face on a plane if its surface is a plane B-spline.
TopoDS_Face onPlane(const TopoDS_Face& face) {
  constexpr double kPlane = 1e-8;  // mm
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (Handle(Geom_BSplineSurface)::DownCast(surface).IsNull()) return face;
  const GeomLib_IsPlanarSurface test(surface, kPlane);
  if (!test.IsPlanar()) return face;
  double u0, u1, v0, v1;
  surface->Bounds(u0, u1, v0, v1);
  gp_Pnt p;
  gp_Vec alongU, alongV;
  surface->D1((u0 + u1) / 2, (v0 + v1) / 2, p, alongU, alongV);
  const gp_Pln plane(gp_Ax3(p, gp_Dir(alongU.Crossed(alongV)), gp_Dir(alongU)));
  const BRep_Builder builder;
  TopoDS_Face result;
  builder.MakeFace(result, new Geom_Plane(plane), BRep_Tool::Tolerance(face));
  for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next())
    builder.Add(result, wire.Value());
  return TopoDS::Face(result.Oriented(face.Orientation()));
}

// Returns the edges between faces that are certainly not on one surface. It takes the kernel some
// time to compare two splines.
TopTools_MapOfShape edgesBetweenSurfaces(const TopoDS_Shape& shape) {
  const auto isSpline = [](const Handle(Geom_Surface) & surface) {
    return surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface));
  };
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
  TopTools_MapOfShape between;
  for (int e = 1; e <= edges.Extent(); ++e) {
    if (edges(e).Extent() != 2) continue;
    const Handle(Geom_Surface) a = BRep_Tool::Surface(TopoDS::Face(edges(e).First())),
                               b = BRep_Tool::Surface(TopoDS::Face(edges(e).Last()));
    if (a != b && (isSpline(a) || isSpline(b))) between.Add(edges.FindKey(e));
  }
  return between;
}

struct Solids {
  TopoDS_Shape shape;
  double volume = 0;
};

// Makes one solid for each outer shell. Cavities are shells with a negative volume.
Solids solidsOf(const std::vector<TopoDS_Face>& faces) {
  const BRep_Builder builder;
  std::vector<TopoDS_Face> simple;
  for (const TopoDS_Face& face : faces) simple.push_back(onPlane(face));
  TopTools_ListOfShape blocks;
  BOPTools_AlgoTools::MakeConnexityBlocks(compoundOf(simple), TopAbs_EDGE, TopAbs_FACE, blocks);
  Solids result;
  std::vector<TopoDS_Solid> solids;
  std::vector<TopoDS_Shell> cavities;
  for (const TopoDS_Shape& block : blocks) {
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (TopExp_Explorer face(block, TopAbs_FACE); face.More(); face.Next())
      builder.Add(shell, face.Current());
    shell.Closed(Standard_True);
    const double volume = volumeOf(shell);
    result.volume += volume;
    if (volume < 0) {
      cavities.push_back(shell);
      continue;
    }
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    solids.push_back(solid);
  }
  if (solids.empty() || (!cavities.empty() && solids.size() > 1)) return {};
  for (const TopoDS_Shell& cavity : cavities) builder.Add(solids.front(), cavity);
  if (solids.size() == 1) {
    result.shape = solids.front();
    return result;
  }
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Solid& solid : solids) builder.Add(all, solid);
  result.shape = all;
  return result;
}

// Raises the tolerances of vertices until they contain the ends of all parameter curves, if these
// are not too far away.
void coverEnds(const TopoDS_Shape& shape, double farthest) {
  const BRep_Builder builder;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
    const TopoDS_Face& face = TopoDS::Face(f.Current());
    const BRepAdaptor_Surface surface(face, Standard_False);
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(e.Current().Oriented(TopAbs_FORWARD));
      double from, to;
      const Handle(Geom2d_Curve) on = BRep_Tool::CurveOnSurface(edge, face, from, to);
      if (on.IsNull()) continue;
      for (const bool isFirst : {true, false}) {
        const TopoDS_Vertex vertex = isFirst ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
        const gp_Pnt2d end = on->Value(isFirst ? from : to);
        const double off = surface.Value(end.X(), end.Y()).Distance(BRep_Tool::Pnt(vertex));
        // Twice, as two ends are compared with each other.
        if (2 * off > BRep_Tool::Tolerance(vertex) && off < farthest)
          builder.UpdateVertex(vertex, 2 * off + Precision::Confusion());
      }
    }
  }
}

// Returns the solids, repaired if necessary; a null shape if they cannot be made valid.
TopoDS_Shape repaired(const TopoDS_Shape& solids) {
  // mm: parameter curves may miss the vertices at their ends by rounding errors.
  constexpr double kMaxTolerance = 1e-4;
  const TopTools_IndexedMapOfShape none;
  BOPTools_AlgoTools::CorrectTolerances(solids, none, kMaxTolerance);
  if (BRepCheck_Analyzer(solids).IsValid()) return solids;
  coverEnds(solids, kMaxNear);
  if (BRepCheck_Analyzer(solids).IsValid()) return solids;
  ShapeFix_Shape mender(solids);
  mender.Perform();
  const TopoDS_Shape mended = mender.Shape();
  const bool isRight = countOf(mended, TopAbs_SOLID) == countOf(solids, TopAbs_SOLID) &&
                       BRepCheck_Analyzer(mended).IsValid();
  return isRight ? mended : TopoDS_Shape();
}

}  // namespace

int countOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

double sizeOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent());
}

TopoDS_Compound compoundOf(const std::vector<TopoDS_Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Face& face : faces) builder.Add(all, face);
  return all;
}

std::vector<TopoDS_Face> facesIn(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

TopoDS_Shape joined(const TopoDS_Shape& shape, bool withEdges) {
  try {
    ShapeUpgrade_UnifySameDomain faces(shape, Standard_False, Standard_True, Standard_False);
    faces.KeepShapes(edgesBetweenSurfaces(shape));
    faces.Build();
    if (!withEdges) return faces.Shape();
    ShapeUpgrade_UnifySameDomain edges(faces.Shape(), Standard_True, Standard_False,
                                       Standard_False);
    edges.Build();
    return edges.Shape();
  } catch (const Standard_Failure&) {
    return shape;
  }
}

TopoDS_Shape solidOf(const std::vector<TopoDS_Face>& faces, double volume, double accuracy,
                     bool areJoined) {
  const Solids made = solidsOf(faces);
  const TopoDS_Shape& solids = made.shape;
  if (solids.IsNull() || std::abs(made.volume - volume) > accuracy) return {};
  if (!areJoined) {
    const TopoDS_Shape whole = joined(solids, true);
    const TopoDS_Shape solid = repaired(whole);
    if (!solid.IsNull()) return solid;
  }
  return repaired(solids);
}

}  // namespace swept::step
