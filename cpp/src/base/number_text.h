// Numbers in messages, the same in every locale.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <type_traits>

namespace swept {

/// Enough digits to tell a value from the limit that it breaks.
constexpr int kTellingDigits = 12;

/// With so many significant digits at most; as %g prints it in the locale "C".
std::string numberText(double value, int digits = 6);
/// With so many digits after the point; as %.nf prints it in the locale "C".
std::string fixedText(double value, int decimals);

/// Texts and numbers one after the other; floating-point ones as numberText() has them.
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
