// Surfaces in which faces or edges of a moving body stay: faces that slide along themselves during
// a step, faces that are in one surface at several poses, and straight edges that turn in a plane.
// In:      the body at each pose.
// Out:     one candidate for each surface, so large that it covers the whole sweep. The
//          curves on it that may be edges of the swept volume are edges of the copies, and paths
//          of their vertices.
// Units:   mm, rad; world coordinates.
// Cost:    O(n^2) for n copies of faces.
// Method:  What moves in a surface sweeps only parts of this surface. Copies that overlap cannot be
//          cut by each other, but the curves on their common surface divide it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <vector>

#include "solid/assemble/body_geometry.h"
#include "solid/assemble/body_motion.h"
#include "solid/assemble/swept_faces.h"

namespace swept::step {

class FixedSurfaces {
 public:
  /// `motions`: by step. `reach`: mm, distance from the origin to the farthest point of the sweep.
  FixedSurfaces(const BodyGeometry& body, const std::vector<Pose>& poses,
                const std::vector<BodyMotion>& motions, double reach);

  /// Returns the surface in which a face lies at a pose; -1 if no other copy lies there.
  int surfaceOf(std::size_t pose, std::size_t face) const { return surfaceOf_[pose][face]; }
  /// Returns the plane in which an edge moves in a step; -1 if there is none, or if what the edge
  /// sweeps is no surface of the envelope.
  int planeOf(std::size_t step, std::size_t edge) const { return planeOf_[step][edge]; }
  std::size_t count() const { return fixed_.size(); }
  /// Adds a curve on a surface, unless it was added before.
  void add(int surface, const TopoDS_Edge& edge);
  /// Returns the kernel's parameters of a point of a surface.
  Eigen::Vector2d parametersOf(int surface, const Eigen::Vector3d& p) const;
  SweptFace candidate(std::size_t surface) const {
    return {fixed_[surface].face, SweptFace::kAlone, fixed_[surface].edges};
  }
  /// Returns whether one of the surfaces contains all points.
  bool doesContain(const std::vector<Eigen::Vector3d>& points) const;
  /// Returns whether two of the surfaces overlap. Parts of one cylinder do, if they
  /// begin at different angles.
  bool doOverlap() const;

 private:
  struct Fixed {
    BodySurface carrier;   // of a cylinder, x points to the middle of the faces
    double halfWidth = 0;  // rad: of a cylinder, half the angle of the faces
    TopoDS_Face face = {};
    std::vector<TopoDS_Edge> edges = {};
  };
  static bool areSame(const Fixed& a, const Fixed& b);
  static TopoDS_Face faceOf(const Fixed& fixed, double reach);
  int indexOf(const Fixed& fixed);
  Handle(Geom2d_Curve) curveOn(int surface, const TopoDS_Edge& edge) const;

  std::vector<Fixed> fixed_;
  std::vector<std::vector<int>> surfaceOf_;  // by pose and face
  std::vector<std::vector<int>> planeOf_;    // by step and edge
};

}  // namespace swept::step
