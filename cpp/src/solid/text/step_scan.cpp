// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/text/step_scan.h"

#include <cctype>
#include <cstdint>
#include <limits>
#include <string_view>

namespace swept::step {
namespace {

constexpr int kDeepest = 200;              // deepest nesting of parentheses
constexpr std::size_t kWordsKept = 64;     // characters of a statement that are examined
constexpr std::size_t kLongest = 1 << 26;  // longest statement, in characters

class Scanner {
 public:
  explicit Scanner(std::istream& text) : in_(*text.rdbuf()) {}

  std::string complaint() {
    while (wrong_.empty() && !ended_ && next()) {
    }
    if (!wrong_.empty()) return wrong_;
    if (!started_) return "it does not begin with ISO-10303-21";
    if (!ended_) return at("the file ends before END-ISO-10303-21");
    return sections_ < 2 ? "it has no header or no data section" : std::string();
  }

 private:
  static constexpr int kEnd = std::char_traits<char>::eof();

  std::string at(const std::string& what) const {
    return "line " + std::to_string(line_) + ": " + what;
  }

  // Processes one character or token. Returns false at the end of the file.
  bool next() {
    const int c = in_.sbumpc();
    if (c == kEnd) return false;
    if (c == '\n') ++line_;
    if (c == '\'') {
      skipString();
    } else if (c == '/' && in_.sgetc() == '*') {
      skipComment();
    } else if (c == '(') {
      if (++depth_ > kDeepest) wrong_ = at("brackets are nested too deeply");
    } else if (c == ')') {
      if (--depth_ < 0) wrong_ = at("a closing bracket has no opening bracket");
    } else if (c == '#') {
      readNumber();
    } else if (c == ';') {
      endStatement();
    } else if (c == 0) {
      wrong_ = at("a zero byte");
    } else if (std::isspace(c) == 0 && words_.size() < kWordsKept) {
      words_ += static_cast<char>(c);
    }
    if (++length_ > kLongest) wrong_ = at("a statement does not end");
    return true;
  }

  void skipString() {
    const std::int64_t from = line_;
    for (int c = in_.sbumpc(); c != '\''; c = in_.sbumpc()) {
      if (c == kEnd) {
        wrong_ = "line " + std::to_string(from) + ": the closing quote of a text is missing";
        return;
      }
      if (c == '\n') ++line_;
    }
  }

  void skipComment() {
    in_.sbumpc();
    for (int last = 0, c = in_.sbumpc(); last != '*' || c != '/'; last = c, c = in_.sbumpc()) {
      if (c == kEnd) {
        wrong_ = at("a comment does not end");
        return;
      }
      if (c == '\n') ++line_;
    }
  }

  void readNumber() {
    std::int64_t number = 0;
    bool any = false;
    for (int c = in_.sgetc(); c != kEnd && std::isdigit(c) != 0; c = in_.snextc()) {
      any = true;
      number = 10 * number + (c - '0');
      if (number > std::numeric_limits<std::int32_t>::max()) break;
    }
    if (!any) wrong_ = at("# without a number");
    if (number > std::numeric_limits<std::int32_t>::max())
      wrong_ = at("the number of an entity is too large");
    if (words_.size() < kWordsKept) words_ += '#';
  }

  void endStatement() {
    const std::string_view words = words_;
    if (depth_ != 0) {
      wrong_ = at("a bracket is not closed");
    } else if (!started_) {
      if (words != "ISO-10303-21") wrong_ = "it does not begin with ISO-10303-21";
      started_ = true;
    } else if (words == "END-ISO-10303-21") {
      ended_ = true;
    } else if (words == "HEADER" || words.starts_with("DATA")) {
      ++sections_;
    } else if (words.starts_with("#") && !words.starts_with("#=")) {
      wrong_ = at("an entity's number is not followed by =");
    }
    words_.clear();
    length_ = 0;
  }

  std::streambuf& in_;
  std::string wrong_, words_;
  std::int64_t line_ = 1;
  std::size_t length_ = 0;
  int depth_ = 0, sections_ = 0;
  bool started_ = false, ended_ = false;
};

}  // namespace

std::string stepComplaint(std::istream& text) { return Scanner(text).complaint(); }

}  // namespace swept::step
