// What the columns of a table of poses are, from the line that names them.
// In: the fields of the line. Out: for each column, which of the eight numbers of a pose it is.
// Names are those of this project, of ROS and of the EuRoC data sets; case, quotes, a leading # and
// units in brackets do not count.
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
  std::vector<std::size_t> target;  ///< index into kPoseColumns, or kNoPoseColumn, a column
  double secondsPerUnit = 1;        ///< of the column of times: [ns], [us], [ms]
  std::optional<std::size_t> unknown, repeated;  ///< first column with such a name
  std::optional<std::size_t> missing;            ///< first of kPoseColumns that no column is
};

/// Name as it is compared: "p_rs_r_x" for "P_RS_R_x [m]".
std::string plainColumnName(std::string_view field);
TrajectoryHeader readTrajectoryHeader(const std::vector<std::string_view>& fields);

}  // namespace swept
