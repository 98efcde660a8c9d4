// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/mend/polygons.h"

#include "base/parallel.h"

namespace swept {

Polygons::Polygons(const Surface& surface, std::size_t crossings)
    : surface_(surface), start_(crossings, kNone) {
  const auto& of = surface.crossingOf;
  parallelBlocks(of.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (of[t] == Surface::kNoCrossing || (t > 0 && of[t] == of[t - 1])) continue;
      start_[of[t]] = static_cast<std::uint32_t>(t);
    }
  });
}

}  // namespace swept
