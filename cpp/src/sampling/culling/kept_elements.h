// Walks a continuous motion placement by placement over the faces and side patches that culling
// keeps, in one fixed order: all samplers that use it number the same elements alike. Which
// clusters and borders are looked at may be narrowed beforehand (step_blocks.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "sampling/culling/swept_elements.h"

namespace swept {

/// Clusters, rising: those that a placement and the step after it can need.
using ShownClusters = std::vector<std::uint32_t>;

inline ShownClusters allClusters(const FaceClusters& clusters) {
  ShownClusters all(clusters.clusters.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

class KeptElements {
 public:
  KeptElements(const SamplerInput& input, const FaceClusters& clusters)
      : input_(input), clusters_(clusters), before_(input, clusters), after_(input, clusters) {}

  /// Goes to a placement; to the next one is cheapest.
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
    for (const std::uint32_t c : shown) {
      const FaceCluster& cluster = clusters_.clusters[c];
      if (enclosed(hasBefore ? before_.ofCluster(c) : 0, hasAfter() ? after_.ofCluster(c) : 0)) {
        continue;
      }
      for (std::uint32_t at = cluster.firstFace; at < cluster.firstFace + cluster.faceCount; ++at) {
        if (!enclosed(hasBefore ? before_.ofIndex(at) : 0, hasAfter() ? after_.ofIndex(at) : 0)) {
          use(clusters_.faces[at]);
        }
      }
    }
  }

  /// Calls use(edge, ends) for the side patches kept in the step that starts here; there must be
  /// such a step.
  template <class Use>
  void forPatches(const ShownClusters& shown, const Use& use) const {
    for (const std::uint32_t c : shown) {
      if (input_.cull && after_.ofCluster(c) != 0) continue;
      const FaceCluster& cluster = clusters_.clusters[c];
      for (std::uint32_t n = cluster.firstEdge; n < cluster.firstEdge + cluster.edgeCount; ++n) {
        if (!input_.cull || !inSameDirection(clusters_.innerEnds[n], false))
          use(clusters_.innerEdges[n], clusters_.innerEnds[n]);
      }
    }
    for (const std::uint32_t c : shown) {
      for (std::uint32_t b = clusters_.firstBorder[c]; b < clusters_.firstBorder[c + 1]; ++b) {
        borderPatches(clusters_.borders[b], use);
      }
    }
    for (std::size_t b = clusters_.firstBorder.back(); b < clusters_.borders.size(); ++b) {
      borderPatches(clusters_.borders[b], use);
    }
  }

 private:
  template <class Use>
  void borderPatches(const FaceClusters::Border& border, const Use& use) const {
    const bool mayDrop = input_.cull && border.right >= 0;
    if (mayDrop) {
      const int left = after_.ofCluster(static_cast<std::size_t>(border.left));
      const int right = after_.ofCluster(static_cast<std::size_t>(border.right));
      if (left != 0 && left == (border.opposed ? -right : right)) return;
    }
    for (std::uint32_t n = border.firstEdge; n < border.firstEdge + border.edgeCount; ++n) {
      if (!mayDrop || !inSameDirection(clusters_.borderEnds[n], border.opposed)) {
        use(clusters_.borderEdges[n], clusters_.borderEnds[n]);
      }
    }
  }
  static constexpr std::size_t kNowhere = ~std::size_t{0} - 1;
  bool hasAfter() const { return placement_ < input_.motion.steps(); }
  /// Whether the two faces of an edge move in the same direction, so that its side patch is
  /// enclosed.
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
