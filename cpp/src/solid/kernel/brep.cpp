// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/kernel/brep.h"

#include <BRep_Builder.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <ShapeConstruct_ProjectCurveOnSurface.hxx>
#include <ShapeFix_Edge.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax3.hxx>
#include <gp_Vec2d.hxx>
#include <string>

#include "solid/assemble/kernel_geometry.h"

namespace swept::step {
namespace {

// Returns the tolerance to store for a measured distance: slightly larger because of rounding, and
// never below kKernelTolerance.
double storedTolerance(double measured) { return std::max(kKernelTolerance, 1.01 * measured); }

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
    result.edges = std::move(edges_);
    return result;
  }

 private:
  void makeVertices() {
    vertices_.resize(model_.vertices.size());
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      builder_.MakeVertex(vertices_[v], pointOf(model_.vertices[v].point),
                          storedTolerance(model_.vertices[v].tolerance));
    }
  }

  static Handle(Geom_Surface) surfaceOf(const Carrier& s) {
    const gp_Dir x = dirOf(s.xdir.norm() > 0.5 ? s.xdir : anyOrthogonal(s.axis));
    const gp_Ax3 axes(pointOf(s.point), dirOf(s.axis), x);
    switch (s.kind) {
      case CarrierKind::Cylinder:
        return new Geom_CylindricalSurface(axes, s.radius);
      case CarrierKind::Cone:
        return new Geom_ConicalSurface(axes, s.halfAngle, s.radius);
      case CarrierKind::Sphere:
        return new Geom_SphericalSurface(axes, s.radius);
      case CarrierKind::Torus:
        return new Geom_ToroidalSurface(axes, s.radius, s.minor);
      case CarrierKind::Extrusion:
        return new Geom_SurfaceOfLinearExtrusion(kernelCurve(profileOf(s)), dirOf(s.axis));
      case CarrierKind::Revolution:
        return new Geom_SurfaceOfRevolution(kernelCurve(profileOf(s)),
                                            gp_Ax1(pointOf(s.point), dirOf(s.axis)));
      default:
        return new Geom_Plane(axes);
    }
  }

  void makeEdges() {
    edges_.resize(model_.edges.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const ModelEdge& edge = model_.edges[e];
      const Eigen::Vector3d a = model_.vertices[edge.start].point;
      // An edge without length or curve stays null, and its faces are reported as failed.
      if (!((edge.curve.at(edge.curve.last / 2) - a).norm() > kKernelTolerance)) continue;
      try {
        TopoDS_Edge made;
        builder_.MakeEdge(made, kernelCurve(edge.curve), storedTolerance(edge.tolerance));
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
      // The face of a bore is reversed, and therefore its loops are, too.
      builder_.Add(made, reversed ? wire.Reversed() : wire);
    }
    return reversed ? TopoDS::Face(made.Reversed()) : made;
  }

  // Adds the curve of an edge in the parameter plane of the surface. Shifts it to the period in
  // which the face lies.
  void addParameterCurve(std::int32_t e, const Carrier& surface, const TopoDS_Face& face) {
    const Curve& curve = model_.edges[e].curve;
    const Handle(Geom_Surface) geometry = BRep_Tool::Surface(face);
    ShapeConstruct_ProjectCurveOnSurface projector;
    projector.Init(geometry, kKernelTolerance);
    Handle(Geom_Curve) space = kernelCurve(curve);
    Handle(Geom2d_Curve) flat;
    projector.Perform(space, 0, curve.last, flat);
    if (flat.IsNull()) return;
    const gp_Pnt2d middle = flat->Value(curve.last / 2);
    auto periods = [](double value, double wanted) {
      return std::round((wanted - value) / (2 * M_PI));
    };
    // Only parameters that are angles are periodic.
    const bool turns = surface.kind != CarrierKind::Extrusion;
    const double u = turns ? 2 * M_PI * periods(middle.X(), M_PI) : 0;
    const double v =
        surface.kind == CarrierKind::Torus ? 2 * M_PI * periods(middle.Y(), surface.tubeMid) : 0;
    if (u != 0 || v != 0) flat->Translate(gp_Vec2d(u, v));
    builder_.UpdateEdge(edges_[e], flat, face, storedTolerance(model_.edges[e].tolerance));
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

}  // namespace

Brep buildBrep(const Model& model, RunContext& run) { return BrepBuilder(model, run).build(); }

}  // namespace swept::step
