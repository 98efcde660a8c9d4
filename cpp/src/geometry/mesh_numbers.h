// Whether the numbers of a mesh can be worked with: indices of vertices, coordinates.
// Out:   what is wrong and where; what to say about it is the caller's business.
// Units: mm. Cost: O(n) on all cores.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "swept/types.h"

namespace swept {

struct BadIndex {
  std::int64_t triangle = 0;
  std::int32_t vertex = 0;  ///< that it refers to, and that is not there
};

/// The first one.
std::optional<BadIndex> findBadIndex(const TriMesh& mesh);

struct Coordinates {
  std::int64_t nonFinite = 0;  ///< vertices with a coordinate that is no finite number
  std::vector<std::int64_t> firstNonFinite;  ///< at most 8 of these
  double largest = 0;                        ///< mm, of the finite vertices' coordinates
  std::int64_t farthest = -1;                ///< the first vertex that has it
};

Coordinates measureCoordinates(const TriMesh& mesh);

}  // namespace swept
