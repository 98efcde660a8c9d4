// Numbers in messages, the same in every locale.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace swept {

/// Enough digits to tell a value from the limit that it breaks.
constexpr int kTellingDigits = 12;

/// With so many significant digits at most; as %g prints it in the locale "C".
std::string numberText(double value, int digits = 6);

}  // namespace swept
