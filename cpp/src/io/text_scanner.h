// Splits the text of a file into words, and keeps track of their lines and columns for messages.
// In:   the whole text, which must outlive the words. Out: words, which are views of the text; line
// numbers.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "swept/types.h"

namespace swept {

class TextScanner {
 public:
  TextScanner(std::string_view text, std::string path, std::int64_t firstLine = 1)
      : text_(text), path_(std::move(path)), line_(firstLine) {}

  /// Returns the next word of the current line; empty at the end of the line.
  std::string_view word() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r'))
      ++at_;
    wordStart_ = at_;
    while (at_ < text_.size() && !isSpace(text_[at_])) ++at_;
    return text_.substr(wordStart_, at_ - wordStart_);
  }
  /// Returns the next word of the file, on this or a later line; empty at the end of the file.
  std::string_view wordAnywhere() {
    std::string_view found = word();
    while (found.empty() && nextLine()) found = word();
    return found;
  }
  /// Moves to the start of the next line. Returns false at the end of the file.
  bool nextLine() {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) {
      at_ = text_.size();
      return false;
    }
    at_ = end + 1;
    lineStart_ = at_;
    ++line_;
    return true;
  }
  std::int64_t line() const { return line_; }

  [[noreturn]] void bad(const std::string& what) const {
    throw Error(Status::InvalidInput, "BadFile",
                "'" + path_ + "', line " + std::to_string(line_) + ", column " +
                    std::to_string(wordStart_ - lineStart_ + 1) + ": " + what);
  }
  [[noreturn]] void expected(const std::string& what, std::string_view found) const {
    bad("expected " + what + ", found " +
        (found.empty() ? std::string("nothing") : "'" + std::string(found.substr(0, 40)) + "'"));
  }

 private:
  static bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  std::string_view text_;
  std::string path_;
  std::int64_t line_ = 1;
  std::size_t at_ = 0;
  std::size_t lineStart_ = 0;
  std::size_t wordStart_ = 0;
};

}  // namespace swept
