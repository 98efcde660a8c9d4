// SPDX-License-Identifier: LGPL-2.1-or-later
#include "signs/cavities.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/parallel.h"
#include "geometry/nearest_triangle.h"
#include "geometry/ray_columns.h"
#include "motion/step_path.h"

namespace swept {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMaxPoints = 8;  // lattice points tested per component
/// A point nearer to the body than this (cells) counts as inside.
constexpr double kGrazing = 0.05;

/// Tests whether the moving body ever contains a point.
class MovingSolid {
 public:
  MovingSolid(const TriMesh& body, const Motion& motion, double grazing)
      : motion_(motion),
        rays_(body),
        nearest_(body.vertices, body.triangles),
        squaredGrazing_(grazing * grazing),
        grazing_(grazing) {
    std::vector<Pose> poses;
    for (const Placement& p : motion.placements) {
      poses.push_back({p.timeSeconds, Eigen::Quaterniond(p.rotation), p.translation});
    }
    for (std::size_t k = 0; k < motion.steps(); ++k) {
      steps_.emplace_back(poses[k], poses[k + 1], Interpolation::Linear);
    }
  }

  bool everContains(const Vector3d& world) const {
    const std::size_t n = motion_.placements.size();
    if (!motion_.continuous) {
      // Visits the copies in strides, because a point that lies inside a copy usually lies inside
      // many successive ones.
      const std::size_t stride = n > 64 ? n / 64 | 1 : 1;
      for (std::size_t start = 0; start < stride; ++start) {
        for (std::size_t k = start; k < n; k += stride) {
          if (contains(motion_.placements[k].applyInverse(world))) return true;
        }
      }
      return false;
    }
    for (std::size_t k = 0; k + 1 < n; ++k) {
      if (containsDuringStep(world, k, 0, 1)) return true;
    }
    return false;
  }

 private:
  bool isInside(const Vector3d& x) const { return rays_.winding(x) > 0; }
  bool contains(const Vector3d& x) const {
    return isInside(x) || nearest_.query(x, squaredGrazing_, squaredGrazing_) < squaredGrazing_;
  }
  bool containsDuringStep(const Vector3d& world, std::size_t k, double from, double to) const {
    const Placement &p = motion_.placements[k], &q = motion_.placements[k + 1];
    const double shift = (q.translation - p.translation).norm();
    const double arm = std::max((world - p.translation).norm(), (world - q.translation).norm());
    const double reach = (shift + steps_[k].angle() * arm) * (to - from) / 2 * (1 + 1e-9);
    const Vector3d x = steps_[k].at((from + to) / 2).applyInverse(world);
    const double limit = std::max(reach, 0.0) + grazing_;
    const double squared = nearest_.query(x, limit * limit, squaredGrazing_);
    if (squared >= limit * limit) return isInside(x);
    if (squared < squaredGrazing_) return true;
    if (isInside(x)) return true;
    const double middle = (from + to) / 2;
    return containsDuringStep(world, k, from, middle) || containsDuringStep(world, k, middle, to);
  }

  const Motion& motion_;
  RayColumns rays_;
  NearestTriangle nearest_;
  std::vector<StepPath> steps_;
  double squaredGrazing_;
  double grazing_;
};

/// A lattice point of a component at which the component is tested.
struct TestPoint {
  std::int32_t length = 0;  ///< of the run in whose middle the point lies
  std::array<std::int32_t, 3> point{0, 0, 0};
};

}  // namespace

std::int64_t openCavities(SignRuns& signs, const std::vector<std::uint32_t>& component,
                          const MarkedEdges& marked, const GridPlan& grid, const TriMesh& body,
                          const Motion& motion, const SolidPoint& isSolid, RunContext& run) {
  std::vector<std::uint32_t> numbers;
  std::vector<std::vector<TestPoint>> testPoints;
  std::unordered_map<std::uint32_t, std::size_t> indexOf;
  for (std::int32_t i = 0; i < grid.points[0]; ++i) {
    const LayerEdges& layer = marked.layers[i];
    for (std::int32_t j = 0; j < grid.points[1]; ++j) {
      std::uint32_t r = signs.firstRun[signs.line(i, j)];
      std::int32_t low = 0;
      const std::uint32_t begin = layer.columnStart[2][j], end = layer.columnStart[2][j + 1];
      for (std::uint32_t e = begin; e <= end; ++e, ++r) {
        const std::int32_t high = e < end ? layer.edges[2][e].k : grid.points[2] - 1;
        const std::int32_t length = high - low + 1;
        const TestPoint candidate{length, {i, j, low + length / 2}};
        low = high + 1;
        if (signs.outside[r] != 0) continue;
        const auto [it, fresh] = indexOf.try_emplace(component[r], numbers.size());
        if (fresh) {
          numbers.push_back(component[r]);
          testPoints.emplace_back();
        }
        auto& points = testPoints[it->second];
        points.push_back(candidate);
        for (std::size_t at = points.size(); at-- > 1 && points[at - 1].length < length;) {
          std::swap(points[at - 1], points[at]);
        }
        if (points.size() > kMaxPoints) points.pop_back();
      }
    }
  }
  const MovingSolid solid(body, motion, kGrazing * grid.cell);
  std::vector<std::uint8_t> hollow(numbers.size(), 0);
  parallelBlocks(numbers.size(), 16, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Signs, begin, numbers.size());
    for (std::size_t c = begin; c < end; ++c) {
      hollow[c] = std::none_of(testPoints[c].begin(), testPoints[c].end(), [&](const TestPoint& a) {
        if (isSolid && isSolid(a.point[0], a.point[1], a.point[2])) return true;
        return solid.everContains(grid.origin +
                                  grid.cell * Vector3d(a.point[0], a.point[1], a.point[2]));
      });
    }
  });
  for (std::size_t r = 0; r < signs.outside.size(); ++r) {
    if (signs.outside[r] == 0) signs.outside[r] = hollow[indexOf.at(component[r])];
  }
  return std::count(hollow.begin(), hollow.end(), 1);
}

}  // namespace swept
