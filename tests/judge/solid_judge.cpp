// SPDX-License-Identifier: LGPL-2.1-or-later
#include "judge/solid_judge.h"

#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <BOPAlgo_CheckResult.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Elips.hxx>
#include <sstream>
#include <stdexcept>

namespace swept::test {
namespace {

const char* nameOf(BOPAlgo_CheckStatus status) {
  switch (status) {
    case BOPAlgo_BadType:
      return "BadType";
    case BOPAlgo_SelfIntersect:
      return "SelfIntersect";
    case BOPAlgo_TooSmallEdge:
      return "TooSmallEdge";
    case BOPAlgo_NonRecoverableFace:
      return "NonRecoverableFace";
    case BOPAlgo_IncompatibilityOfVertex:
      return "IncompatibilityOfVertex";
    case BOPAlgo_IncompatibilityOfEdge:
      return "IncompatibilityOfEdge";
    case BOPAlgo_IncompatibilityOfFace:
      return "IncompatibilityOfFace";
    case BOPAlgo_OperationAborted:
      return "OperationAborted";
    case BOPAlgo_GeomAbs_C0:
      return "Continuity";
    case BOPAlgo_InvalidCurveOnSurface:
      return "InvalidCurveOnSurface";
    default:
      return "Unknown";
  }
}

std::string describe(const TopoDS_Shape& shape) {
  constexpr std::array<const char*, 11> kSurfaces{
      "plane",    "cylinder",   "cone",      "sphere", "torus",        "bezier",
      "b-spline", "revolution", "extrusion", "offset", "other surface"};
  constexpr std::array<const char*, 9> kCurves{"line",      "circle",   "ellipse",
                                               "hyperbola", "parabola", "bezier",
                                               "b-spline",  "offset",   "other curve"};
  std::ostringstream text;
  if (shape.ShapeType() == TopAbs_FACE) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    text << kSurfaces[BRepAdaptor_Surface(TopoDS::Face(shape)).GetType()] << " of "
         << edges.Extent() << " edges";
  } else if (shape.ShapeType() == TopAbs_EDGE) {
    const TopoDS_Edge& edge = TopoDS::Edge(shape);
    text << kCurves[BRepAdaptor_Curve(edge).GetType()] << " (tolerance "
         << BRep_Tool::Tolerance(edge) << ")";
  } else if (shape.ShapeType() == TopAbs_VERTEX) {
    text << "vertex (tolerance " << BRep_Tool::Tolerance(TopoDS::Vertex(shape)) << ")";
  } else {
    text << "shape";
  }
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  if (!box.IsVoid()) {
    const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
    text << " at " << (low.X() + high.X()) / 2 << " " << (low.Y() + high.Y()) / 2 << " "
         << (low.Z() + high.Z()) / 2 << " size " << low.Distance(high);
  }
  return text.str();
}

// Searches for faults with the settings of FreeCAD's check, TaskCheckGeometry and
// TopoShape::analyze.
void findFaults(const TopoDS_Shape& shape, std::size_t detailCount, JudgedSolid& judged) {
  BOPAlgo_ArgumentAnalyzer analyzer;
  analyzer.SetShape1(BRepBuilderAPI_Copy(shape).Shape());
  analyzer.ArgumentTypeMode() = true;
  analyzer.SelfInterMode() = true;
  analyzer.SmallEdgeMode() = true;
  analyzer.RebuildFaceMode() = true;
  analyzer.ContinuityMode() = true;
  analyzer.TangentMode() = true;
  analyzer.MergeVertexMode() = true;
  analyzer.MergeEdgeMode() = true;
  analyzer.CurveOnSurfaceMode() = true;
  analyzer.SetRunParallel(true);
  analyzer.Perform();
  std::map<std::string, TopTools_IndexedMapOfShape> taking;
  for (const BOPAlgo_CheckResult& result : analyzer.GetCheckResult()) {
    const char* name = nameOf(result.GetCheckStatus());
    std::string words = name;
    for (const TopoDS_Shape& part : result.GetFaultyShapes1()) {
      taking[name].Add(part);
      words += "; " + describe(part);
    }
    if (result.GetFaultyShapes1().IsEmpty()) taking[name].Add(shape);
    if (judged.details.size() < detailCount) judged.details.push_back(words);
  }
  for (const auto& [name, parts] : taking) judged.faults[name] = parts.Extent();
}

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.Mass();
}

double blockError(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  // The block ends in the middle of the solid along its longest side. Its other faces lie at
  // uneven positions around the solid.
  const std::array<double, 3> size{high.X() - low.X(), high.Y() - low.Y(), high.Z() - low.Z()};
  const auto longest = std::max_element(size.begin(), size.end()) - size.begin();
  std::array<double, 3> from{low.X() - 0.031 * size[0], low.Y() - 0.047 * size[1],
                             low.Z() - 0.053 * size[2]},
      to{high.X() + 0.037 * size[0], high.Y() + 0.041 * size[1], high.Z() + 0.059 * size[2]};
  to[longest] -= 0.5213 * size[longest];
  const TopoDS_Shape block =
      BRepPrimAPI_MakeBox(gp_Pnt(from[0], from[1], from[2]), gp_Pnt(to[0], to[1], to[2]));
  TopTools_ListOfShape blocks, tools;
  blocks.Append(block);
  tools.Append(shape);
  double sum = 0;
  BRepAlgoAPI_Cut cut;
  BRepAlgoAPI_Common common;
  for (BRepAlgoAPI_BooleanOperation* operation :
       std::initializer_list<BRepAlgoAPI_BooleanOperation*>{&cut, &common}) {
    operation->SetArguments(blocks);
    operation->SetTools(tools);
    operation->SetRunParallel(true);
    operation->Build();
    if (operation->HasErrors() || operation->Shape().IsNull()) return -1;
    sum += volumeOf(operation->Shape());
  }
  return std::abs(sum / volumeOf(block) - 1);
}

}  // namespace

namespace {

void writeBrep(const TopoDS_Shape& shape, const std::string& path) {
  if (!BRepTools::Write(shape, path.c_str())) throw std::runtime_error("cannot write " + path);
}

// Returns an edge all of whose points have this z.
TopoDS_Edge circleAt(const TopoDS_Shape& shape, double z) {
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    if (curve.GetType() == GeomAbs_Circle && std::abs(curve.Value(first).Z() - z) < 1e-9 &&
        std::abs(curve.Value((first + last) / 2).Z() - z) < 1e-9)
      return TopoDS::Edge(it.Current());
  }
  throw std::runtime_error("no circle");
}

}  // namespace

void writeRod(double radius, double length, const std::string& path) {
  writeBrep(BRepPrimAPI_MakeCylinder(radius, length).Shape(), path);
}

void writeRodWithChamfers(double radius, double length, double chamfer, const std::string& path) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(radius, length).Shape();
  BRepFilletAPI_MakeChamfer maker(rod);
  for (const double z : {0.0, length}) maker.Add(chamfer, circleAt(rod, z));
  writeBrep(maker.Shape(), path);
}

void writeCone(double bottomRadius, double topRadius, double length, const std::string& path) {
  writeBrep(BRepPrimAPI_MakeCone(bottomRadius, topRadius, length).Shape(), path);
}

void writeRodWithChamferAndFillet(double radius, double length, const std::string& path) {
  constexpr double kChamfer = 1, kFillet = 1.5;
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(radius, length).Shape();
  BRepFilletAPI_MakeChamfer chamfer(rod);
  chamfer.Add(kChamfer, circleAt(rod, 0));
  const TopoDS_Shape chamfered = chamfer.Shape();
  BRepFilletAPI_MakeFillet fillet(chamfered);
  fillet.Add(kFillet, circleAt(chamfered, length));
  writeBrep(fillet.Shape(), path);
}

void writeEllipticRod(double majorRadius, double minorRadius, double length,
                      const std::string& path) {
  const gp_Elips base(gp::XOY(), majorRadius, minorRadius);
  const TopoDS_Shape face =
      BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(base)).Wire());
  writeBrep(BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, length)).Shape(), path);
}

TopoDS_Shape readShape(const std::string& path) {
  TopoDS_Shape shape;
  if (path.ends_with(".brep") || path.ends_with(".brp")) {
    BRepTools::Read(shape, path.c_str(), BRep_Builder());
  } else {
    STEPControl_Reader reader;
    if (reader.ReadFile(path.c_str()) == IFSelect_RetDone) {
      reader.TransferRoots();
      shape = reader.OneShape();
    }
  }
  if (shape.IsNull()) throw std::runtime_error("the kernel reads no shape from " + path);
  return shape;
}

void writeRoundedBlock(const std::string& path) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(30, 20, 10).Shape();
  const gp_Ax2 axes(gp_Pnt(10, 9, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(axes, 4, 10).Shape();
  const TopoDS_Shape body = BRepAlgoAPI_Cut(block, hole).Shape();
  BRepFilletAPI_MakeFillet rounder(body);
  for (TopExp_Explorer it(body, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRepAdaptor_Curve(edge).GetType() == GeomAbs_Line) rounder.Add(2, edge);
  }
  BRepTools::Write(rounder.Shape(), path.c_str());
}

void writeBall(double radius, const std::string& path) {
  BRepTools::Write(BRepPrimAPI_MakeSphere(radius).Shape(), path.c_str());
}

void writeHalfBall(double radius, const std::string& path) {
  BRepTools::Write(BRepPrimAPI_MakeSphere(radius, 0, M_PI / 2).Shape(), path.c_str());
}

void writeBlockWithRoundTop(double length, double width, double height, double radius,
                            const std::string& path) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(length, width, height).Shape();
  BRepFilletAPI_MakeFillet fillet(block);
  for (TopExp_Explorer it(block, TopAbs_EDGE); it.More(); it.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
    const gp_Pnt first = curve.Value(curve.FirstParameter()),
                 last = curve.Value(curve.LastParameter());
    if (std::min(first.Z(), last.Z()) == height) fillet.Add(radius, TopoDS::Edge(it.Current()));
  }
  writeBrep(fillet.Shape(), path);
}

void writeRing(double radius, double tube, const std::string& path) {
  BRepTools::Write(BRepPrimAPI_MakeTorus(radius, tube).Shape(), path.c_str());
}

void writeElbow(double radius, double tube, const std::string& path) {
  writeBrep(BRepPrimAPI_MakeTorus(radius, tube, M_PI / 2).Shape(), path);
}

void writeSteppedRod(double flange, double radius, const std::string& path) {
  const double height = flange / 3;
  const TopoDS_Shape plate = BRepPrimAPI_MakeCylinder(flange, height).Shape();
  const gp_Ax2 above(gp_Pnt(0, 0, height), gp::DZ());
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(above, radius, 2 * radius).Shape();
  writeBrep(BRepAlgoAPI_Fuse(plate, rod).Shape(), path);
}

JudgedSolid judgeSolid(const TopoDS_Shape& shape, std::size_t detailCount, bool withBlock) {
  JudgedSolid judged;
  judged.valid = BRepCheck_Analyzer(shape).IsValid();
  TopTools_IndexedMapOfShape solids, faces, edges, vertices;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  judged.solids = solids.Extent();
  judged.faces = faces.Extent();
  judged.edges = edges.Extent();
  for (int i = 1; i <= edges.Extent(); ++i)
    judged.edgeTolerance =
        std::max(judged.edgeTolerance, BRep_Tool::Tolerance(TopoDS::Edge(edges(i))));
  for (int i = 1; i <= vertices.Extent(); ++i)
    judged.vertexTolerance =
        std::max(judged.vertexTolerance, BRep_Tool::Tolerance(TopoDS::Vertex(vertices(i))));
  judged.volume = volumeOf(shape);
  findFaults(shape, detailCount, judged);
  if (withBlock) judged.blockError = blockError(shape);
  return judged;
}

}  // namespace swept::test
