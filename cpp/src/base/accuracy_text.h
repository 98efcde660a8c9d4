// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace swept {

/// Returns the text of a cell size (mm) and of the accuracy whose cells have this size: "2.5 mm (an
/// accuracy of 5 mm)". Users set either of them.
std::string cellOrAccuracy(double cell);

}  // namespace swept
