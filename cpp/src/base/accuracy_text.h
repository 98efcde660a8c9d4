// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace swept {

/// Names a cell size (mm) in a message, and the accuracy whose cells have this size, because users
/// give one or the other: "2.5 mm (an accuracy of 5 mm)".
std::string cellOrAccuracy(double cell);

}  // namespace swept
