// Divides the mesh of an envelope into faces by what made its triangles, instead of guessing.
// In:      the mesh, the sources of its triangles, the body's faces and edges, the trajectory.
// Out:     a Partition whose patches lie on exact carriers. Triangles that no carrier explains stay
//          unassigned. If they are more than half, there are no patches.
// Units:   mm.
// Cost:    O(triangles).
// Method:  1. Each triangle has a crossing, a point of the envelope. Of the carriers that its
//             source allows, the triangle takes the one on which the point lies (swept_carriers.h).
//          2. Ragged borders are cleaned by residual, not by size: a small region goes to a
//             neighbour whose carrier explains its points. Strips narrower than a cell are
//             connected: where two carriers do not meet, the one between them takes the border. The
//             edges of the solid follow the carriers, not the mesh.
//          3. Connected triangles on one carrier form a patch. Patches that close on themselves are
//             cut, so that no face needs a seam.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include "solid/mesh/patches.h"
#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

struct Labels;

/// A place whose surroundings become open ground.
struct OpenSpot {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double radius = 0;  ///< in edges of triangles
};

class FaceLabels {
 public:
  /// `tolerance`: mm, how far a face may lie from the points that it explains.
  FaceLabels(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance,
             RunContext& run);
  ~FaceLabels();
  FaceLabels(const FaceLabels&) = delete;
  FaceLabels& operator=(const FaceLabels&) = delete;

  /// Whether carriers explain at least half of the triangles. Otherwise there are no patches.
  bool explainMost() const { return explainMost_; }
  /// Takes the carriers of the triangles around these places. They stay without one.
  void open(const std::vector<OpenSpot>& spots);
  /// The mesh, thinned inside the faces.
  const HalfEdgeMesh& mesh() const { return thin_; }
  /// The patches of that mesh.
  Partition partition() const;

 private:
  void thin(const HalfEdgeMesh& mesh, RunContext& run);

  HalfEdgeMesh thin_;
  std::unique_ptr<Labels> labels_;
  bool explainMost_ = false;
};

}  // namespace swept::step
