// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cavities/cavities.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/parallel.h"
#include "geometry/ray_columns.h"
#include "offset/cover_tree.h"

namespace swept {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kAsked = 8;  // points of a component
constexpr double kGrazing = 0.05;  // cells: nearer to the body than this counts as held

/// Does the moving body ever hold a point?
class Holder {
 public:
  explicit Holder(const SamplerInput& input)
      : input_(input), rays_(input.body), cover_(coverOf(input.body)), tree_(cover_.triangles) {
    grazing_ = kGrazing * input.grid.cell;
    const auto& placements = input.motion.placements;
    for (const Placement& p : placements) rotations_.emplace_back(p.rotation);
  }

  bool holds(const Vector3d& world) const {
    const std::size_t n = input_.motion.placements.size();
    if (!input_.motion.continuous) {
      // In strides: what is held at all is mostly held by many copies.
      const std::size_t stride = n > 64 ? n / 64 | 1 : 1;
      for (std::size_t start = 0; start < stride; ++start) {
        for (std::size_t k = start; k < n; k += stride) {
          if (isHeld(inBody(world, k, 0))) return true;
        }
      }
      return false;
    }
    for (std::size_t k = 0; k + 1 < n; ++k) {
      if (inStep(world, k, 0, 1)) return true;
    }
    return false;
  }

 private:
  static offset::Cover coverOf(const TriMesh& body) {
    return offset::coverOfMesh(body, {}, GridPlan{});
  }

  /// The point in the body's frame, a share s of step k after its start.
  Vector3d inBody(const Vector3d& world, std::size_t k, double s) const {
    const Placement& p = input_.motion.placements[k];
    if (s == 0) return p.rotation.transpose() * (world - p.translation);
    const Placement& q = input_.motion.placements[k + 1];
    return rotations_[k].slerp(s, rotations_[k + 1]).conjugate() *
           (world - (1 - s) * p.translation - s * q.translation);
  }
  bool isInside(const Vector3d& x) const {
    if ((x.array() < rays_.low().array()).any() || (x.array() > rays_.high().array()).any()) {
      return false;
    }
    std::vector<RayColumns::Crossing> crossings;
    rays_.crossings(x.y(), x.z(), crossings);
    int winding = 0;
    for (const auto& crossing : crossings) {
      if (crossing.x > x.x()) winding -= crossing.direction;
    }
    return winding > 0;
  }
  bool isHeld(const Vector3d& x) const {
    return isInside(x) || tree_.nearest(x, grazing_).triangle >= 0;
  }
  bool inStep(const Vector3d& world, std::size_t k, double from, double to) const {
    const Placement &p = input_.motion.placements[k], &q = input_.motion.placements[k + 1];
    const double angle = rotations_[k].angularDistance(rotations_[k + 1]);
    const double shift = (q.translation - p.translation).norm();
    const double arm = std::max((world - p.translation).norm(), (world - q.translation).norm());
    const double way = (shift + angle * arm) * (to - from) / 2 * (1 + 1e-9);
    const Vector3d x = inBody(world, k, (from + to) / 2);
    const double clear = std::max(way, 0.0) + grazing_;
    const auto found = tree_.nearest(x, clear);
    if (found.triangle < 0) return isInside(x);
    if (found.reach < grazing_) return true;
    if (isInside(x)) return true;
    const double middle = (from + to) / 2;
    return inStep(world, k, from, middle) || inStep(world, k, middle, to);
  }

  const SamplerInput& input_;
  RayColumns rays_;
  offset::Cover cover_;
  offset::CoverTree tree_;
  std::vector<Eigen::Quaterniond> rotations_;
  double grazing_ = 0;
};

struct Asked {
  std::int32_t length = 0;  ///< of the run
  std::array<std::int32_t, 3> point{0, 0, 0};
};

}  // namespace

std::int64_t openCavities(SignRuns& signs, const std::vector<std::uint32_t>& component,
                          const MarkedEdges& marked, const SamplerInput& input,
                          const SolidPoint& isSolid, RunContext& run) {
  std::vector<std::uint32_t> names;
  std::vector<std::vector<Asked>> asked;
  std::unordered_map<std::uint32_t, std::size_t> place;
  const GridPlan& grid = input.grid;
  for (std::int32_t i = 0; i < grid.points[0]; ++i) {
    const LayerEdges& layer = marked.layers[i];
    for (std::int32_t j = 0; j < grid.points[1]; ++j) {
      std::uint32_t r = signs.firstRun[signs.line(i, j)];
      std::int32_t low = 0;
      const std::uint32_t begin = layer.columnStart[2][j], end = layer.columnStart[2][j + 1];
      for (std::uint32_t e = begin; e <= end; ++e, ++r) {
        const std::int32_t high = e < end ? layer.edges[2][e].k : grid.points[2] - 1;
        const std::int32_t length = high - low + 1;
        const Asked one{length, {i, j, low + length / 2}};
        low = high + 1;
        if (signs.outside[r] != 0) continue;
        const auto [it, fresh] = place.try_emplace(component[r], names.size());
        if (fresh) {
          names.push_back(component[r]);
          asked.emplace_back();
        }
        auto& points = asked[it->second];
        points.push_back(one);
        for (std::size_t at = points.size(); at-- > 1 && points[at - 1].length < length;) {
          std::swap(points[at - 1], points[at]);
        }
        if (points.size() > kAsked) points.pop_back();
      }
    }
  }
  const Holder holder(input);
  std::vector<std::uint8_t> hollow(names.size(), 0);
  parallelBlocks(names.size(), 16, [&](std::size_t begin, std::size_t end) {
    run.checkpoint(Phase::Signs, begin, names.size());
    for (std::size_t c = begin; c < end; ++c) {
      hollow[c] = std::none_of(asked[c].begin(), asked[c].end(), [&](const Asked& a) {
        if (isSolid && isSolid(a.point[0], a.point[1], a.point[2])) return true;
        return holder.holds(grid.origin + grid.cell * Vector3d(a.point[0], a.point[1], a.point[2]));
      });
    }
  });
  for (std::size_t r = 0; r < signs.outside.size(); ++r) {
    if (signs.outside[r] == 0) signs.outside[r] = hollow[place.at(component[r])];
  }
  return std::count(hollow.begin(), hollow.end(), 1);
}

}  // namespace swept
