// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unit/sampling/gl/scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "grid/plan_grid.h"
#include "motion/refine_motion.h"
#include "signs/contributing_edges.h"

namespace swept::test {

Scene::Scene(TriMesh mesh, const Trajectory& trajectory, int resolution) : body(std::move(mesh)) {
  topology = buildTopology(body);
  Eigen::AlignedBox3d box;
  for (const auto& v : body.vertices) box.extend(v);
  Options options;
  options.resolution = resolution;
  RunContext run;
  const Motion coarse = refineMotion(body, trajectory, box.diagonal().norm() / 50, run);
  const double cell = plannedCell(sweptBox(body, coarse, run), options);
  motion = refineMotion(body, trajectory, kChordFraction * cell, run);
  grid = planGrid(sweptBox(body, motion, run), box, options);
}

Trajectory turningPath(int poses, Interpolation interpolation) {
  Trajectory path;
  path.interpolation = interpolation;
  for (int n = 0; n < poses; ++n) {
    path.poses.push_back(
        poseOf(n, placement({1, 2, 3}, 25.0 * n, {2.0 * n, 0.4 * n * n, 0.3 * n})));
  }
  return path;
}

namespace {

struct Contributing {
  std::int32_t i, j, k;
  int axis;
  std::uint8_t sides;
  const MarkedEdge* edge;

  bool operator<(const Contributing& b) const {
    return std::tie(i, axis, j, k, sides) < std::tie(b.i, b.axis, b.j, b.k, b.sides);
  }
};

std::vector<Contributing> contributing(const MarkedEdges& marked, const GridPlan& grid,
                                       const SignRuns& signs) {
  std::vector<Contributing> all;
  for (std::int32_t i = 0; i < grid.points[0]; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      forContributing(marked, signs, grid, i, axis,
                      [&](std::int32_t j, const MarkedEdge& e, std::uint8_t sides) {
                        all.push_back({i, j, e.k, axis, sides, &e});
                      });
    }
  }
  return all;
}

}  // namespace

Difference compare(const Scene& scene, const MarkedEdges& a, const MarkedEdges& b,
                   const SignRuns& signs) {
  Difference out;
  RunContext run;
  const auto left = contributing(a, scene.grid, signs);
  const auto right = contributing(b, scene.grid, findOutside(b, scene.grid, run));
  std::vector<Contributing> only;
  std::set_symmetric_difference(left.begin(), left.end(), right.begin(), right.end(),
                                std::back_inserter(only));
  out.edges = static_cast<std::int64_t>(only.size());
  if (out.edges != 0) return out;
  for (std::size_t n = 0; n < left.size(); ++n) {
    const MarkedEdge &e = *left[n].edge, &f = *right[n].edge;
    const auto side = [&](float x, float y, std::uint32_t s, std::uint32_t t) {
      ++out.contributing;
      out.fractions += x != y;
      out.largestFraction = std::max(out.largestFraction, std::abs(double{x} - double{y}));
      const SweptElement &u = a.elements[s], &v = b.elements[t];
      out.elements += u.code != v.code || u.placement != v.placement;
    };
    if ((left[n].sides & HermiteEdge::kLow) != 0) {
      side(e.lowFraction, f.lowFraction, e.lowElement, f.lowElement);
    }
    if ((left[n].sides & HermiteEdge::kHigh) != 0) {
      side(e.highFraction, f.highFraction, e.highElement, f.highElement);
    }
  }
  return out;
}

}  // namespace swept::test
