// Writes the data section of a STEP file (ISO 10303-21), and the parts that all STEP files of this
// program contain: header, units, product, colour.
// Units:   mm. Points have 9 decimals (1e-9 mm), directions 13 digits.
// Cost:    O(text), written in blocks. Throws Error(Cancelled). A full disk sets the error state of
//          the stream.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <ostream>
#include <string>
#include <vector>

#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

constexpr int kPointDecimals = 9;
constexpr int kDirectionDigits = 13;
constexpr std::size_t kFlushAt = 1U << 20U;  // characters; longer text is written to the stream

using Id = std::int64_t;

// Writes entities one after another, and numbers them in this order.
class Lines {
 public:
  Lines(std::ostream& out, RunContext& run) : out_(out), run_(run) { text_.reserve(2 * kFlushAt); }

  /// Begins the entity `#n=keyword(` and returns n. The caller appends the arguments, then calls
  /// end().
  Id begin(const char* keyword) {
    text_ += '#';
    integer(++last_);
    text_ += '=';
    text_ += keyword;
    text_ += '(';
    return last_;
  }
  void end() {
    text_ += ");\n";
    flushIfLong();
  }
  Lines& raw(const char* words) {
    text_ += words;
    return *this;
  }
  Lines& raw(const std::string& words) {
    text_ += words;
    return *this;
  }
  Lines& id(Id value) {
    text_ += '#';
    integer(value);
    return *this;
  }
  Lines& ids(const std::vector<Id>& values) {
    text_ += '(';
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) text_ += ',';
      id(values[i]);
    }
    text_ += ')';
    return *this;
  }
  void integer(Id value) {
    std::array<char, 24> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    text_.append(buffer.data(), end);
  }
  Lines& length(double value) { return real(value, std::chars_format::fixed, kPointDecimals); }
  Lines& ratio(double value) { return real(value, std::chars_format::general, kDirectionDigits); }
  Lines& triple(const Eigen::Vector3d& v, bool isPoint) {
    text_ += '(';
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text_ += ',';
      isPoint ? length(v[k]) : ratio(v[k]);
    }
    text_ += ')';
    return *this;
  }
  /// Call this while a long entity is being written.
  void flushIfLong() {
    if (text_.size() > kFlushAt) flush();
  }
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    run_.checkpoint(Phase::Export);
  }
  Id last() const { return last_; }

 private:
  // Writes a real number. STEP requires a point in it, and a capital E before an exponent.
  Lines& real(double value, std::chars_format format, int precision) {
    std::array<char, 400> buffer;
    char* end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0, format, precision)
            .ptr;
    char* point = nullptr;
    char* exponent = nullptr;
    for (char* c = buffer.data(); c != end; ++c) {
      if (*c == '.') point = c;
      if (*c == 'e') {
        *c = 'E';
        exponent = c;
      }
    }
    if (point != nullptr && exponent == nullptr) {
      while (end[-1] == '0') --end;
    }
    const std::size_t start = text_.size();
    text_.append(buffer.data(), end);
    if (point == nullptr) {
      const std::size_t at =
          exponent == nullptr ? text_.size() : start + (exponent - buffer.data());
      text_.insert(at, 1, '.');
    }
    return *this;
  }
  std::ostream& out_;
  RunContext& run_;
  std::string text_;
  Id last_ = 0;
};

/// Writes the parts of the file around the geometry.
class FileSections {
 public:
  FileSections(Lines& lines, const SolidOptions& options) : lines_(lines), options_(options) {}

  void header(const std::string& fileName);
  Id point(const Eigen::Vector3d& p);
  Id direction(const Eigen::Vector3d& d);
  Id placement(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
               const Eigen::Vector3d& x);
  /// Writes the units and the accuracy of points, `exact` (mm). Returns the number of the entity.
  Id context(double exact);
  /// Writes the product. `representation`: the keyword of its shape, which consists of `items`. The
  /// items in `coloured` get the colour of the options. `contextId`: the entity from context().
  void product(const char* representation, const std::vector<Id>& items,
               const std::vector<Id>& coloured, Id contextId);
  void end();

 private:
  using Words = std::initializer_list<std::string>;
  bool is242() const { return options_.schema != StepSchema::Ap214; }
  Id plain(const char* keyword, Words arguments);
  void colour(const std::vector<Id>& items, Id contextId);

  Lines& lines_;
  const SolidOptions& options_;
};

/// Returns a quoted STEP string. Characters outside ASCII become \X2\....\X0\.
std::string stepString(const std::string& utf8);

}  // namespace swept::step
