// Simplifies the envelope: fewer triangles, nowhere farther from the original surface than the
// tolerance.
// In:      a closed manifold surface and the cell size of its grid.
// Out:     a closed manifold mesh without new self-intersections.
// Method:  The dense surface is thinned (thin.h) within a small part of the tolerance. Edge
//          collapses (collapse.h) use the rest. Then the deviation is measured in both directions.
//          Where it is too large, steps are undone, and a second round of collapses also keeps the
//          missed points near. Further rounds use less of the tolerance.
// The surface is kept, so that it can be simplified again with another tolerance. All tolerances
// share a series of thinned surfaces, called levels. The first level is thinned from the surface,
// each further level from the previous one with a limit twice as large. A level is built at its
// first use.
// Units:   mm.
// Cost:    O(n) for the levels of a surface with n triangles, O(m log m) to simplify a level with m
//          triangles.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "geometry/nearest_triangle.h"
#include "swept/run_context.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept {

struct CollapseState;
struct FarPoint;

struct Simplified {
  TriMesh mesh;
  std::vector<double> contactTime;
  std::vector<std::array<std::int32_t, 2>> featureEdges;  ///< vertex pairs along creases
  Sources sources;       ///< empty if the sources of the surface are unknown
  double deviation = 0;  ///< mm, the larger of the values measured in both directions
};

class Simplifier {
 public:
  /// `sources`: sources of the surface's triangles, or empty.
  Simplifier(TriMesh mesh, std::vector<double> contactTime, double cell, Sources sources = {});

  /// Returns the simplified surface. `tolerance` (mm) must be above 0. Several threads may call
  /// this at the same time. The result depends only on the tolerance, never on earlier calls.
  Simplified simplifyTo(double tolerance, RunContext& run) const;

  const TriMesh& mesh() const { return mesh_; }
  const std::vector<double>& contactTime() const { return contactTime_; }
  const Sources& sources() const { return sources_; }
  /// Returns the feature edges of the unsimplified surface.
  std::vector<std::array<std::int32_t, 2>> featureEdges() const;

 private:
  struct Level {
    TriMesh mesh;
    std::vector<std::int32_t> source;  ///< for each vertex, its index in the surface
    double limit = 0;                  ///< mm, largest distance from the surface
    std::unique_ptr<NearestTriangle> nearest;
  };
  /// Returns a level thinned from `from`, or from the surface if `from` is null. `kept`: for each
  /// vertex of the surface, 1 if the vertex must stay; empty: none must stay.
  std::unique_ptr<Level> thinned(const Level* from, double limit, RunContext& run,
                                 std::vector<char> kept = {}) const;
  /// Returns the coarsest level within `limit`, or null.
  const Level* levelWithin(double limit, RunContext& run) const;
  const NearestTriangle& nearest() const;
  void addContactTime(const Level& level, Simplified& out) const;
  static CollapseState startFrom(const Level& level);
  Simplified finished(TriMesh mesh, double deviation, const Level& level) const;
  /// Returns nothing if the measured deviation stays above the tolerance. Then `kept` marks the
  /// vertices of the surface around the places that deviate.
  std::optional<Simplified> simplifyFrom(const Level& level, double tolerance, RunContext& run,
                                         std::vector<char>& kept) const;
  void keepAround(const std::vector<FarPoint>& missed, std::vector<char>& kept) const;

  TriMesh mesh_;
  std::vector<double> contactTime_;
  double cell_;
  Sources sources_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Level>> levels_;
  mutable std::unique_ptr<NearestTriangle> nearest_;  ///< search tree of the surface
};

}  // namespace swept
