// The end of error messages that asks the user to report a fault of this program.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace swept {

/// Returns the sentences that follow the description of a fault. `inputs`: what the user should
/// send, such as "the parts".
inline std::string faultText(const std::string& inputs) {
  return ". This is a fault of the program; please report it with " + inputs +
         ". See \"Report a fault\" in docs/handbook/troubleshooting.md";
}

}  // namespace swept
