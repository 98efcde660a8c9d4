// Edge collapses with a bound that holds both ways at every step: the accurate stage of the one
// simplifier, for envelopes (no labels) and solids (a label is a patch with a surface of its own).
// In: CollapseState: a closed manifold mesh with labels (-1: open ground), what every vertex may
// do, and by triangle the points that must stay near it. Out: the same with fewer triangles.
// Units: mm. Order: cheapest quadric error first (Garland, Heckbert 1997).
// Invariants: the surface stays closed and manifold; every attached point, and every vertex that
// goes, lies within the tolerance of a triangle of open ground; points spread over new triangles of
// open ground lie within it of the original; no new triangle meets another, unless the ones it
// stands for did; a border stays near its patch's surface and does not pass over vertices of the
// patch.
// Parallel: slabs of fixed number, between which nothing can meet; then slabs between those, then
// what is left. Cost: about 30 us a collapse; the result does not depend on the threads.
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

/// What the triangles of one label lie on.
class LabelSurface {
 public:
  virtual ~LabelSurface() = default;
  virtual bool isPlanar() const = 0;
  virtual double distance(const Eigen::Vector3d& p) const = 0;  ///< signed
  virtual Eigen::Vector3d normal(const Eigen::Vector3d& p) const = 0;
};

/// Border: goes along the border of its patch only. Fixed: stays.
enum class VertexKind : char { Free, Border, Fixed };

struct CollapseState {
  double tolerance = 0;
  Phase phase = Phase::Simplify;
  const NearestTriangle* original = nullptr;            ///< what the new triangles stay near
  std::vector<std::unique_ptr<LabelSurface>> surfaces;  ///< by label
  TriMesh mesh;
  std::vector<std::int32_t> label;                     ///< by triangle
  std::vector<VertexKind> kind;                        ///< by vertex
  std::vector<std::vector<Eigen::Vector3d>> attached;  ///< by triangle: points that stay near it
  std::vector<char> dead;                              ///< by triangle; out
  /// By vertex: points on new triangles about it, and about what it goes into, are as dense as half
  /// the tolerance asks for. Empty: none.
  std::vector<char> careful;
  /// Points on other new triangles are so many tolerances apart. Bunny over 16 keys at 512 cells,
  /// 0.5 mm: with 3, 11 places lay too far off at first, by 1.2 tolerances; with 5, 48 by 1.3;
  /// with 8, 53 by 2.1; with 1.5, 10 by 1.1.
  double coarseness = 3;
  /// By vertex: a triangle of the original near it; -1, or an empty list: not known.
  std::vector<std::int32_t> nearby;

  // Made by collapseEdges().
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the quadrics
  double spacing = 0;                                ///< of the points spread over new triangles
  std::vector<std::vector<std::int32_t>> around;     ///< by vertex: its triangles
  std::vector<Quadric> quadric;
  std::vector<char> gone;  ///< by vertex
  std::vector<std::uint32_t> stamp;
};

/// Points along long edges and in the middle of long triangles are attached: with the corners alone
/// the inside of a long triangle would be free. `watched`: by triangle, those that have theirs.
void watchLongEdges(CollapseState& state, const std::vector<char>& watched);

/// `quick`: only what can be done in slabs. `log` receives every step; null: none is kept.
void collapseEdges(CollapseState& state, bool quick, RunContext& run, CollapseLog* log = nullptr);

/// Goes on at the corners of these triangles of a state in which edges were collapsed.
void collapseAgain(CollapseState& state, const std::vector<std::int32_t>& triangles,
                   RunContext& run, CollapseLog& log);

/// What is left, without labels; `triangles` receives the number of each triangle in the state.
TriMesh takeMesh(const CollapseState& state, std::vector<std::int32_t>* triangles = nullptr);

}  // namespace swept
