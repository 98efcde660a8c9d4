// Reads a table of poses row by row, up to a limit of rows. A single error makes the reader refuse
// the whole table.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/limits.h"
#include "base/number_text.h"
#include "io/line_source.h"
#include "io/text_mesh.h"
#include "io/trajectory_header.h"
#include "swept/io.h"

namespace swept {
namespace {

constexpr std::size_t kMaxRows = 10'000'000;  // about 1 GB of poses

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
      if (text.empty()) continue;
      if (text.front() == '#') {
        if (poses_.empty()) readComment(text);
        continue;
      }
      if (!rowsBegun_) chooseSeparator(line);
      rowsBegun_ = true;
      split(line);
      if (isBlank()) continue;
      if (isHeader()) {
        readHeader(line);
      } else {
        readRow();
      }
    }
    if (poses_.empty()) {
      throw Error(Status::InvalidInput, "EmptyTrajectory",
                  "'" + path_ +
                      "' has no row of numbers; expected in each row t,tx,ty,tz,qx,qy,qz,qw, or "
                      "the 12, 16 or 17 numbers of a matrix");
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
    // Some spreadsheets write one separator at the end of each row.
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

  // Returns true for a row with separators only: some spreadsheets write empty lines in this way.
  bool isBlank() const {
    return std::all_of(fields_.begin(), fields_.end(),
                       [](std::string_view field) { return field.empty(); });
  }

  static bool isMatrix(std::size_t width) { return width == 12 || width == 16 || width == 17; }

  // Recordings often name their columns in a comment. Such a comment counts as a header if it names
  // all eight columns of a pose.
  void readComment(std::string_view text) {
    const char rows = separator_;
    chooseSeparator(text);
    split(text.substr(text.find_first_not_of("# \t") == std::string_view::npos
                          ? text.size()
                          : text.find_first_not_of("# \t")));
    separator_ = rows;
    TrajectoryHeader header = readTrajectoryHeader(fields_);
    if (header.missing || header.repeated || width_ != 0) return;
    setWidth(fields_.size());
    fromComment_ = true;
    columns_ = std::move(header);
  }

  void readHeader(const std::string& line) {
    if (line == headerLine_) return;  // concatenated recordings repeat the header
    if (width_ != 0 && !fromComment_) notANumber(0);
    headerLine_ = line;
    fromComment_ = false;
    TrajectoryHeader header = readTrajectoryHeader(fields_);
    if (header.missing && isMatrix(fields_.size())) {
      setWidth(fields_.size());  // the names of matrix entries vary, but their order does not
      return;
    }
    if (header.unknown && (header.missing || fields_.size() <= kPoseColumns.size())) {
      bad(*header.unknown + 1, "unknown column '" +
                                   plainColumnName(fields_[*header.unknown]).substr(0, 40) +
                                   "'; expected t,tx,ty,tz,qx,qy,qz,qw in any order, or the 12 or "
                                   "16 numbers of a matrix");
    }
    if (header.repeated) {
      bad(*header.repeated + 1, "the column '" + plainColumnName(fields_[*header.repeated]) +
                                    "' occurs twice; remove one of them");
    }
    if (header.missing)
      bad(0, std::string("the column '") + kPoseColumns[*header.missing] + "' is missing");
    setWidth(fields_.size());
    columns_ = std::move(header);
  }

  void setWidth(std::size_t width) {
    width_ = width;
    values_.resize(width);
  }

  void readRow() {
    if (width_ == 0) {
      if (fields_.size() != kPoseColumns.size() && !isMatrix(fields_.size())) {
        bad(0,
            "expected 8 numbers (t,tx,ty,tz,qx,qy,qz,qw), or 12, 16 or 17 numbers (a matrix); "
            "found " +
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
                      " rows; reduce the number of poses");
    }
    for (std::size_t i = 0; i < width_; ++i) {
      if (!columns_.target.empty() && columns_.target[i] == kNoPoseColumn) continue;
      if (!parseField(fields_[i], values_[i])) notANumber(i);
      if (!std::isfinite(values_[i])) {
        throw Error(Status::InvalidInput, "BadPose",
                    "'" + path_ + "', line " + std::to_string(lines_.number()) + ", column " +
                        std::to_string(i + 1) + ", pose " + std::to_string(poses_.size() + 1) +
                        ": '" + std::string(fields_[i]) +
                        "' is not a finite number; correct or remove this row");
      }
    }
    const bool columns = width_ == kPoseColumns.size() || !columns_.target.empty();
    poses_.push_back(columns ? poseFromColumns() : poseFromRow());
    poses_.back().translation *= scale_;
  }

  // Parses a number. Accepts a decimal comma if the separator is another character.
  bool parseField(std::string_view field, double& value) const {
    if (parseNumber(field, value)) return true;
    const std::size_t comma = field.find(',');
    if (separator_ == ',' || comma == std::string_view::npos ||
        field.find('.') != std::string_view::npos)
      return false;
    std::string pointed(field);
    pointed[comma] = '.';
    return parseNumber(pointed, value);
  }

  // Returns a hint about decimal commas. If the comma is the separator, it splits a number such as
  // 0,5 in two, so the row has too many columns.
  std::string hint() const {
    const bool doubled = separator_ == ',' && fields_.size() > 8;
    return doubled ? "; use decimal points instead of decimal commas" : "";
  }

  [[noreturn]] void notANumber(std::size_t column) const {
    const std::string field(fields_[column].substr(0, 40));
    if (field.empty()) bad(column + 1, "expected a number, found nothing");
    bad(column + 1, "expected a number, found '" + field + "'");
  }

  Pose poseFromColumns() const {
    std::array<double, kPoseColumns.size()> v{};
    for (std::size_t i = 0; i < width_; ++i) {
      const std::size_t target = columns_.target.empty() ? i : columns_.target[i];
      if (target < v.size()) v[target] = values_[i];
    }
    Pose pose;
    pose.timeSeconds = v[0] * columns_.secondsPerUnit;
    pose.translation = Eigen::Vector3d(v[1], v[2], v[3]);
    pose.rotation = Eigen::Quaterniond(v[7], v[4], v[5], v[6]);
    const double length = pose.rotation.norm();
    if (std::abs(length - 1) > kRigidLimit) {
      throw Error(Status::InvalidInput, "NotRigid",
                  "'" + path_ + "', line " + std::to_string(lines_.number()) + ", pose " +
                      std::to_string(poses_.size() + 1) + ": the quaternion has length " +
                      numberText(length) +
                      " instead of 1 (allowed error: 1e-4); write unit quaternions in the order "
                      "qx,qy,qz,qw with at least 5 decimals");
    }
    return pose;
  }

  Pose poseFromRow() const {
    const auto index = static_cast<std::int64_t>(poses_.size());
    const double time = width_ == 17 ? values_[0] : static_cast<double>(index);
    std::array<double, 16> matrix{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    const auto first = values_.begin() + (width_ == 17 ? 1 : 0);
    std::copy(first, values_.end(), matrix.begin());
    try {
      return poseFromMatrix(matrix.data(), time, index);
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
  bool rowsBegun_ = false;
  bool fromComment_ = false;
  std::string headerLine_;
  TrajectoryHeader columns_;  // without targets: the columns of kPoseColumns, or of a matrix
  std::vector<std::string_view> fields_;
  std::vector<double> values_;
  std::vector<Pose> poses_;
};

}  // namespace

Trajectory readTrajectoryCsv(const std::string& path, double millimetresPerUnit,
                             Interpolation interpolation) {
  if (!(millimetresPerUnit > 0) || !std::isfinite(millimetresPerUnit)) {
    throw Error(Status::InvalidInput, "BadOption",
                "the number of millimetres per unit is " +
                    numberText(millimetresPerUnit, kTellingDigits) +
                    ", but must be a finite number above 0, such as 1 for mm or 1000 for m");
  }
  Trajectory trajectory;
  trajectory.interpolation = interpolation;
  trajectory.poses = CsvReader(path, millimetresPerUnit).read();
  return trajectory;
}

}  // namespace swept
