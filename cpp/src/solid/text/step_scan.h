// Does a file have the structure of a STEP file? Asked before a kernel reads one from elsewhere,
// as kernels may end the whole program over a damaged one.
// In: the text. Out: what is wrong and in which line, empty if nothing: the frame of header and
// data, closed strings, comments and brackets, numbers of entities. What entities mean is left to
// the kernel. Cost: one pass.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <istream>
#include <string>

namespace swept::step {

std::string stepComplaint(std::istream& text);

}  // namespace swept::step
