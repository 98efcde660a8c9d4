// Number of cases that a test takes from a long series: all, or a fraction of them under
// sanitizers. Under a sanitizer a test is ten times slower, and which code runs matters more than
// how many cases. Some series are so long that they run completely only if the variable
// SWEPT_LONG_TESTS is set.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstdlib>

namespace swept::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SWEPT_UNDER_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SWEPT_UNDER_SANITIZER
#endif

#ifdef SWEPT_UNDER_SANITIZER
constexpr bool kUnderSanitizer = true;
#else
constexpr bool kUnderSanitizer = false;
#endif

/// Returns `all`; under a sanitizer, one in `oneIn` of them, but at least one.
constexpr int sampled(int all, int oneIn) {
  return kUnderSanitizer ? std::max(1, all / oneIn) : all;
}

/// Returns whether the environment variable SWEPT_LONG_TESTS is set.
inline bool longRun() { return std::getenv("SWEPT_LONG_TESTS") != nullptr; }

}  // namespace swept::test
