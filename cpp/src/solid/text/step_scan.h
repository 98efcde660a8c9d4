// Tests whether a file has the structure of a STEP file, before the kernel reads it: kernels may
// end the whole program on a damaged file.
// In: the text. Out: what is wrong and in which line; empty if nothing is. Cost: one pass.
// Tested are the frame of header and data, closed strings, comments and brackets, and the numbers
// of entities. What the entities mean is left to the kernel.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <istream>
#include <string>

namespace swept::step {

std::string stepComplaint(std::istream& text);

}  // namespace swept::step
