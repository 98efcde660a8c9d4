// Edge collapses that keep the surface within a tolerance, in both directions and after each step.
// This is the accurate stage of simplification, for envelopes (no labels) and for solids. On a
// solid, each label stands for a patch that has a surface of its own. Triangles without a patch
// (label -1) are called open ground.
// In:      CollapseState: a closed manifold mesh with labels, the kind of each vertex, and for each
//          triangle the attached points, which must stay near it.
// Out:     the same with fewer triangles.
// Units:   mm.
// Order:   smallest quadric error first (Garland, Heckbert 1997).
// Promise: The surface stays closed and manifold. Each attached point and each removed vertex lies
//          within the tolerance of a triangle of open ground. Sample points on new triangles of
//          open ground lie within the tolerance of the original. No new triangle intersects another
//          one, unless the triangles that it replaces already did. A border stays near the surface
//          of its patch and does not pass over vertices of the patch.
// Threads: A fixed number of slabs across the longest axis is processed in parallel. Triangles that
// lie in different slabs cannot intersect. Then the vertices near the limits between the slabs are
// processed in slabs across the other axes, and finally the rest in one thread. The result does not
// depend on the number of threads.
// Cost:    about 30 us per collapse.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "geometry/quadric.h"
#include "swept/run_context.h"
#include "swept/types.h"

namespace swept {

class CollapseLog;

/// The surface of the patch with one label.
class LabelSurface {
 public:
  virtual ~LabelSurface() = default;
  virtual bool isPlanar() const = 0;
  virtual double distance(const Eigen::Vector3d& p) const = 0;  ///< signed
  virtual Eigen::Vector3d normal(const Eigen::Vector3d& p) const = 0;
};

/// A Border vertex moves only along the border of its patch; a Fixed vertex does not move.
enum class VertexKind : char { Free, Border, Fixed };

/// How densely new triangles around a vertex are sampled. Folded: triangles around the vertex are
/// turned away from each other. Deviated: steps were undone there, because a point deviated too
/// far.
enum class Care : char { Normal, Folded, Deviated };

struct CollapseState {
  double tolerance = 0;
  Phase phase = Phase::Simplify;
  /// New triangles stay near this mesh; null: not checked.
  const NearestTriangle* original = nullptr;
  std::vector<std::unique_ptr<LabelSurface>> surfaces;  ///< by label
  TriMesh mesh;
  std::vector<std::int32_t> label;  ///< label of each triangle
  std::vector<VertexKind> kind;     ///< kind of each vertex
  /// For each triangle, points that must stay near it.
  std::vector<std::vector<Eigen::Vector3d>> attached;
  std::vector<char> dead;  ///< for each triangle, 1 if it was removed
  /// Spacing of the sample points on new triangles with Care::Normal, in tolerances. The value
  /// comes from a trial: the bunny test mesh moved over 16 keys, at 512 cells, tolerance 0.5 mm.
  /// After the first round, 10 places deviated too much with coarseness 1.5, by at most 1.1
  /// tolerances; with 3, 11 places by at most 1.2; with 5, 48 places by 1.3; with 8, 53 places
  /// by 2.1.
  double coarseness = 3;
  /// Whether points are closer together at folds (folds.h). Solids keep their tolerance without
  /// this. With it, the solids of five test meshes had 2 to 8 % more faces.
  bool denserAtFolds = true;
  /// For each vertex, a triangle of the original near the vertex; -1 if unknown. Empty: all are
  /// unknown.
  std::vector<std::int32_t> nearby;

  // collapseEdges() sets the members below.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< origin of the quadrics
  std::vector<std::vector<std::int32_t>> around;     ///< for each vertex, its triangles
  /// For each vertex. A vertex that is merged into another passes the larger care on.
  std::vector<Care> care;
  std::vector<Quadric> quadric;
  std::vector<char> gone;            ///< for each vertex, 1 if it was removed
  std::vector<std::uint32_t> stamp;  ///< for each vertex, how often it has changed
};

/// Attaches points along long edges and in the middle of long triangles. Without them, nothing
/// would keep the inside of a long triangle in its position. `watched`: for each triangle, 1 if it
/// already has such points.
void watchLongEdges(CollapseState& state, const std::vector<char>& watched);

/// Collapses edges. With `quick`, processes only the slabs. `log`, unless null, receives each step.
void collapseEdges(CollapseState& state, bool quick, RunContext& run, CollapseLog* log = nullptr);

/// Collapses more edges after collapseEdges(), starting at the vertices of these triangles.
void collapseAgain(CollapseState& state, const std::vector<std::int32_t>& triangles,
                   RunContext& run, CollapseLog& log);

/// Returns the remaining triangles, without labels. `triangles` receives their indices in the
/// state.
TriMesh takeMesh(const CollapseState& state, std::vector<std::int32_t>* triangles = nullptr);

}  // namespace swept
