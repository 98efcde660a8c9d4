// The times of a motion step at which curves are regular, in ranges in which they change little:
// otherwise the surfaces that they sweep would need too many poles.
// Units:   times are fractions of the step.
// Cost:    about 300 evaluations of both functions for each range.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <vector>

#include "solid/carrier/bspline.h"

namespace swept::step {

/// Returns times within the range. `quickestChange`: returns the shortest time in which the curves
/// change much, within a range. Ranges that are much longer are halved.
std::vector<Range> regularTimes(const std::function<bool(double)>& isRegular,
                                const std::function<double(Range)>& quickestChange,
                                Range within = {0, 1});

}  // namespace swept::step
