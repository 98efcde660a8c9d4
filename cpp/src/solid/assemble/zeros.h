// Zeros of functions of time.
// Units:   time as a fraction of a motion step.
// Cost:    256 evaluations, and 60 for each zero.
// Limits:  two zeros nearer than 1/256 of the range may be missed.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "solid/carrier/bspline.h"

namespace swept::step {

constexpr int kZeroSteps = 256;

using OfTime = std::function<double(double)>;

/// Returns the zeros of a continuous function in the range, in order.
std::vector<double> zerosOf(const OfTime& f, Range range);

/// Returns the parts of the range in which low <= f <= high.
std::vector<Range> timesWithin(const OfTime& f, double low, double high, Range range);

}  // namespace swept::step
