// What a page tells, read from a report: a row for each pair, the same for one moving body and for
// mechanisms. Everything that can be wrong with a report is found here.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/report_json.h"
#include "swept/types.h"

namespace swept::page {

struct Row {
  std::string name;           ///< of the pair, as the report has it
  std::string first, second;  ///< its parts; the first of a clearance report has no name
  std::string verdict;        ///< clear | below | contact | clash
  bool meetsRule = false;
  double distance = 0, guaranteed = 0, time = 0;
  std::optional<double> required;  ///< asked for; of a pair that may touch: nothing
  std::optional<double> contact;   ///< may touch, so deep at most
  struct Depth {
    double least, most, time;
  };
  std::optional<Depth> depth;
  double belowSeconds = 0;
  std::array<Eigen::Vector3d, 2> line;  ///< the closest points, or the deepest one and the surface
  Pose pose;                            ///< of the first part at `time`
  std::vector<std::pair<double, double>> curve;  ///< s, mm
};

struct Told {
  Json report;  ///< without what differs from run to run (seconds, threads)
  bool mechanism = false;
  std::vector<Row> rows;                     ///< in the order of the report
  std::vector<std::size_t> order;            ///< numbers of rows, the worst one first
  std::vector<std::string> ignored, joined;  ///< names of neighbours or pairs
  std::size_t failing() const;
};

/// A report as JSON. Throws Error(InvalidInput, "BadReport") for what is none of this version, or
/// of a run that did not end well.
Json parseReport(const std::string& text);
/// Of a check or a mechanism. Throws Error(InvalidInput, "BadReport").
Told tellReport(Json report);

[[noreturn]] void badReport(const std::string& text);
/// A number of 0 or more. Throws Error(InvalidInput, "BadReport").
double lengthOf(const Json& row, const char* key);

}  // namespace swept::page
