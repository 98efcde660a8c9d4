// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/trajectory_header.h"

#include <algorithm>
#include <map>

namespace swept {
namespace {

// Returns the index into kPoseColumns for a plain name; kNoPoseColumn for an unknown name.
std::size_t targetOf(const std::string& name) {
  static const std::map<std::string_view, std::size_t> known{
      {"t", 0},        {"t_s", 0},    {"time", 0},    {"time_s", 0}, {"timestamp", 0},
      {"stamp", 0},    {"tx", 1},     {"x", 1},       {"p_x", 1},    {"pos_x", 1},
      {"p_rs_r_x", 1}, {"ty", 2},     {"y", 2},       {"p_y", 2},    {"pos_y", 2},
      {"p_rs_r_y", 2}, {"tz", 3},     {"z", 3},       {"p_z", 3},    {"pos_z", 3},
      {"qx", 4},       {"q_x", 4},    {"q_rs_x", 4},  {"qy", 5},     {"q_y", 5},
      {"qz", 6},       {"q_z", 6},    {"qw", 7},      {"q_w", 7},    {"q_rs_w", 7},
      {"q_rs_y", 5},   {"q_rs_z", 6}, {"p_rs_r_z", 3}};
  const auto found = known.find(name);
  return found == known.end() ? kNoPoseColumn : found->second;
}

// EuRoC ground-truth tables give times in ns without a unit. Their column p_RS_R_x identifies them.
double secondsPerUnitOf(std::string_view field, bool euroc) {
  if (field.find("[s]") != std::string_view::npos) return 1.0;
  if (euroc || field.find("[ns]") != std::string_view::npos) return 1e-9;
  if (field.find("[us]") != std::string_view::npos) return 1e-6;
  return field.find("[ms]") != std::string_view::npos ? 1e-3 : 1.0;
}

}  // namespace

std::string plainColumnName(std::string_view field) {
  field = field.substr(0, field.find_first_of("[("));
  const std::size_t first = field.find_first_not_of("#\" \t");
  const std::size_t last = field.find_last_not_of("\" \t");
  if (first == std::string_view::npos) return {};
  std::string name(field.substr(first, last + 1 - first));
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return name;
}

TrajectoryHeader readTrajectoryHeader(const std::vector<std::string_view>& fields) {
  TrajectoryHeader header;
  std::array<bool, kPoseColumns.size()> seen{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t target = targetOf(plainColumnName(fields[i]));
    header.target.push_back(target);
    if (target == kNoPoseColumn) {
      if (!header.unknown) header.unknown = i;
      continue;
    }
    if (seen[target] && !header.repeated) header.repeated = i;
    seen[target] = true;
  }
  const auto names = [&](std::size_t target) {
    const auto column = std::find(header.target.begin(), header.target.end(), target);
    return column == header.target.end() ? std::string_view()
                                         : fields[column - header.target.begin()];
  };
  header.secondsPerUnit = secondsPerUnitOf(names(0), plainColumnName(names(1)) == "p_rs_r_x");
  for (std::size_t c = 0; c < seen.size() && !header.missing; ++c)
    if (!seen[c]) header.missing = c;
  return header;
}

}  // namespace swept
