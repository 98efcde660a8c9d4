// Edges of a body, seen along a straight move: plane curves, and where they cross.
// Units:   mm.
// Cost:    O(segments) for each pair of edges whose boxes overlap.
// Method:  polylines give starting points, Newton's method the crossings.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>
#include <vector>

namespace swept::step {

/// Coordinates in the plane perpendicular to the move.
class Projection {
 public:
  explicit Projection(const gp_Vec& shift) : axes_(gp_Pnt(), gp_Dir(shift)) {}

  gp_Dir direction() const { return axes_.Direction(); }
  gp_Pnt2d of(const gp_Pnt& p) const { return gp_Pnt2d(of(gp_Vec(gp_Pnt(), p)).XY()); }
  gp_Vec2d of(const gp_Vec& v) const {
    return {v.Dot(axes_.XDirection()), v.Dot(axes_.YDirection())};
  }
  /// Returns the part of a vector that is perpendicular to the move.
  gp_Vec across(const gp_Vec& v) const {
    return v - gp_Vec(axes_.Direction()) * v.Dot(axes_.Direction());
  }

 private:
  gp_Ax2 axes_;
};

struct ProfileBox {
  gp_Pnt2d low{1e300, 1e300}, high{-1e300, -1e300};
  void add(const gp_Pnt2d& p);
  void add(const ProfileBox& box);
  bool overlaps(const ProfileBox& box) const;
};

/// An edge seen along the move.
struct PlaneProfile {
  PlaneProfile(const TopoDS_Edge& edge, const Projection& projection);
  double from() const { return parameters.front(); }
  double to() const { return parameters.back(); }
  bool isEnd(double t) const;
  /// Returns the vertex at the first or last parameter. May be null.
  TopoDS_Vertex endVertex(bool isLast) const;
  /// Returns the point at a parameter: at the ends, that of the vertex.
  gp_Pnt pointAt(double t) const;
  /// Returns the parameter of the point nearest to p, seen along the move. `t`: one nearby.
  double footOf(const gp_Pnt2d& p, double t, const Projection& projection) const;

  TopoDS_Edge edge;
  BRepAdaptor_Curve curve;
  std::vector<double> parameters;  ///< of the corners of a polyline near the curve
  std::vector<gp_Pnt2d> corners;
  ProfileBox box;
  double length = 0;  ///< of the edge itself
};

struct Crossing {
  double a, b;  ///< parameters of the two curves
};

/// Returns where the curves cross. At a common end at which they are tangent, only this end. Places
/// at which they touch without crossing are not found.
std::vector<Crossing> crossingsOf(const PlaneProfile& a, const PlaneProfile& b,
                                  const Projection& projection);

}  // namespace swept::step
