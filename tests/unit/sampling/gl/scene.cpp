// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unit/sampling/gl/scene.h"

#include <algorithm>
#include <cmath>

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
  motion = refineMotion(body, trajectory, options.chordTolerance * cell, run);
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

Difference compare(const Scene& scene, const MarkedEdges& a, const MarkedEdges& b,
                   const SignRuns& signs) {
  Difference out;
  for (std::int32_t i = 0; i < scene.grid.points[0]; ++i) {
    const LayerEdges &p = a.layers[i], &q = b.layers[i];
    for (int axis = 0; axis < 3; ++axis) {
      for (std::int32_t j = 0; j < scene.grid.points[1]; ++j) {
        std::vector<std::uint16_t> left, right, only;
        for (auto n = p.columnStart[axis][j]; n < p.columnStart[axis][j + 1]; ++n) {
          left.push_back(p.edges[axis][n].k);
        }
        for (auto n = q.columnStart[axis][j]; n < q.columnStart[axis][j + 1]; ++n) {
          right.push_back(q.edges[axis][n].k);
        }
        std::set_symmetric_difference(left.begin(), left.end(), right.begin(), right.end(),
                                      std::back_inserter(only));
        out.edges += static_cast<std::int64_t>(only.size());
      }
    }
  }
  if (out.edges != 0) return out;
  for (std::int32_t i = 0; i < scene.grid.points[0]; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto* first = a.layers[i].edges[axis].data();
      forContributing(
          a, signs, scene.grid, i, axis, [&](std::int32_t, const MarkedEdge& e, std::uint8_t) {
            const MarkedEdge& f = b.layers[i].edges[axis][&e - first];
            const auto side = [&](float x, float y, std::uint32_t s, std::uint32_t t) {
              ++out.contributing;
              out.fractions += x != y;
              out.largestFraction = std::max(out.largestFraction, std::abs(double{x} - double{y}));
              const SweptElement &u = a.elements[s], &v = b.elements[t];
              out.elements += u.code != v.code || u.placement != v.placement;
            };
            side(e.lowFraction, f.lowFraction, e.lowElement, f.lowElement);
            side(e.highFraction, f.highFraction, e.highElement, f.highElement);
          });
    }
  }
  return out;
}

}  // namespace swept::test
