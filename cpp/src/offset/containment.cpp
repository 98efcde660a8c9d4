// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/containment.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "geometry/ray_columns.h"

namespace swept::offset {
namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

constexpr double kMinRadius = 0.01;  // cells: triangles with a smaller radius are not split further
constexpr double kTight = 0.1;  // cells: the upper bound may exceed the true value by this much

class Prover {
 public:
  Prover(const CoverSearch& tree, double least) : tree_(tree), least_(least) {}

  double nearest = 1e300, farthest = 0;

  /// Returns false if the reach of some point of the triangle may be less than required.
  bool prove(const Corners& corner) {
    const Vector3d middle = (corner[0] + corner[1] + corner[2]) / 3;
    double radius = 0;
    for (const Vector3d& c : corner) radius = std::max(radius, (c - middle).norm());
    const CoverSearch::Nearest found = tree_.nearest(middle, 1e30, hint_, -1e30);
    if (found.triangle < 0) return false;
    hint_ = found.triangle;
    const CoverTriangle& cover = tree_.triangle(found.triangle);
    double most = 0;
    for (const Vector3d& c : corner) {
      most = std::max(most, (c - nearestOnTriangle(c, cover)).norm() + cover.slack);
    }
    const double lower = found.reach - radius;
    const bool loose = most > farthest && most - (found.reach + 2 * cover.slack) > kTight;
    if (radius > kMinRadius && (lower < least_ || loose)) {
      if (found.reach < least_) return fail(found.reach);
      const Vector3d a = (corner[0] + corner[1]) / 2, b = (corner[1] + corner[2]) / 2,
                     c = (corner[2] + corner[0]) / 2;
      bool proven = prove({corner[0], a, c});
      proven = prove({a, corner[1], b}) && proven;
      proven = prove({c, b, corner[2]}) && proven;
      return prove({a, b, c}) && proven;
    }
    farthest = std::max(farthest, most);
    nearest = std::min(nearest, lower);
    return lower >= least_;
  }

 private:
  bool fail(double reach) {
    nearest = std::min(nearest, reach);
    return false;
  }

  const CoverSearch& tree_;
  double least_;
  std::int32_t hint_ = -1;
};

std::int64_t countOutside(const Cover& cover, const TriMesh& mesh, const GridPlan& grid) {
  const RayColumns rays(mesh);
  std::int64_t outside = 0;
  for (const Vector3d& p : cover.inside) {
    outside += rays.winding(grid.origin + grid.cell * p) <= 0;
  }
  return outside;
}

}  // namespace

Containment proveContainment(const Cover& cover, const CoverSearch& tree, const TriMesh& mesh,
                             const GridPlan& grid, double least, RunContext& run) {
  constexpr std::size_t kBlock = 256;
  const std::size_t blocks = (mesh.triangles.size() + kBlock - 1) / kBlock;
  std::vector<Containment> parts(blocks);
  parallelBlocks(mesh.triangles.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Check, begin, mesh.triangles.size());
    Prover prover(tree, least);
    Containment& part = parts[begin / kBlock];
    for (std::size_t t = begin; t < end; ++t) {
      Corners corner;
      for (int k = 0; k < 3; ++k) {
        corner[k] = (mesh.vertices[mesh.triangles[t][k]] - grid.origin) / grid.cell;
      }
      part.tooNear += !prover.prove(corner);
    }
    part.nearest = prover.nearest;
    part.farthest = prover.farthest;
  });
  Containment all;
  all.nearest = 1e300;
  for (const Containment& part : parts) {
    all.tooNear += part.tooNear;
    all.nearest = std::min(all.nearest, part.nearest);
    all.farthest = std::max(all.farthest, part.farthest);
  }
  all.outside = countOutside(cover, mesh, grid);
  all.holds = !mesh.triangles.empty() && all.tooNear == 0 && all.outside == 0;
  return all;
}

}  // namespace swept::offset
