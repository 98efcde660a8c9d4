// Reads the content of an HTML page from a report: one row per pair of parts. The rows have the
// same form for a check of one moving body and for a mechanism check. All errors of a report are
// detected here.
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
  std::string name;           ///< name of the pair, as in the report
  std::string first, second;  ///< names of its parts; `first` is empty in a clearance report
  std::string verdict;        ///< clear | below | contact | clash
  bool meetsRule = false;
  double distance = 0, guaranteed = 0, time = 0;  ///< mm, mm, s
  std::optional<double> required;                 ///< mm; not set for a pair that may touch
  std::optional<double> contact;  ///< set if the pair may touch: allowed depth in mm
  /// Bounds of the depth of a clash (mm), and its time (s).
  struct Depth {
    double least, most, time;
  };
  std::optional<Depth> depth;
  double belowSeconds = 0;  ///< s, how long the distance is below the required one
  /// The two closest points; for a clash, the deepest point and its nearest point on the surface.
  std::array<Eigen::Vector3d, 2> line;
  Pose pose;                                     ///< pose of the first part at `time`
  std::vector<std::pair<double, double>> curve;  ///< time (s) and distance (mm)
};

struct CheckReport {
  Json report;  ///< without seconds, threads and memory, which differ from run to run
  bool mechanism = false;
  std::vector<Row> rows;           ///< in the order of the report
  std::vector<std::size_t> order;  ///< indices of rows, the worst one first
  /// names of neighbours or pairs: not checked because of a rule, and not moving relative to each
  /// other
  std::vector<std::string> ignored, joined;
  std::size_t failing() const;
};

/// Parses a report. Throws Error(InvalidInput, "BadReport") if the text is not a report in the
/// format version of this program. Also throws if the report is of a failed run, unless it is the
/// report of a study.
Json parseReport(const std::string& text);
/// Reads the report of a clearance check or of a mechanism check. Throws Error(InvalidInput,
/// "BadReport").
CheckReport readCheck(Json report);

[[noreturn]] void badReport(const std::string& text);
/// Returns a number that must be 0 or more. Throws Error(InvalidInput, "BadReport").
double lengthOf(const Json& row, const char* key);

}  // namespace swept::page
