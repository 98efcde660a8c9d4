// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "swept/types.h"

namespace swept::cli {
namespace {

[[noreturn]] void badOption(const std::string& text) {
  throw Error(Status::InvalidInput, "BadOption", text + "; see swept --help");
}

template <class T>
bool parseWhole(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

double numberOf(const std::string& name, const std::string& text) {
  double number = 0;
  if (!parseWhole(text, number) || !std::isfinite(number)) {
    badOption(name + " is '" + text + "'; expected a number such as 0.25");
  }
  return number;
}

}  // namespace

void Arguments::with(const std::string& name, std::function<void(const std::string&)> take) {
  options_.push_back({name, true, std::move(take)});
}

void Arguments::text(const std::string& name, std::string& target) {
  with(name, [name, &target](const std::string& value) {
    if (value.empty()) badOption(name + " needs a value that is not empty");
    target = value;
  });
}

void Arguments::number(const std::string& name, double& target) {
  with(name, [name, &target](const std::string& value) { target = numberOf(name, value); });
}

void Arguments::number(const std::string& name, std::optional<double>& target) {
  with(name, [name, &target](const std::string& value) { target = numberOf(name, value); });
}

void Arguments::integer(const std::string& name, std::int64_t& target, std::int64_t least,
                        std::int64_t most) {
  with(name, [name, &target, least, most](const std::string& value) {
    if (!parseWhole(value, target) || target < least || target > most) {
      badOption(name + " is '" + value + "'; expected a whole number from " +
                std::to_string(least) + " to " + std::to_string(most));
    }
  });
}

void Arguments::flag(const std::string& name, bool& target, bool value) {
  options_.push_back({name, false, [&target, value](const std::string&) { target = value; }});
}

std::vector<std::string> Arguments::parse(const std::vector<std::string>& words) const {
  std::vector<std::string> positional;
  given_.clear();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.size() < 2 || word[0] != '-') {
      positional.push_back(word);
      continue;
    }
    if (word == "--") {
      positional.insert(positional.end(), words.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                        words.end());
      break;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto option = std::find_if(options_.begin(), options_.end(),
                                     [&](const Option& o) { return o.name == name; });
    if (option == options_.end()) badOption("unknown option '" + name + "'");
    if (!option->takesValue && equals != std::string::npos) badOption(name + " takes no value");
    if (wasGiven(name)) badOption(name + " is given twice");
    given_.push_back(name);
    if (!option->takesValue) {
      option->take({});
    } else if (equals != std::string::npos) {
      option->take(word.substr(equals + 1));
    } else if (i + 1 < words.size()) {
      option->take(words[++i]);
    } else {
      badOption(name + " needs a value");
    }
  }
  return positional;
}

bool Arguments::wasGiven(const std::string& name) const {
  return std::find(given_.begin(), given_.end(), name) != given_.end();
}

}  // namespace swept::cli
