// Checks the structure of a STEP file before the kernel reads it. A damaged file may make a kernel
// terminate the whole program.
// In:      the text.
// Out:     the first error with its line; an empty string if there is none.
// Cost:    one pass.
// Limits:  Checks header and data sections, closed strings, comments and parentheses, and the
//          numbers of entities. The kernel checks what the entities mean.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <istream>
#include <string>

namespace swept::step {

std::string stepComplaint(std::istream& text);

}  // namespace swept::step
