// The texts of a page in its languages, and the format of its numbers.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <span>
#include <string>

namespace swept::page {

struct Word {
  const char *key, *english, *german;
};
/// Returns all texts.
std::span<const Word> allWords();

class Words {
 public:
  /// Throws Error(InvalidInput, "BadOption") for an unknown language.
  explicit Words(const std::string& language);
  const std::string& language() const { return language_; }
  bool has(const std::string& key) const;
  /// Returns the text of a key, with {0} and {1} replaced. Throws std::logic_error for an unknown
  /// key, which is a fault of this program.
  std::string operator()(const std::string& key, const std::string& zero = {},
                         const std::string& one = {}) const;
  /// Formats a number with the decimal sign of the language.
  std::string number(double value, int digits = 4) const;
  std::string millimetres(double value) const { return number(value) + " mm"; }
  std::string seconds(double value) const { return number(value) + " s"; }

 private:
  std::string language_;
};

}  // namespace swept::page
