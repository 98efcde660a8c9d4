// Finds the meaning of the columns in a table of poses from the header line.
// In: the fields of the line. Out: for each column, which of the eight numbers of a pose it holds.
// Knows the column names of this project, of ROS and of the EuRoC data sets. Ignores case, quotes,
// a leading # and units in brackets.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swept {

constexpr std::array<const char*, 8> kPoseColumns{"t", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};
constexpr std::size_t kNoPoseColumn = kPoseColumns.size();

struct TrajectoryHeader {
  std::vector<std::size_t> target;  ///< per column: index into kPoseColumns, or kNoPoseColumn
  double secondsPerUnit = 1;        ///< of the time column, from [ns], [us] or [ms]
  std::optional<std::size_t> unknown, repeated;  ///< first column with an unknown or repeated name
  std::optional<std::size_t> missing;            ///< first entry of kPoseColumns without a column
};

/// Returns a name in its plain form for comparison: "p_rs_r_x" for "P_RS_R_x [m]".
std::string plainColumnName(std::string_view field);
TrajectoryHeader readTrajectoryHeader(const std::vector<std::string_view>& fields);

}  // namespace swept
