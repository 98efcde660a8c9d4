// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/recognise/costly_patches.h"

#include "solid/recognise/facets_saved.h"

namespace swept::step {
namespace {

// Number of border edges on open ground that a patch may have for each facet that it saves. On a
// free form, a patch has a long jagged border, and there would be fewer facets without the patch.
constexpr double kBorderPerSaved = 1, kBorderPerSavedByPlane = 2;
constexpr double kSmooth = 0.85;  // cosine of 32 degrees, the largest angle at a smooth border

}  // namespace

std::vector<std::int32_t> findCostly(const HalfEdgeMesh& dense, const Partition& first,
                                     const Decimated& now, double tolerance) {
  const std::size_t count = first.patches.size();
  std::vector<std::int32_t> border(count, 0), costly;
  for (std::size_t h = 0; h < now.mesh.opposite.size(); ++h) {
    const std::int32_t own = now.partition.patchOf[h / 3], beyond = now.mesh.opposite[h] / 3;
    if (own < 0 || now.partition.patchOf[beyond] >= 0) continue;
    // A crease has vertices even without the patch, so border edges at creases do not count.
    const Eigen::Vector3d normal = now.mesh.areaVector(beyond).normalized();
    const Eigen::Vector3d& from = now.mesh.points[now.mesh.origin(static_cast<std::int32_t>(h))];
    if (first.patches[own].surface.normal(from).dot(normal) > kSmooth) ++border[own];
  }
  for (std::size_t p = 0; p < count; ++p) {
    const Patch& patch = first.patches[p];
    const double each = patch.surface.isPlanar() ? kBorderPerSavedByPlane : kBorderPerSaved;
    if (border[p] > each * facetsSaved(dense, patch, tolerance))
      costly.push_back(static_cast<std::int32_t>(p));
  }
  return costly;
}

}  // namespace swept::step
