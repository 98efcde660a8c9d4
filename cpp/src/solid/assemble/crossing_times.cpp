// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/crossing_times.h"

#include <algorithm>
#include <cstdint>

#include "geometry/self_intersections.h"

namespace swept::step {
namespace {

constexpr int kGridPoints = 32, kGridTimes = 64;  // to test it takes about 10 ms

TriMesh gridOf(const std::function<Eigen::Vector3d(double, double)>& at, Range edge) {
  TriMesh grid;
  for (int j = 0; j <= kGridTimes; ++j) {
    for (int i = 0; i <= kGridPoints; ++i)
      grid.vertices.push_back(
          at(edge.at(static_cast<double>(i) / kGridPoints), static_cast<double>(j) / kGridTimes));
  }
  const auto corner = [](int i, int j) {
    return static_cast<std::int32_t>(j * (kGridPoints + 1) + i);
  };
  for (int j = 0; j < kGridTimes; ++j) {
    for (int i = 0; i < kGridPoints; ++i) {
      grid.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      grid.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return grid;
}

}  // namespace

std::vector<double> crossingTimes(const std::function<Eigen::Vector3d(double, double)>& at,
                                  Range edge, const std::vector<double>& cuts) {
  constexpr int kMinRows = 2;
  RunContext run;
  // The times between the two passes.
  std::vector<Range> between;
  for (const auto& [a, b] : findSelfIntersections(gridOf(at, edge), {}, run).pairs) {
    const int first = a / (2 * kGridPoints), second = b / (2 * kGridPoints);  // rows
    if (second - first < kMinRows) continue;
    const Range times{(first + 1.0) / kGridTimes, static_cast<double>(second) / kGridTimes};
    const bool isCut = std::any_of(cuts.begin(), cuts.end(), [&](double cut) {
      return cut >= times.from - 1.0 / kGridTimes && cut <= times.to + 1.0 / kGridTimes;
    });
    if (!isCut) between.push_back(times);
  }
  std::sort(between.begin(), between.end(),
            [](const Range& a, const Range& b) { return a.to < b.to; });
  std::vector<double> times;
  for (std::size_t i = 0; i < between.size();) {
    Range common = between[i];
    for (; i < between.size() && between[i].from <= common.to; ++i)
      common.from = std::max(common.from, between[i].from);
    times.push_back(common.at(0.5));
  }
  return times;
}

}  // namespace swept::step
