// Options of one command: a table of names and destinations, then one pass over the words.
// In:   argv behind the command. Out: the destinations filled, positional words in order.
// Throws Error(InvalidInput, "BadOption") naming the option, the value and what is allowed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace swept::cli {

class Arguments {
 public:
  /// `--name VALUE` and `--name=VALUE`.
  void text(const std::string& name, std::string& target);
  void number(const std::string& name, double& target);
  void number(const std::string& name, std::optional<double>& target);
  void integer(const std::string& name, std::int64_t& target, std::int64_t least,
               std::int64_t most);
  void flag(const std::string& name, bool& target, bool value = true);
  /// Any other conversion; what it throws is passed on.
  void with(const std::string& name, std::function<void(const std::string&)> take);

  std::vector<std::string> parse(const std::vector<std::string>& words) const;
  bool wasGiven(const std::string& name) const;

 private:
  struct Option {
    std::string name;
    bool takesValue;
    std::function<void(const std::string&)> take;
  };
  std::vector<Option> options_;
  mutable std::vector<std::string> given_;
};

}  // namespace swept::cli
