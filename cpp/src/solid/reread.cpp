// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/reread.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"

namespace swept {

std::string rereadComplaint(const SolidCheck& read, const step::HalfEdgeMesh& mesh,
                            const SolidOptions& options, double meshError) {
  const std::int64_t outer = step::countOuterShells(mesh.shellOwner);
  const double allowed =
      mesh.area * std::max({options.planarTolerance, options.tolerance, meshError}) +
      1e-6 * std::abs(mesh.volume);
  if (!read.valid) return read.complaint;
  if (read.solids != outer || read.shells != std::ssize(mesh.shellOwner)) {
    return std::to_string(read.solids) + " solids with " + std::to_string(read.shells) +
           " shells instead of " + std::to_string(outer) + " with " +
           std::to_string(mesh.shellOwner.size());
  }
  if (!(std::abs(read.volume - mesh.volume) <= allowed)) {
    return "volume " + numberText(read.volume, 9) + " mm^3 instead of " +
           numberText(mesh.volume, 9) + " mm^3 (allowed difference: " + numberText(allowed, 3) +
           " mm^3)";
  }
  if (options.tolerance > 0 && options.recognise && read.edgeTolerance > options.tolerance) {
    return "an edge or vertex with a tolerance of " + numberText(read.edgeTolerance, 3) +
           " mm, more than the tolerance of the solid, " + numberText(options.tolerance, 3) + " mm";
  }
  return {};
}

}  // namespace swept
