// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/found_path.h"

#include <algorithm>
#include <numbers>

#include "base/number_text.h"

namespace swept::path {

double smallestGuaranteed(const std::vector<NeighbourClearance>& rows) {
  double smallest = rows.front().guaranteed;
  for (const NeighbourClearance& row : rows) smallest = std::min(smallest, row.guaranteed);
  return smallest;
}

double certainClearance(const std::vector<NeighbourClearance>& rows, const Demand& demand) {
  return std::max(smallestGuaranteed(rows),
                  *std::min_element(demand.required.begin(), demand.required.end()));
}

std::string figuresText(const PathReport& report) {
  return "path of " + std::to_string(report.path.poses.size()) + " keys, " +
         numberText(report.length, 4) + " mm and " +
         numberText(report.turn * 180 / std::numbers::pi, 4) + " degrees, clearance at least " +
         numberText(report.clearance, 4) + " mm";
}

}  // namespace swept::path
