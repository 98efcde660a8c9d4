// Wall-clock time for the stages of a run, and processor time for trial runs.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>

namespace swept {

class Timer {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// Returns the seconds since construction or the last call of lap().
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double s = std::chrono::duration<double>(now - lap_).count();
    lap_ = now;
    return s;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), lap_ = start_;
};

/// Returns the processor time of the calling thread, in seconds. Defined in base/system.cpp and
/// base/system_windows.cpp.
double threadSeconds();

}  // namespace swept
