// Table of poses -> trajectory. Row by row, under a row limit; no partial trajectory on any error.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "base/number_text.h"
#include "io/exact_numbers.h"
#include "io/line_source.h"
#include "swept/io.h"

namespace swept {
namespace {

constexpr std::size_t kMaxRows = 10'000'000;  // about 1 GB of poses
constexpr double kRigidLimit = 1e-4;
constexpr std::array<const char*, 8> kColumnNames{"t", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};

std::string_view trim(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

class CsvReader {
 public:
  CsvReader(const std::string& path, double millimetresPerUnit)
      : path_(path), lines_(path), scale_(millimetresPerUnit) {}

  std::vector<Pose> read() {
    std::string line;
    while (lines_.next(line)) {
      const std::string_view text = trim(line);
      if (text.empty() || text.front() == '#') continue;
      if (separator_ == 0) chooseSeparator(line);
      split(line);
      if (width_ == 0 && isHeader()) {
        takeHeader();
      } else {
        takeRow();
      }
    }
    if (poses_.empty()) {
      throw Error(Status::InvalidInput, "EmptyTrajectory",
                  "'" + path_ +
                      "' has no row of numbers; expected t,tx,ty,tz,qx,qy,qz,qw or 16 "
                      "matrix numbers a row");
    }
    return std::move(poses_);
  }

 private:
  [[noreturn]] void bad(std::size_t column, const std::string& what) const {
    throw Error(Status::InvalidInput, "BadFile",
                "'" + path_ + "', line " + std::to_string(lines_.number()) +
                    (column != 0 ? ", column " + std::to_string(column) : "") + ": " + what);
  }

  void chooseSeparator(std::string_view line) {
    for (const char candidate : {'\t', ';', ','}) {
      if (line.find(candidate) != std::string_view::npos) {
        separator_ = candidate;
        return;
      }
    }
    separator_ = ' ';
  }

  void split(std::string_view line) {
    fields_.clear();
    if (separator_ == ' ') {
      line = trim(line);
      while (!line.empty()) {
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        fields_.push_back(line.substr(0, end));
        line = trim(line.substr(end));
      }
      return;
    }
    std::size_t start = 0;
    while (start <= line.size()) {
      const std::size_t end = std::min(line.find(separator_, start), line.size());
      fields_.push_back(trim(line.substr(start, end - start)));
      start = end + 1;
    }
    // One separator at the end of the row is a habit of some spreadsheets.
    if (fields_.size() > 1 && fields_.back().empty()) fields_.pop_back();
  }

  static bool startsLikeNumber(std::string_view field) {
    double ignored = 0;
    return parseNumber(field, ignored) ||
           (!field.empty() &&
            std::string_view("0123456789+-.").find(field.front()) != std::string_view::npos);
  }

  bool isHeader() const {
    return std::none_of(fields_.begin(), fields_.end(),
                        [](std::string_view field) { return startsLikeNumber(field); });
  }

  void takeHeader() {
    if (fields_.size() == 16 || fields_.size() == 17) {
      setWidth(fields_.size());  // matrix: the names of its entries vary, their order does not
      return;
    }
    static const std::map<std::string_view, int> known{
        {"t", 0}, {"t_s", 0}, {"time", 0}, {"time_s", 0}, {"tx", 1}, {"x", 1},  {"ty", 2},
        {"y", 2}, {"tz", 3},  {"z", 3},    {"qx", 4},     {"qy", 5}, {"qz", 6}, {"qw", 7}};
    std::array<bool, 8> seen{};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      std::string name(fields_[i]);
      if (name.size() > 1 && name.front() == '"' && name.back() == '"') {
        name = name.substr(1, name.size() - 2);
      }
      std::transform(name.begin(), name.end(), name.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      });
      const auto found = known.find(name);
      if (found == known.end() || i >= kColumnNames.size()) {
        bad(i + 1, "unknown column '" + name.substr(0, 40) +
                       "'; expected t,tx,ty,tz,qx,qy,qz,qw in any order, or 16 matrix numbers");
      }
      const auto target = static_cast<std::size_t>(found->second);
      if (seen[target]) bad(i + 1, "the column '" + name + "' stands twice");
      seen[target] = true;
      order_[i] = target;
    }
    for (std::size_t c = 0; c < seen.size(); ++c) {
      if (!seen[c]) bad(0, std::string("the column '") + kColumnNames[c] + "' is missing");
    }
    setWidth(8);
  }

  void setWidth(std::size_t width) {
    width_ = width;
    values_.resize(width);
  }

  void takeRow() {
    if (width_ == 0) {
      if (fields_.size() != 8 && fields_.size() != 16 && fields_.size() != 17) {
        bad(0, "expected 8 numbers (t,tx,ty,tz,qx,qy,qz,qw), 16 or 17 (matrix), found " +
                   std::to_string(fields_.size()) + hint());
      }
      setWidth(fields_.size());
    }
    if (fields_.size() != width_) {
      bad(std::min(fields_.size(), width_) + 1, "expected " + std::to_string(width_) +
                                                    " columns, found " +
                                                    std::to_string(fields_.size()) + hint());
    }
    if (poses_.size() >= kMaxRows) {
      throw Error(Status::ResourceLimit, "TooManyPoses",
                  "'" + path_ + "' has more than " + std::to_string(kMaxRows) +
                      " rows; thin the poses out");
    }
    for (std::size_t i = 0; i < width_; ++i) {
      if (!parseNumber(fields_[i], values_[i])) notANumber(i);
      if (!std::isfinite(values_[i])) {
        throw Error(Status::InvalidInput, "BadPose",
                    "'" + path_ + "', line " + std::to_string(lines_.number()) + ", column " +
                        std::to_string(i + 1) + ", pose " + std::to_string(poses_.size() + 1) +
                        ": '" + std::string(fields_[i]) + "' is not a finite number");
      }
    }
    poses_.push_back(width_ == 8 ? poseFromColumns() : poseFromRow());
    poses_.back().translation *= scale_;
  }

  // 0,5 split at its comma: more columns than expected, all of them whole numbers.
  std::string hint() const {
    const bool doubled = separator_ == ',' && fields_.size() > 8;
    return doubled ? "; a decimal comma? write numbers with a point" : "";
  }

  [[noreturn]] void notANumber(std::size_t column) const {
    const std::string field(fields_[column].substr(0, 40));
    if (field.empty()) bad(column + 1, "expected a number, found nothing");
    std::string pointed = field;
    std::replace(pointed.begin(), pointed.end(), ',', '.');
    double ignored = 0;
    const bool comma = pointed != field && parseNumber(pointed, ignored);
    bad(column + 1, "expected a number, found '" + field + "'" +
                        (comma ? "; write decimals with a point, not a comma" : ""));
  }

  Pose poseFromColumns() const {
    std::array<double, 8> v{};
    for (std::size_t i = 0; i < 8; ++i) v[order_[i]] = values_[i];
    Pose pose;
    pose.timeSeconds = v[0];
    pose.translation = Eigen::Vector3d(v[1], v[2], v[3]);
    pose.rotation = Eigen::Quaterniond(v[7], v[4], v[5], v[6]);
    const double length = pose.rotation.norm();
    if (std::abs(length - 1) > kRigidLimit) {
      throw Error(Status::InvalidInput, "NotRigid",
                  "'" + path_ + "', line " + std::to_string(lines_.number()) + ", pose " +
                      std::to_string(poses_.size() + 1) + ": the quaternion has length " +
                      numberText(length) +
                      " instead of 1 (limit 1e-4 off); write unit quaternions with at least 5 "
                      "decimals, order qx,qy,qz,qw");
    }
    return pose;
  }

  Pose poseFromRow() const {
    const auto index = static_cast<std::int64_t>(poses_.size());
    const double time = width_ == 17 ? values_[0] : static_cast<double>(index);
    try {
      return poseFromMatrix(values_.data() + (width_ == 17 ? 1 : 0), time, index);
    } catch (const Error& error) {
      throw Error(error.status(), error.code(),
                  "'" + path_ + "', line " + std::to_string(lines_.number()) + ", " + error.what());
    }
  }

  std::string path_;
  LineSource lines_;
  double scale_;
  char separator_ = 0;
  std::size_t width_ = 0;
  std::array<std::size_t, 8> order_{0, 1, 2, 3, 4, 5, 6, 7};
  std::vector<std::string_view> fields_;
  std::vector<double> values_;
  std::vector<Pose> poses_;
};

}  // namespace

Trajectory readTrajectoryCsv(const std::string& path, double millimetresPerUnit,
                             Interpolation interpolation) {
  if (!(millimetresPerUnit > 0) || !std::isfinite(millimetresPerUnit)) {
    throw Error(Status::InvalidInput, "BadOption",
                "millimetres per unit must be a positive number");
  }
  Trajectory trajectory;
  trajectory.interpolation = interpolation;
  trajectory.poses = CsvReader(path, millimetresPerUnit).read();
  return trajectory;
}

}  // namespace swept
