// Checks the numbers in a mesh: vertex indices and coordinates.
// Out: the faults, with the indices of vertices and triangles.
// Units: mm. Cost: O(n) on all cores.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swept/types.h"

namespace swept {

struct BadIndex {
  std::int64_t triangle = 0;
  std::int32_t vertex = 0;  ///< an index for which there is no vertex
};

/// Returns the first triangle corner with a bad index, if any.
std::optional<BadIndex> findBadIndex(const TriMesh& mesh);

/// Returns the text of a message: "triangle 7 refers to vertex 12, but …".
std::string badIndexText(const BadIndex& bad, const TriMesh& mesh);

struct Coordinates {
  std::int64_t nonFinite = 0;                ///< vertices with a coordinate that is not finite
  std::vector<std::int64_t> firstNonFinite;  ///< indices of the first of these, at most 8
  double largest = 0;          ///< mm, largest absolute coordinate of the finite vertices
  std::int64_t farthest = -1;  ///< the first vertex with that coordinate
};

Coordinates measureCoordinates(const TriMesh& mesh);

}  // namespace swept
