// Numbers in messages, written the same way in every locale.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace swept {

/// Number of significant digits with which the text of a value differs from that of a close limit.
constexpr int kTellingDigits = 12;

/// Formats a number with at most `digits` significant digits, as %g does in the locale "C".
std::string numberText(double value, int digits = 6);
/// Formats a number with `decimals` digits after the point, as %.nf does in the locale "C".
std::string fixedText(double value, int decimals);

/// Returns a count with its noun: "1 edge", "2 edges". `one` and `many` may contain further words,
/// such as "edge is". Without `many`, the plural is `one` followed by an s.
std::string counted(std::int64_t count, std::string_view one, std::string_view many = {});

/// Joins texts and numbers. Floating-point numbers are formatted by numberText(number, digits).
template <class... Parts>
std::string textOf(int digits, const Parts&... parts) {
  std::string text;
  const auto add = [&](const auto& part) {
    using Part = std::decay_t<decltype(part)>;
    if constexpr (std::is_floating_point_v<Part>) {
      text += numberText(part, digits);
    } else if constexpr (std::is_integral_v<Part>) {
      text += std::to_string(part);
    } else {
      text += part;
    }
  };
  (add(parts), ...);
  return text;
}

}  // namespace swept
