// Planes in which faces or edges of a moving body stay: faces that slide along themselves during a
// step, faces that are in one plane at several poses, and straight edges that turn in a plane.
// In:      the body at each pose.
// Out:     one candidate for each plane, so large that it covers the whole sweep. The curves on it
//          that may be edges of the swept volume: edges of the copies, and paths of their vertices.
// Units:   mm.
// Cost:    O(n^2) for n copies of plane faces.
// Method:  What moves in a plane sweeps only parts of this plane. Copies that overlap cannot be
//          cut by each other, but the curves on their common plane divide it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <vector>

#include "solid/assemble/body_motion.h"
#include "solid/assemble/elementary_body.h"
#include "solid/assemble/swept_faces.h"

namespace swept::step {

class FixedPlanes {
 public:
  /// `motions`: by step.
  FixedPlanes(const ElementaryBody& body, const std::vector<Pose>& poses,
              const std::vector<BodyMotion>& motions);

  /// Returns the plane in which a face lies at a pose; -1 if no other copy lies there.
  int planeOf(std::size_t pose, std::size_t face) const { return planeOf_[pose][face]; }
  /// Returns the plane in which an edge moves in a step; -1 if there is none, or if what the edge
  /// sweeps is no surface of the envelope.
  int planeOfEdge(std::size_t step, std::size_t edge) const { return planeOfEdge_[step][edge]; }
  std::size_t count() const { return planes_.size(); }
  /// Returns the candidate for a plane. `reach`: mm, distance from the origin to the farthest point
  /// of the sweep.
  SweptFace candidate(std::size_t plane, double reach) const;
  /// Adds a curve on a plane, unless it was added before.
  void add(int plane, const TopoDS_Edge& edge);

 private:
  struct Plane {
    Eigen::Vector3d normal;
    double height;  // mm, of the plane above the origin
    std::vector<TopoDS_Edge> edges;
  };
  // Returns the index of a plane.
  int indexOf(const Eigen::Vector3d& normal, const Eigen::Vector3d& point);

  std::vector<Plane> planes_;
  std::vector<std::vector<int>> planeOf_;      // by pose and face
  std::vector<std::vector<int>> planeOfEdge_;  // by step and edge
};

}  // namespace swept::step
