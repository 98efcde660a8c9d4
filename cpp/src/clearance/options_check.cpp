// SPDX-License-Identifier: LGPL-2.1-or-later
#include "clearance/options_check.h"

#include <cmath>

#include "base/limits.h"
#include "base/number_text.h"

namespace swept::clearance {

void requireLength(const std::string& name, double value, bool mayBeZero) {
  if (std::isfinite(value) && value >= 0 && value <= kMaxLength && (mayBeZero || value > 0)) return;
  throw Error(Status::InvalidInput, "BadOption",
              name + " is " + numberText(value, kTellingDigits) +
                  " mm; allowed: " + (mayBeZero ? "0" : "more than 0") + " up to 1e9 mm");
}

void checkSettings(const ClearanceOptions& o) {
  requireLength("required distance", o.required, true);
  requireLength("accuracy (tolerance)", o.tolerance, false);
  requireLength("mesh deflection (chord error) of the moving part", o.bodyChordError, true);
  if (o.intervalTolerance) requireLength("interval tolerance", *o.intervalTolerance, false);
  if (o.curveSamples < 0 || o.curveSamples > 1000000)
    throw Error(Status::InvalidInput, "BadOption",
                "number of points of the graph is " + std::to_string(o.curveSamples) +
                    "; allowed: 0 to 1000000");
}

}  // namespace swept::clearance
