// Walks a continuous motion placement by placement over the faces and side patches that culling
// keeps, in one fixed order: every sampler that uses it numbers the same elements the same way.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <utility>

#include "sampling/swept_elements.h"

namespace swept {

class KeptElements {
 public:
  KeptElements(const SamplerInput& input, const FaceClusters& clusters)
      : input_(input), clusters_(clusters), before_(input, clusters), after_(input, clusters) {}

  void start(std::size_t placement) {
    placement_ = placement;
    if (placement > 0) before_.compute(placement - 1);
    if (hasAfter()) after_.compute(placement);
  }
  /// To the next placement; not beyond the last.
  void advance() {
    std::swap(before_, after_);
    ++placement_;
    if (hasAfter()) after_.compute(placement_);
  }

  /// use(face) for the copies kept at this placement.
  template <class Use>
  void forFaces(const Use& use) const {
    const bool hasBefore = placement_ > 0;
    for (std::size_t c = 0; c < clusters_.clusters.size(); ++c) {
      const FaceCluster& cluster = clusters_.clusters[c];
      if (enclosed(hasBefore ? before_.ofCluster(c) : 0, hasAfter() ? after_.ofCluster(c) : 0)) {
        continue;
      }
      for (std::uint32_t n = 0; n < cluster.faceCount; ++n) {
        const std::uint32_t f = clusters_.faces[cluster.firstFace + n];
        if (!enclosed(hasBefore ? before_.ofFace(f) : 0, hasAfter() ? after_.ofFace(f) : 0)) use(f);
      }
    }
  }

  /// use(edge) for the side patches kept in the step that starts here; needs a step.
  template <class Use>
  void forPatches(const Use& use) const {
    const auto patch = [&](std::uint32_t e) {
      if (!input_.cull || !patchIsEnclosed(input_.topology.edges[e], after_)) use(e);
    };
    for (std::size_t c = 0; c < clusters_.clusters.size(); ++c) {
      if (input_.cull && after_.ofCluster(c) != 0) continue;
      const FaceCluster& cluster = clusters_.clusters[c];
      for (std::uint32_t n = 0; n < cluster.edgeCount; ++n) {
        patch(clusters_.innerEdges[cluster.firstEdge + n]);
      }
    }
    for (const FaceClusters::Border& border : clusters_.borders) {
      if (input_.cull && border.right >= 0) {
        const int left = after_.ofCluster(static_cast<std::size_t>(border.left));
        const int right = after_.ofCluster(static_cast<std::size_t>(border.right));
        if (left != 0 && left == (border.opposed ? -right : right)) continue;
      }
      for (std::uint32_t n = 0; n < border.edgeCount; ++n) {
        patch(clusters_.borderEdges[border.firstEdge + n]);
      }
    }
  }

 private:
  bool hasAfter() const { return placement_ < input_.motion.steps(); }
  bool enclosed(int before, int after) const {
    return input_.cull &&
           faceIsEnclosed(before, after, placement_ > 0, hasAfter(), input_.orientable);
  }

  const SamplerInput& input_;
  const FaceClusters& clusters_;
  FaceDirections before_, after_;
  std::size_t placement_ = 0;
};

}  // namespace swept
