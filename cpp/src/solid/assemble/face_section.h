// The curve in which a face of a body intersects the face that an edge sweeps in a straight move:
// the edge, projected along the move onto the face.
// Units:   mm; parameters of the edge and of the face.
// Cost:    some microseconds for each point; 17 to 60 points for a section.
// Method:  Newton's method for S(u, v) = C(t) + l d, from point to point; cubics join the points
//          (N. Patrikalakis, T. Maekawa, Shape interrogation, 2002, chapter 5).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <optional>
#include <utility>
#include <vector>

#include "solid/assemble/interpolate_curve.h"
#include "solid/assemble/profile.h"

namespace swept::step {

class FaceSection {
 public:
  /// A point of the section.
  struct State {
    double t = 0, u = 0, v = 0;
    double along = 0;  ///< mm from the edge to the face, along the move
  };
  /// A point of the border of the face.
  struct BorderPoint {
    gp_Pnt at;
    gp_Pnt2d on;       ///< its parameters on the face
    double tolerance;  ///< how far it may lie off the face
  };
  /// The end of a section: where the edge ends, or where it crosses the border of the face or
  /// another sweeping edge.
  struct End {
    double t = 0;
    std::vector<BorderPoint> border;
    /// The other sweeping edge and its parameter. The end is computed from that edge, so that the
    /// sections of both edges have the same end.
    std::pair<const PlaneProfile*, double> other{nullptr, 0};
  };

  FaceSection(const PlaneProfile& profile, const TopoDS_Face& face, const Projection& projection)
      : profile_(profile), surface_(face, Standard_False), projection_(projection) {}

  /// Moves to the point over the parameter t of the edge. False if there is none nearby.
  bool solve(State& at, double t) const;

  gp_Pnt pointAt(const State& at) const { return surface_.Value(at.u, at.v); }
  /// Normals, not of unit length.
  gp_Vec normalOfFace(const State& at) const;
  gp_Vec normalOfSwept(const State& at) const;
  /// The direction of the section; its length is the sine of the angle between both faces.
  gp_Vec tangentAt(const State& at) const;

  /// Returns the edge between two ends, through the given point. Nothing if the section ends
  /// between them.
  std::optional<TopoDS_Edge> between(const End& from, const End& to, const State& middle) const;

 private:
  FaceSection(const PlaneProfile& profile, const FaceSection& other)
      : profile_(profile), surface_(other.surface_), projection_(other.projection_) {}

  bool solveNear(const State& known, State& to, double t) const;
  static const BorderPoint& nearestBorder(const End& end, const gp_Pnt& p);
  // Returns the state at a point of the border. `known`: a state nearby.
  State stateAt(const BorderPoint& point, double t, const State& known) const;
  bool moveToEnd(const State& known, State& to, const End& end) const;
  // Moves to the border point at the end, if it is so near that errors of the body may hide the
  // rest of the section.
  bool snapToEnd(State& at, const End& end) const;
  // Moves from fraction to fraction of the way between two ends (see parameterAt()).
  bool follow(const State& known, State& to, const End& from, const End& until, double wFrom,
              double wTo) const;
  std::optional<std::vector<State>> statesAt(const std::vector<double>& ws, const End& from,
                                             const End& to, const State& middle) const;
  std::vector<CurvePoint> pointsAt(const std::vector<State>& states) const;
  double snapDistance(const State& at, double tolerance) const;
  // Returns whether a point between two states lies on both faces.
  bool isOn(const gp_Pnt& p, const State& a, const State& b) const;

  const PlaneProfile& profile_;
  const BRepAdaptor_Surface surface_;
  const Projection& projection_;
};

}  // namespace swept::step
