// How many cases of a long series a test takes: all, or a part of them under sanitizers. Under a
// sanitizer a run is ten times slower, and the code that runs matters more than the number of
// cases. Some series are so long that only the variable SWEPT_LONG_TESTS runs them completely.
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
