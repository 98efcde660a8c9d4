// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_Shell.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <ShapeConstruct_ProjectCurveOnSurface.hxx>
#include <ShapeFix_Edge.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <gp_Ax3.hxx>
#include <gp_Vec2d.hxx>
#include <string>

namespace swept::step {
namespace {

constexpr double kKernelTolerance = 1e-7;  // mm, the kernel's own idea of "the same point"

gp_Pnt pointOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
gp_Dir dirOf(const Eigen::Vector3d& d) { return {d.x(), d.y(), d.z()}; }

// Stated tolerance: what was measured and a little for rounding, never below the kernel's own.
double stated(double measured) { return std::max(kKernelTolerance, 1.01 * measured); }

class BrepBuilder {
 public:
  BrepBuilder(const Model& model, RunContext& run) : model_(model), run_(run) {}

  Brep build() {
    makeVertices();
    makeEdges();
    std::vector<TopoDS_Shell> shells(model_.shellOwner.size());
    for (TopoDS_Shell& shell : shells) builder_.MakeShell(shell);
    Brep result;
    result.faces.reserve(model_.faces.size());
    for (const ModelFace& face : model_.faces) {
      if ((result.faces.size() & 1023U) == 0) run_.checkpoint(Phase::Export);
      TopoDS_Face made;
      try {
        made = makeFace(face);
      } catch (const Standard_Failure&) {
        made = TopoDS_Face();
        builder_.MakeFace(made);
        result.failed.push_back(static_cast<std::int32_t>(result.faces.size()));
      }
      builder_.Add(shells[face.shell], made);
      result.faces.push_back(made);
    }
    result.shape = makeSolids(shells);
    return result;
  }

 private:
  void makeVertices() {
    vertices_.resize(model_.vertices.size());
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      builder_.MakeVertex(vertices_[v], pointOf(model_.vertices[v].point),
                          stated(model_.vertices[v].tolerance));
    }
  }

  static Handle(Geom_Curve) curveOf(const Curve& curve) {
    if (curve.kind == CurveKind::Line)
      return new Geom_Line(pointOf(curve.start), dirOf(curve.axis));
    if (curve.kind == CurveKind::Circle) {
      return new Geom_Circle(gp_Ax2(pointOf(curve.start), dirOf(curve.axis), dirOf(curve.xdir)),
                             curve.radius);
    }
    const auto knotCount = static_cast<Standard_Integer>(curve.knots.size());
    TColgp_Array1OfPnt poles(1, static_cast<Standard_Integer>(curve.poles.size()));
    TColStd_Array1OfReal knots(1, knotCount);
    TColStd_Array1OfInteger multiplicities(1, knotCount);
    for (std::size_t i = 0; i < curve.poles.size(); ++i) {
      poles(static_cast<Standard_Integer>(i) + 1) = pointOf(curve.poles[i]);
    }
    for (Standard_Integer i = 1; i <= knotCount; ++i) {
      knots(i) = curve.knots[i - 1];
      multiplicities(i) = i == 1 || i == knotCount ? 4 : 2;
    }
    return new Geom_BSplineCurve(poles, knots, multiplicities, 3);
  }

  static Handle(Geom_Surface) surfaceOf(const Surface& s) {
    const gp_Dir x = dirOf(s.xdir.norm() > 0.5 ? s.xdir : anyOrthogonal(s.axis));
    const gp_Ax3 frame(pointOf(s.point), dirOf(s.axis), x);
    switch (s.kind) {
      case SurfaceKind::Cylinder:
        return new Geom_CylindricalSurface(frame, s.radius);
      case SurfaceKind::Cone:
        return new Geom_ConicalSurface(frame, s.halfAngle, s.radius);
      case SurfaceKind::Sphere:
        return new Geom_SphericalSurface(frame, s.radius);
      case SurfaceKind::Torus:
        return new Geom_ToroidalSurface(frame, s.radius, s.minor);
      default:
        return new Geom_Plane(frame);
    }
  }

  void makeEdges() {
    edges_.resize(model_.edges.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const ModelEdge& edge = model_.edges[e];
      const Eigen::Vector3d a = model_.vertices[edge.start].point;
      // An edge that has no length or no curve stays null; its faces are reported as failed.
      if (!((edge.curve.at(edge.curve.last / 2) - a).norm() > kKernelTolerance)) continue;
      try {
        TopoDS_Edge made;
        builder_.MakeEdge(made, curveOf(edge.curve), stated(edge.tolerance));
        builder_.Add(made, vertices_[edge.start].Oriented(TopAbs_FORWARD));
        builder_.Add(made, vertices_[edge.end].Oriented(TopAbs_REVERSED));
        builder_.Range(made, 0, edge.curve.last);
        edges_[e] = made;
      } catch (const Standard_Failure&) {
        continue;
      }
    }
  }

  TopoDS_Face makeFace(const ModelFace& face) {
    TopoDS_Face made;
    const bool reversed = !face.surface.isPlanar() && face.surface.reversed;
    builder_.MakeFace(made, surfaceOf(face.surface), kKernelTolerance);
    for (const auto& loop : face.loops) {
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      for (const ModelUse& use : loop) {
        if (edges_[use.edge].IsNull()) throw Standard_Failure("edge without a curve");
        builder_.Add(wire,
                     edges_[use.edge].Oriented(use.forward ? TopAbs_FORWARD : TopAbs_REVERSED));
        if (!face.surface.isPlanar()) addParameterCurve(use.edge, face.surface, made);
      }
      wire.Closed(true);
      // In the face's own frame a bore is turned, its loops with it.
      builder_.Add(made, reversed ? wire.Reversed() : wire);
    }
    return reversed ? TopoDS::Face(made.Reversed()) : made;
  }

  // The edge in the surface's parameters, in the period in which the face lies.
  void addParameterCurve(std::int32_t e, const Surface& surface, const TopoDS_Face& face) {
    const Curve& curve = model_.edges[e].curve;
    const Handle(Geom_Surface) geometry = BRep_Tool::Surface(face);
    ShapeConstruct_ProjectCurveOnSurface projector;
    projector.Init(geometry, kKernelTolerance);
    Handle(Geom_Curve) space = curveOf(curve);
    Handle(Geom2d_Curve) flat;
    projector.Perform(space, 0, curve.last, flat);
    if (flat.IsNull()) return;
    const gp_Pnt2d middle = flat->Value(curve.last / 2);
    auto periods = [](double value, double wanted) {
      return std::round((wanted - value) / (2 * M_PI));
    };
    const double u = 2 * M_PI * periods(middle.X(), M_PI);
    const double v =
        surface.kind == SurfaceKind::Torus ? 2 * M_PI * periods(middle.Y(), surface.tubeMid) : 0;
    if (u != 0 || v != 0) flat->Translate(gp_Vec2d(u, v));
    builder_.UpdateEdge(edges_[e], flat, face, stated(model_.edges[e].tolerance));
    ShapeFix_Edge().FixSameParameter(edges_[e]);
  }

  TopoDS_Shape makeSolids(std::vector<TopoDS_Shell>& shells) {
    std::vector<TopoDS_Solid> solids(shells.size());
    std::int64_t count = 0;
    for (const bool outer : {true, false}) {
      for (std::size_t s = 0; s < shells.size(); ++s) {
        const std::int32_t owner = model_.shellOwner[s];
        if ((owner == static_cast<std::int32_t>(s)) != outer) continue;
        shells[s].Closed(true);
        if (outer) {
          builder_.MakeSolid(solids[s]);
          ++count;
        }
        builder_.Add(solids[owner], shells[s]);
      }
    }
    if (count == 1) {
      for (const TopoDS_Solid& solid : solids) {
        if (!solid.IsNull()) return solid;
      }
    }
    TopoDS_Compound compound;
    builder_.MakeCompound(compound);
    for (const TopoDS_Solid& solid : solids) {
      if (!solid.IsNull()) builder_.Add(compound, solid);
    }
    return compound;
  }

  const Model& model_;
  RunContext& run_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;
};

// Volume of the cone from `base` over the face; over all faces of a solid they add up to its
// volume.
double volumeUnder(const TopoDS_Face& face, const gp_Pnt& base) {
  BRepGProp_Face surface(face);
  BRepGProp_Domain domain(face);
  BRepGProp_Vinert inertia;
  inertia.SetLocation(base);
  inertia.Perform(surface, domain);
  return inertia.Mass();
}

// Runs `work` over [0, count) on all cores, with checkpoints on this thread's share.
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

}  // namespace

Brep buildBrep(const Model& model, RunContext& run) { return BrepBuilder(model, run).build(); }

std::vector<std::int32_t> findBadFaces(const std::vector<TopoDS_Shape>& faces, RunContext& run,
                                       double from, double to) {
  std::vector<char> bad(faces.size(), 0);
  parallelFaces(faces.size(), run, from, to, [&](std::size_t i) {
    const BRepCheck_Analyzer analyzer(faces[i]);
    bad[i] = !analyzer.IsValid();
  });
  std::vector<std::int32_t> result;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    if (bad[i]) result.push_back(static_cast<std::int32_t>(i));
  }
  return result;
}

ShapeCheck checkShape(const TopoDS_Shape& shape, RunContext& run, double from, double to) {
  ShapeCheck check;
  if (shape.IsNull()) {
    check.complaint = "no shape";
    return check;
  }
  TopTools_IndexedMapOfShape faceMap, edgeMap;
  TopExp::MapShapes(shape, TopAbs_FACE, faceMap);
  TopExp::MapShapes(shape, TopAbs_EDGE, edgeMap);
  check.faces = faceMap.Extent();
  check.edges = edgeMap.Extent();
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) ++check.solids;
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_SHELL); it.More(); it.Next()) {
    ++check.shells;
    BRepCheck_Shell shellCheck(TopoDS::Shell(it.Current()));
    if (shellCheck.Closed() != BRepCheck_NoError) check.complaint = "a shell is not closed";
    if (shellCheck.Orientation() != BRepCheck_NoError) check.complaint = "a shell is not oriented";
    // With the orientation it has in the solid, which the volume needs.
    for (TopExp_Explorer f(it.Current(), TopAbs_FACE); f.More(); f.Next())
      faces.push_back(f.Current());
  }
  const std::vector<std::int32_t> bad = findBadFaces(faces, run, from, (from + to) / 2);
  if (!bad.empty()) check.complaint = std::to_string(bad.size()) + " faces are not valid";
  // About a point of the shape: volumes far from the origin would lose digits.
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
