// Visits the faces and side patches that culling keeps, placement by placement, for a continuous
// motion. The order is fixed, so all samplers number the elements in the same way. The caller
// passes the clusters that can matter ("shown", step_blocks.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "sampling/culling/swept_elements.h"

namespace swept {

/// A cluster that can matter at a placement and in the step after it. One bit for each of its faces
/// says whether this face can matter.
struct ShownCluster {
  std::uint32_t cluster, faces;

  static_assert(FaceClusters::kMaxFaces <= 32);
  static constexpr std::uint32_t kAll = 0xffffffffu;
  bool shows(std::uint32_t number) const { return (faces >> number & 1u) != 0; }
};
using ShownClusters = std::vector<ShownCluster>;  // in ascending order

/// A trial (pipeline/sampling_trial.h) samples only a part of the clusters. It includes or omits
/// this many successive clusters together. Successive clusters are near each other, so a trial also
/// covers the borders between clusters.
constexpr std::size_t kClustersTogether = 16;

/// Returns one of `parts` equal parts of the clusters, spread over the body. Returns all clusters
/// if `parts` is 1, and none if it is 0.
inline ShownClusters allClusters(const FaceClusters& clusters, std::size_t parts = 1) {
  ShownClusters all;
  for (std::uint32_t c = 0; parts > 0 && c < clusters.clusters.size(); ++c) {
    if (c / kClustersTogether % parts == parts / 2) all.push_back({c, ShownCluster::kAll});
  }
  return all;
}

class KeptElements {
 public:
  KeptElements(const SamplerInput& input, const FaceClusters& clusters)
      : input_(input), clusters_(clusters), before_(input, clusters), after_(input, clusters) {}

  /// Goes to a placement. This is fastest if it is the one after the current placement.
  void goTo(std::size_t placement) {
    if (placement > 0 && placement == placement_ + 1) {
      std::swap(before_, after_);
    } else if (placement > 0) {
      before_.setStep(placement - 1);
    }
    placement_ = placement;
    if (hasAfter()) after_.setStep(placement);
  }

  /// Calls use(face) for the faces kept at this placement.
  template <class Use>
  void forFaces(const ShownClusters& shown, const Use& use) const {
    const bool hasBefore = placement_ > 0;
    for (const ShownCluster& s : shown) {
      const std::uint32_t c = s.cluster;
      const FaceCluster& cluster = clusters_.clusters[c];
      if (enclosed(hasBefore ? before_.ofCluster(c) : 0, hasAfter() ? after_.ofCluster(c) : 0)) {
        continue;
      }
      for (std::uint32_t n = 0; n < cluster.faceCount; ++n) {
        const std::uint32_t at = cluster.firstFace + n;
        if (s.shows(n) &&
            !enclosed(hasBefore ? before_.ofIndex(at) : 0, hasAfter() ? after_.ofIndex(at) : 0)) {
          use(clusters_.faces[at]);
        }
      }
    }
  }

  /// Calls use(edge, ends) for the side patches kept in the step that starts at this placement. The
  /// placement must not be the last one.
  template <class Use>
  void forPatches(const ShownClusters& shown, const Use& use) const {
    for (const ShownCluster& s : shown) {
      if (input_.cull && after_.ofCluster(s.cluster) != 0) continue;
      const FaceCluster& cluster = clusters_.clusters[s.cluster];
      for (std::uint32_t n = cluster.firstEdge; n < cluster.firstEdge + cluster.edgeCount; ++n) {
        const FaceClusters::EdgeEnds& ends = clusters_.innerEnds[n];
        // An edge belongs to both of its faces, so it is hidden with either of them.
        if (!s.shows(ends.left - cluster.firstFace) || !s.shows(ends.right - cluster.firstFace)) {
          continue;
        }
        if (!input_.cull || !inSameDirection(ends, false)) use(clusters_.innerEdges[n], ends);
      }
    }
    for (const ShownCluster& s : shown) {
      const std::uint32_t first = clusters_.clusters[s.cluster].firstFace;
      for (std::uint32_t b = clusters_.firstBorder[s.cluster];
           b < clusters_.firstBorder[s.cluster + 1]; ++b) {
        borderPatches(clusters_.borders[b], first, s, use);
      }
    }
    for (std::size_t b = clusters_.firstBorder.back(); b < clusters_.borders.size(); ++b) {
      borderPatches(clusters_.borders[b], 0, {0, ShownCluster::kAll}, use);
    }
  }

 private:
  /// Calls use(edge, ends) for the side patches kept on one border. `s`: the cluster on the left of
  /// the border; if its bits are kAll, every face is shown.
  template <class Use>
  void borderPatches(const FaceClusters::Border& border, std::uint32_t firstFace,
                     const ShownCluster& s, const Use& use) const {
    const auto shows = [&](std::uint32_t n) {
      return s.faces == ShownCluster::kAll || s.shows(clusters_.borderEnds[n].left - firstFace);
    };
    const std::uint32_t end = border.firstEdge + border.edgeCount;
    std::uint32_t first = border.firstEdge;
    while (first < end && !shows(first)) ++first;
    if (first == end) return;
    const bool mayDrop = input_.cull && border.right >= 0;
    if (mayDrop) {
      const int left = after_.ofCluster(static_cast<std::size_t>(border.left));
      const int right = after_.ofCluster(static_cast<std::size_t>(border.right));
      if (left != 0 && left == (border.opposed ? -right : right)) return;
    }
    for (std::uint32_t n = first; n < end; ++n) {
      if (!shows(n)) continue;
      const FaceClusters::EdgeEnds& ends = clusters_.borderEnds[n];
      if (!mayDrop || !inSameDirection(ends, border.opposed)) {
        use(clusters_.borderEdges[n], clusters_.borderEnds[n]);
      }
    }
  }
  static constexpr std::size_t kNowhere = ~std::size_t{0} - 1;
  bool hasAfter() const { return placement_ < input_.motion.steps(); }
  /// True if both faces of an edge move in the same direction, so that its side patch is enclosed.
  bool inSameDirection(const FaceClusters::EdgeEnds& ends, bool opposed) const {
    const int left = after_.ofIndex(ends.left), right = after_.ofIndex(ends.right);
    return left != 0 && left == (opposed ? -right : right);
  }
  bool enclosed(int before, int after) const {
    return input_.cull &&
           faceIsEnclosed(before, after, placement_ > 0, hasAfter(), input_.orientable);
  }

  const SamplerInput& input_;
  const FaceClusters& clusters_;
  FaceDirections before_, after_;
  std::size_t placement_ = kNowhere;
};

}  // namespace swept
