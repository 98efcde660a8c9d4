// Closes faces that have open edges with facets of the envelope's mesh.
// In:      faces of a sweep that are right, with their normals outward; the closed mesh of the
//          whole envelope.
// Out:     a valid solid that consists of these faces and of facets. Faces at which facets
//          are impossible are left out, so facets take their place.
// Units:   mm.
// Cost:    some tenths of a second for each attempt; 3 to 30 attempts.
// Method:  narrow_holes.h fills narrow holes with few faces. For the others, hole_triangles.h finds
// the triangles of the mesh that fill the holes, hole_facets.h
//          makes faces of them. A facet is wrong if it is not valid, intersects others, or is not
//          on the surface of the swept volume. Then the open edges there get more vertices, and all
//          is done again. If this does not help, a face there is left out, so that the hole becomes
//          larger. Faces that are wrong themselves are left out, too.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <memory>
#include <vector>

#include "solid/assemble/sides.h"
#include "solid/mesh/half_edge.h"
#include "swept/run_context.h"

namespace swept::step {

struct FilledSolid {
  TopoDS_Shape shape;                  ///< null if there is no such solid
  std::int64_t planes = 0, cones = 0;  ///< facets of both kinds (hole_facets.h, narrow_holes.h)
};

/// Fills the holes between faces.
class FacetFiller {
 public:
  /// Keeps references to `mesh`, `sides` (of the sweep) and `run`. `tolerance`: mm, how far the
  /// facets may be off the mesh.
  FacetFiller(const std::vector<TopoDS_Face>& faces, const HalfEdgeMesh& mesh, const Sides& sides,
              double tolerance, RunContext& run);
  ~FacetFiller();

  /// `wrong`: points of faces that must be left out. A further call goes on with the faces that
  /// were used last.
  FilledSolid fill(const std::vector<Eigen::Vector3d>& wrong);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace swept::step
