// Derivatives by central differences.
// Cost:    four evaluations.
// Source:  M. Abramowitz, I. Stegun, Handbook of mathematical functions (1964), section 25.3.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <type_traits>

namespace swept::step {

/// Returns the derivative of a function at 0. Its error is of fourth order in the step h.
template <class Function>
auto centralDifference(const Function& f, double h) -> std::decay_t<decltype(f(h))> {
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

}  // namespace swept::step
