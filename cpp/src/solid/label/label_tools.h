// Data and queries that all steps of the labelling use: the mesh, the carrier of each triangle, and
// the borders between regions of equal carriers.
// Units:   mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/sort_unique.h"
#include "solid/carrier/places.h"
#include "solid/label/swept_carriers.h"
#include "solid/mesh/half_edge.h"

namespace swept::step {

struct Labels {
  const HalfEdgeMesh& mesh;
  double tolerance;  ///< mm, how far a face may lie from the points of its triangles
  double spacing;    ///< mm, mean length of the edges of triangles
  SweptCarriers known;
  std::vector<std::int32_t> of;  ///< by triangle: number of its carrier, or -1
  /// by triangle: the crossing that it comes from, else its centre
  std::vector<Eigen::Vector3d> points;
};

class LabelTools {
 public:
  explicit LabelTools(Labels& labels)
      : mesh_(labels.mesh),
        tolerance_(labels.tolerance),
        spacing_(labels.spacing),
        known_(labels.known),
        of_(labels.of),
        points_(labels.points) {}

 protected:
  using Vector3d = Eigen::Vector3d;
  static constexpr std::int32_t kNone = -1;
  /// mm: largest distance of a common point of carriers from each of them.
  static constexpr double kMeet = 1e-5;

  const Carrier& carrier(std::int32_t n) const { return known_.carriers()[n]; }
  double residual(std::int32_t t, std::int32_t n) const {
    return std::abs(carrier(n).distance(points_[t]));
  }

  bool mayJoin(std::int32_t t, std::int32_t n) const {
    return n >= 0 && residual(t, n) <= spacing_;
  }

  bool isBorder(std::int32_t h) const { return of_[h / 3] != of_[mesh_.opposite[h] / 3]; }

  // Calls visit() with one half-edge that starts at each vertex of the mesh. Returns whether one of
  // the calls returned true.
  template <class Visit>
  bool anyVertex(const Visit& visit) const {
    bool changed = false;
    std::vector<char> seen(mesh_.points.size(), 0);
    for (std::size_t i = 0; i < mesh_.opposite.size(); ++i) {
      const auto h = static_cast<std::int32_t>(i);
      if (seen[mesh_.origin(h)]) continue;
      seen[mesh_.origin(h)] = 1;
      changed = visit(h) || changed;
    }
    return changed;
  }

  // Returns the triangles around the origin of a border half-edge, from its own triangle to the
  // next border.
  std::vector<std::int32_t> fanFrom(std::int32_t h) const {
    std::vector<std::int32_t> fan;
    do {
      fan.push_back(h / 3);
      h = mesh_.opposite[HalfEdgeMesh::previous(h)];
    } while (!isBorder(h));
    return fan;
  }

  // Returns the half-edges of the border between the two regions at h: h and those after it, until
  // other regions follow or the limit of the length is exceeded.
  std::vector<std::int32_t> chainFrom(std::int32_t h) const {
    const std::int32_t left = of_[h / 3], right = of_[mesh_.opposite[h] / 3];
    std::vector<std::int32_t> chain{h};
    while (chain.size() <= kMaxShortBorder) {
      std::int32_t n = HalfEdgeMesh::next(chain.back());
      while (!isBorder(n)) n = HalfEdgeMesh::next(mesh_.opposite[n]);
      if (of_[n / 3] != left || of_[mesh_.opposite[n] / 3] != right || n == h) break;
      chain.push_back(n);
    }
    return chain;
  }

  static constexpr std::size_t kMaxShortBorder = 24;

  bool meetAll(const Vector3d& near, const std::vector<std::int32_t>& around) const {
    std::vector<const Carrier*> all;
    for (const std::int32_t n : around) all.push_back(&carrier(n));
    if (knownPoint(near, all, 4 * spacing_)) return true;
    const Vector3d p = meetingPoint(near, all);
    if (!((p - near).norm() <= 6 * spacing_)) return false;
    return std::all_of(all.begin(), all.end(),
                       [&](const Carrier* s) { return std::abs(s->distance(p)) <= kMeet; });
  }

  struct Regions {
    std::vector<std::int32_t> of;                      // by triangle: index of its region
    std::vector<std::vector<std::int32_t>> triangles;  // by region: its triangles
  };
  Regions regions() const {
    Regions found;
    found.of.assign(of_.size(), kNone);
    for (std::size_t first = 0; first < of_.size(); ++first) {
      if (found.of[first] >= 0) continue;
      const auto id = static_cast<std::int32_t>(found.triangles.size());
      std::vector<std::int32_t> members{static_cast<std::int32_t>(first)};
      found.of[first] = id;
      for (std::size_t i = 0; i < members.size(); ++i) {
        for (const std::int32_t t : mesh_.neighbours(members[i])) {
          if (found.of[t] >= 0 || of_[t] != of_[first]) continue;
          found.of[t] = id;
          members.push_back(t);
        }
      }
      found.triangles.push_back(std::move(members));
    }
    return found;
  }

  const HalfEdgeMesh& mesh_;
  const double tolerance_, spacing_;
  const SweptCarriers& known_;
  std::vector<std::int32_t>& of_;
  const std::vector<Vector3d>& points_;
};

}  // namespace swept::step
