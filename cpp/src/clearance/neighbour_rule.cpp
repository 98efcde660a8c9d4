// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/neighbour_rule.h"

#include <charconv>
#include <cmath>

#include "base/limits.h"
#include "base/number_text.h"
#include "swept/types.h"

namespace swept {
namespace {

constexpr const char* kAllowed =
    "a required distance in mm (such as 8), contact, contact:MM (the parts may overlap by at most "
    "MM mm) or ignore";
/// Largest number of neighbours that one message names.
constexpr std::size_t kMaxNames = 12;

[[noreturn]] void badRule(const std::string& text) {
  throw Error(Status::InvalidInput, "BadRule", text);
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

double lengthOf(const std::string& text, const std::string& whole) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end)
    badRule("rule " + quoted(whole) + " is not understood; write " + kAllowed);
  return value;
}

bool isPattern(const std::string& text) { return text.find_first_of("*?") != std::string::npos; }

/// Returns whether the name matches the pattern, which may contain * and ?. After a mismatch, the
/// last * absorbs one more character, and matching continues behind it.
bool matches(const std::string& pattern, const std::string& name) {
  std::size_t p = 0, n = 0, star = std::string::npos, resume = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (star != std::string::npos) {
      p = star + 1;
      n = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

bool same(const NeighbourRule& a, const NeighbourRule& b) {
  return a.required == b.required && a.contact == b.contact && a.ignored == b.ignored;
}

std::string listOf(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i)
    list += (i > 0 ? ", " : "") + quoted(names[i]);
  return list + (names.size() > kMaxNames ? ", ..." : "");
}

/// Assigns rules to names. Rules with exact names take precedence over rules with patterns.
class Assignment {
 public:
  Assignment(const std::vector<std::string>& names, const std::vector<NamedRule>& rules)
      : names_(names), rules_(rules), given_(names.size(), kNone), used_(rules.size(), 0) {}

  std::vector<NeighbourRule> operator()() {
    give([](const std::string& pattern, const std::string& name) { return pattern == name; });
    const std::vector<std::size_t> named = given_;
    given_.assign(names_.size(), kNone);
    give([](const std::string& pattern, const std::string& name) {
      return isPattern(pattern) && pattern != name && matches(pattern, name);
    });
    for (std::size_t r = 0; r < rules_.size(); ++r)
      if (used_[r] == 0)
        badRule("the rule for " + quoted(rules_[r].pattern) +
                " names no neighbour; the neighbours are: " + listOf(names_));
    std::vector<NeighbourRule> found(names_.size());
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const std::size_t r = named[i] != kNone ? named[i] : given_[i];
      if (r != kNone) found[i] = rules_[r].rule;
    }
    return found;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  template <class Fits>
  void give(const Fits& fits) {
    for (std::size_t r = 0; r < rules_.size(); ++r)
      for (std::size_t i = 0; i < names_.size(); ++i) {
        if (!fits(rules_[r].pattern, names_[i])) continue;
        used_[r] = 1;
        if (given_[i] == kNone) given_[i] = r;
        const NamedRule& other = rules_[given_[i]];
        if (!same(other.rule, rules_[r].rule))
          badRule("two rules contradict each other for neighbour " + quoted(names_[i]) + ": " +
                  quoted(other.pattern + "=" + ruleText(other.rule)) + " and " +
                  quoted(rules_[r].pattern + "=" + ruleText(rules_[r].rule)) +
                  "; remove one of them, or write the exact name in the rule that should apply");
      }
  }

  const std::vector<std::string>& names_;
  const std::vector<NamedRule>& rules_;
  std::vector<std::size_t> given_;
  std::vector<char> used_;
};

}  // namespace

std::string ruleText(const NeighbourRule& rule) {
  if (rule.ignored) return "ignore";
  if (rule.contact)
    return *rule.contact > 0 ? "contact:" + numberText(*rule.contact, kTellingDigits) : "contact";
  return rule.required ? numberText(*rule.required, kTellingDigits) : "";
}

NeighbourRule parseRule(const std::string& text) {
  const std::string word = trimmed(text);
  NeighbourRule rule;
  if (word == "ignore") {
    rule.ignored = true;
  } else if (word == "contact") {
    rule.contact = 0;
  } else if (word.starts_with("contact:")) {
    rule.contact = lengthOf(word.substr(8), text);
  } else {
    rule.required = lengthOf(word, text);
  }
  checkRule(rule, "rule " + quoted(text));
  return rule;
}

void checkRule(const NeighbourRule& rule, const std::string& who) {
  if (int(rule.required.has_value()) + int(rule.contact.has_value()) + int(rule.ignored) > 1)
    badRule(who + " contradicts itself; use only one of: a required distance, contact, ignore");
  const auto check = [&](const std::optional<double>& length, const char* what) {
    if (!length || (std::isfinite(*length) && *length >= 0 && *length <= kMaxLength)) return;
    badRule(who + ": " + what + " of " + numberText(*length, kTellingDigits) +
            " mm is not allowed; enter 0 to 1e9 mm");
  };
  check(rule.required, "a required distance");
  check(rule.contact, "a depth of contact");
}

NamedRule parseNamedRule(const std::string& text) {
  const std::size_t at = text.rfind('=');
  const std::string name = at == std::string::npos ? "" : trimmed(text.substr(0, at));
  if (name.empty())
    badRule(quoted(text) +
            " is not a rule; write NAME=RULE, for example 'bolt*=contact'. RULE is " + kAllowed);
  return {name, parseRule(text.substr(at + 1))};
}

std::vector<NeighbourRule> rulesFor(const std::vector<std::string>& names,
                                    const std::vector<NamedRule>& rules) {
  for (const NamedRule& named : rules)
    checkRule(named.rule, "the rule for " + quoted(named.pattern));
  return Assignment(names, rules)();
}

}  // namespace swept
