// Writes one line of text about all rows of a clearance report, and finds the nearest row.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "swept/clearance.h"

namespace swept::clearance {

struct Summary {
  /// Index of the row with the smallest distance; allowed contacts come last. Not set: no rows.
  std::optional<std::size_t> smallest;
  std::string text;  ///< "12 checked, 1 contact, smallest 0 mm at t = 4.1 s (bracket)"
};

/// Whether the text gives the time of the smallest distance.
enum class Timed { Yes, No };

/// Returns the summary. `head` begins its text, for example "12 checked". `ignored` is the number
/// of neighbours that rules exclude.
Summary summaryOf(const std::vector<const NeighbourClearance*>& rows, const std::string& head,
                  std::size_t ignored = 0, Timed timed = Timed::Yes);

}  // namespace swept::clearance
