// Settings that need not be given. In the program, the Python module and documents, 0 stands for
// "not given" as well.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

namespace swept {

/// Returns the value, or nothing if it is 0.
template <class T>
std::optional<T> unlessZero(const std::optional<T>& value) {
  return value && *value != 0 ? value : std::nullopt;
}

}  // namespace swept
