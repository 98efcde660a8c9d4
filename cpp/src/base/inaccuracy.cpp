// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/inaccuracy.h"

#include <algorithm>
#include <array>

namespace swept {

bool costsAccuracy(const std::string& code) {
  constexpr std::array kCodes{"ChordCapped", "SolidSimplified", "SolidInaccurate",
                              "SelfIntersections", "SinglePrecision"};
  return std::find(kCodes.begin(), kCodes.end(), code) != kCodes.end();
}

const Finding* inaccuracyOf(const std::vector<Finding>& findings) {
  const auto found = std::find_if(findings.begin(), findings.end(),
                                  [](const Finding& f) { return costsAccuracy(f.code); });
  return found == findings.end() ? nullptr : &*found;
}

}  // namespace swept
