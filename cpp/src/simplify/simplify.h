// Simplification of the envelope: fewer triangles, nowhere farther from the surface than a length.
//
// In:    a closed manifold surface and the cell of the grid it was made on. Out: a closed manifold
//        mesh that does not meet itself.
// Steps: the dense surface is thinned (thin.h) within a small part of the tolerance, edges are
//        collapsed (collapse.h) within what is left of it; then the deviation is measured both
//        ways. Where it is too large, the points that were missed and the places that strayed are
//        watched in a second round, and in further ones less of the tolerance is used.
// The surface is kept to cut it again at another tolerance. Coarse tolerances share thinned
// surfaces: level 0 is the surface, each further one is thinned from the one before within twice
// as much. Levels are made when they are first asked for.
// Units: mm. Cost: O(n) for the levels, O(m log m) for a cut from a level of m triangles.
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
struct FarPlace;

struct Simplified {
  TriMesh mesh;
  std::vector<double> contactTime;
  std::vector<std::array<std::int32_t, 2>> featureEdges;  ///< vertex pairs along creases
  Sources sources;       ///< empty unless those of the surface are known
  double deviation = 0;  ///< mm, the larger of both directions, measured
};

class Simplifier {
 public:
  /// sources: of the surface's triangles, or empty.
  Simplifier(TriMesh mesh, std::vector<double> contactTime, double cell, Sources sources = {});

  /// tolerance: mm, above 0. Safe to call from several threads; the bytes depend on the tolerance
  /// alone, never on earlier cuts.
  Simplified cut(double tolerance, RunContext& run) const;

  const TriMesh& mesh() const { return mesh_; }
  const std::vector<double>& contactTime() const { return contactTime_; }
  const Sources& sources() const { return sources_; }
  /// Of the surface as it is without simplification.
  std::vector<std::array<std::int32_t, 2>> featureEdges() const;

 private:
  struct Level {
    TriMesh mesh;
    std::vector<std::int32_t> source;  ///< by vertex: its number in the surface
    double limit = 0;                  ///< mm: how far it may lie from the surface
    std::unique_ptr<NearestTriangle> nearest;
  };
  /// kept: by vertex of the surface, those that stay; empty: none.
  std::unique_ptr<Level> thinned(const Level* from, double limit, RunContext& run,
                                 std::vector<char> kept = {}) const;
  /// The coarsest level within this; null: none.
  const Level* levelWithin(double limit, RunContext& run) const;
  const NearestTriangle& nearest() const;
  void addContactTime(const Level& level, Simplified& out) const;
  static CollapseState startFrom(const Level& level);
  Simplified finished(TriMesh mesh, double deviation, const Level& level) const;
  /// Nothing where the measured deviation stays above the tolerance; then `kept` has the vertices
  /// of the surface about the places that are missed in the end.
  std::optional<Simplified> cutFrom(const Level& level, double tolerance, RunContext& run,
                                    std::vector<char>& kept) const;
  void keepAbout(const std::vector<FarPlace>& missed, std::vector<char>& kept) const;

  TriMesh mesh_;
  std::vector<double> contactTime_;
  double cell_;
  Sources sources_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Level>> levels_;
  mutable std::unique_ptr<NearestTriangle> nearest_;  ///< of the surface
};

}  // namespace swept
