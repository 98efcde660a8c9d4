// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/shape_check.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <atomic>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>
#include <optional>

namespace swept::step {
namespace {

using Corners = std::array<gp_Pnt, 3>;

// Returns whether the curve of the edge is the straight segment from its first to its last vertex.
bool isStraight(const TopoDS_Edge& edge, const TopoDS_Vertex& first, const TopoDS_Vertex& last) {
  double from = 0, to = 0;
  const Handle(Geom_Line) line = Handle(Geom_Line)::DownCast(BRep_Tool::Curve(edge, from, to));
  if (line.IsNull() || !(to > from)) return false;
  const double slack = BRep_Tool::Tolerance(edge);
  return line->Value(from).Distance(BRep_Tool::Pnt(first)) <= slack + BRep_Tool::Tolerance(first) &&
         line->Value(to).Distance(BRep_Tool::Pnt(last)) <= slack + BRep_Tool::Tolerance(last);
}

// Returns the corners of a valid plane triangle, counter-clockwise seen from outside. Returns
// nothing for any other face.
std::optional<Corners> triangleOf(const TopoDS_Face& face) {
  const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face));
  if (plane.IsNull()) return std::nullopt;
  TopoDS_Iterator wire(face);
  if (!wire.More()) return std::nullopt;
  const TopoDS_Shape loop = wire.Value();
  wire.Next();
  if (wire.More()) return std::nullopt;
  std::array<TopoDS_Vertex, 3> start, end;
  std::size_t count = 0;
  for (TopoDS_Iterator it(loop); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Value());
    if (count == 3) return std::nullopt;
    start[count] = TopExp::FirstVertex(edge, true);
    end[count] = TopExp::LastVertex(edge, true);
    if (start[count].IsNull() || end[count].IsNull()) return std::nullopt;
    const TopoDS_Edge own = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    if (!isStraight(own, TopExp::FirstVertex(own), TopExp::LastVertex(own))) return std::nullopt;
    ++count;
  }
  if (count != 3) return std::nullopt;
  // The file may list the edges in the opposite order.
  if (!end[0].IsSame(start[1])) {
    std::swap(start[1], start[2]);
    std::swap(end[1], end[2]);
  }
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!end[k].IsSame(start[(k + 1) % 3])) return std::nullopt;
    corners[k] = BRep_Tool::Pnt(start[k]);
    const double slack = BRep_Tool::Tolerance(start[k]) + BRep_Tool::Tolerance(face);
    if (plane->Pln().Distance(corners[k]) > slack) return std::nullopt;
  }
  const gp_Vec area = gp_Vec(corners[0], corners[1]).Crossed(gp_Vec(corners[0], corners[2]));
  gp_Vec normal(plane->Pln().Axis().Direction());
  if (!plane->Pln().Direct()) normal.Reverse();
  if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
  if (!(area.Dot(normal) > 0)) return std::nullopt;
  return corners;
}

// Returns the volume of the cone from `base` over the face of an extrusion; nothing for other
// faces. The kernel's quadrature does not follow the spans of a spline and would be wrong by half a
// percent. The contribution of a point to the volume does not change along the direction of
// extrusion, so an integral along the border suffices.
std::optional<double> volumeUnderExtrusion(const TopoDS_Face& face, const gp_Pnt& base) {
  const auto surface = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(BRep_Tool::Surface(face));
  if (surface.IsNull()) return std::nullopt;
  const Handle(Geom_Curve) profile = surface->BasisCurve();
  const gp_Vec direction(surface->Direction());
  constexpr int kPanels = 400;
  const std::array<double, 3> nodes{-std::sqrt(0.6), 0, std::sqrt(0.6)}, weights{5, 8, 5};
  double sum = 0;
  for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double from = 0, to = 0;
    const Handle(Geom2d_Curve) flat = BRep_Tool::CurveOnSurface(edge, face, from, to);
    if (flat.IsNull()) return std::nullopt;
    const double side = edge.Orientation() == TopAbs_REVERSED ? 1 : -1;
    const double half = (to - from) / kPanels / 2;
    for (int i = 0; i < kPanels; ++i) {
      for (int k = 0; k < 3; ++k) {
        gp_Pnt2d foot;
        gp_Vec2d tangent;
        flat->D1(from + half * (2 * i + 1 + nodes[k]), foot, tangent);
        gp_Pnt at;
        gp_Vec along;
        profile->D1(foot.X(), at, along);
        const double height = gp_Vec(base, at).Dot(along.Crossed(direction)) / 3;
        sum += side * half * weights[k] / 9 * foot.Y() * height * tangent.X();
      }
    }
  }
  return face.Orientation() == TopAbs_REVERSED ? -sum : sum;
}

// Returns the signed volume of the cone from `base` over the face. The sum over all faces of a
// solid is the volume of the solid.
double volumeUnder(const TopoDS_Face& face, const gp_Pnt& base) {
  if (const auto corners = triangleOf(face)) {
    const gp_Vec a(base, (*corners)[0]), b(base, (*corners)[1]), c(base, (*corners)[2]);
    return a.Dot(b.Crossed(c)) / 6;
  }
  if (const auto volume = volumeUnderExtrusion(face, base)) return *volume;
  BRepGProp_Face surface(face);
  BRepGProp_Domain domain(face);
  BRepGProp_Vinert inertia;
  inertia.SetLocation(base);
  inertia.Perform(surface, domain);
  return inertia.Mass();
}

// Calls work(i) for all i in [0, count) in parallel, with a checkpoint after each block.
template <class Work>
void parallelFaces(std::size_t count, RunContext& run, double from, double to, const Work& work) {
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 32), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
    const double part = static_cast<double>(done += range.size()) / static_cast<double>(count);
    run.checkpoint(Phase::Export, static_cast<std::uint64_t>(1e6 * (from + (to - from) * part)),
                   1000000);
  });
}

// Returns an empty text if the shell is closed (every edge is used twice) and oriented (once in
// each direction), otherwise the fault. The kernel's own check of a shell tests the same and takes
// ten times as long.
std::string shellComplaint(const TopoDS_Shape& shell) {
  TopTools_IndexedMapOfShape edges;
  std::vector<std::array<std::int32_t, 2>> uses;
  for (TopExp_Explorer it(shell, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    const auto index = static_cast<std::size_t>(edges.Add(edge));
    if (index > uses.size()) uses.push_back({0, 0});
    ++uses[index - 1][edge.Orientation() == TopAbs_REVERSED];
  }
  for (const auto& [forward, reversed] : uses) {
    if (forward + reversed != 2) return "a shell is not closed";
    if (forward != reversed) return "a shell is not oriented";
  }
  return uses.empty() ? "a shell has no edges" : std::string();
}

}  // namespace

bool isPlaneTriangle(const TopoDS_Face& face) { return triangleOf(face).has_value(); }

std::vector<std::int32_t> findBadFaces(const std::vector<TopoDS_Shape>& faces, RunContext& run,
                                       double from, double to) {
  std::vector<char> bad(faces.size(), 0);
  parallelFaces(faces.size(), run, from, to, [&](std::size_t i) {
    if (triangleOf(TopoDS::Face(faces[i]))) return;
    const BRepCheck_Analyzer analyzer(faces[i]);
    bad[i] = !analyzer.IsValid();
  });
  std::vector<std::int32_t> result;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    if (bad[i]) result.push_back(static_cast<std::int32_t>(i));
  }
  return result;
}

SolidCheck checkShape(const TopoDS_Shape& shape, RunContext& run, double from, double to) {
  SolidCheck check;
  if (shape.IsNull()) {
    check.complaint = "no shape";
    return check;
  }
  TopTools_IndexedMapOfShape faceMap, edgeMap, vertexMap;
  TopExp::MapShapes(shape, TopAbs_FACE, faceMap);
  TopExp::MapShapes(shape, TopAbs_EDGE, edgeMap);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertexMap);
  for (int i = 1; i <= edgeMap.Extent(); ++i) {
    check.edgeTolerance =
        std::max(check.edgeTolerance, BRep_Tool::Tolerance(TopoDS::Edge(edgeMap(i))));
  }
  for (int i = 1; i <= vertexMap.Extent(); ++i) {
    check.edgeTolerance =
        std::max(check.edgeTolerance, BRep_Tool::Tolerance(TopoDS::Vertex(vertexMap(i))));
  }
  check.faces = faceMap.Extent();
  check.edges = edgeMap.Extent();
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) ++check.solids;
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_SHELL); it.More(); it.Next()) {
    ++check.shells;
    const std::string complaint = shellComplaint(it.Current());
    if (!complaint.empty()) check.complaint = complaint;
    // Each face keeps its orientation in the solid, because the volume depends on it.
    for (TopExp_Explorer f(it.Current(), TopAbs_FACE); f.More(); f.Next())
      faces.push_back(f.Current());
  }
  const std::vector<std::int32_t> bad = findBadFaces(faces, run, from, (from + to) / 2);
  if (!bad.empty()) check.complaint = std::to_string(bad.size()) + " faces are not valid";
  // The volume is computed relative to a point of the shape. Relative to a distant origin, it would
  // lose digits.
  gp_Pnt base;
  if (edgeMap.Extent() > 0) base = BRep_Tool::Pnt(TopExp::FirstVertex(TopoDS::Edge(edgeMap(1))));
  std::vector<double> volumes(faces.size());
  parallelFaces(faces.size(), run, (from + to) / 2, to,
                [&](std::size_t i) { volumes[i] = volumeUnder(TopoDS::Face(faces[i]), base); });
  for (const double v : volumes) check.volume += v;
  check.valid = check.complaint.empty() && check.solids > 0;
  if (check.solids == 0 && check.complaint.empty()) check.complaint = "no solid";
  return check;
}

}  // namespace swept::step
