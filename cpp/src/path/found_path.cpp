// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/found_path.h"

#include <algorithm>
#include <numbers>

#include "base/number_text.h"
#include "base/parallel.h"

namespace swept::path {

double smallestGuaranteed(const std::vector<NeighbourClearance>& rows) {
  double smallest = rows.front().guaranteed;
  for (const NeighbourClearance& row : rows) smallest = std::min(smallest, row.guaranteed);
  return smallest;
}

double provenClearance(const std::vector<NeighbourClearance>& rows, const Demand& demand) {
  return std::max(smallestGuaranteed(rows),
                  *std::min_element(demand.required.begin(), demand.required.end()));
}

std::vector<NeighbourClearance> certificateOf(const Scene& scene, const Demand& demand,
                                              const Trajectory& motion, const Rule& rule,
                                              RunContext& run) {
  const clearance::MotionTree tree = scene.motionTree(motion);
  std::vector<NeighbourClearance> rows(scene.count());
  parallelFor(scene.count(), [&](std::size_t i) {
    if (rule[i] < 0) return;
    rows[i] = checkNeighbour(scene, demand, i, tree, demand.required[i], run);
    run.checkpoint(Phase::Check);
  });
  for (std::size_t i = scene.count(); i-- > 0;)
    if (rule[i] < 0) rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i));
  return rows;
}

bool allClear(const std::vector<NeighbourClearance>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const NeighbourClearance& row) {
    return row.verdict == ClearanceVerdict::Clear;
  });
}

void toCallerWorld(const Scene& scene, std::vector<NeighbourClearance>& rows) {
  for (NeighbourClearance& row : rows) {
    const double time = row.timeSeconds;
    row.pose = scene.outside(scene.at(row.pose));
    row.pose.timeSeconds = time;
    row.pointOnBody = scene.world().transpose() * row.pointOnBody;
    row.pointOnNeighbour = scene.world().transpose() * row.pointOnNeighbour;
  }
}

void addLength(const std::vector<State>& keys, PathReport& report) {
  for (std::size_t i = 1; i < keys.size(); ++i) {
    report.length += (keys[i].middle - keys[i - 1].middle).norm();
    report.turn += keys[i].pose.rotation.angularDistance(keys[i - 1].pose.rotation);
  }
}

std::string figuresText(const PathReport& report) {
  return textOf(4, "path of ", report.path.poses.size(), " keys, length ", report.length,
                " mm, total turn ", report.turn * 180 / std::numbers::pi,
                " degrees, clearance at least ", report.clearance, " mm");
}

}  // namespace swept::path
