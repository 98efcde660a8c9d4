// Makes numbers from the bytes of a fuzzer. Half of the numbers are small and round, and one in
// eight is a value that often breaks programs. Missing bytes count as zeros, so every input is
// valid.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace swept::fuzz {

class ByteSource {
 public:
  ByteSource(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}

  bool empty() const { return data_ == end_; }
  std::uint8_t byte() { return empty() ? 0 : *data_++; }
  /// Returns a number from 0 to n - 1.
  int below(int n) { return byte() % n; }
  bool chance(int of256) { return byte() < of256; }

  /// Returns a multiple of 1/16 from -8 to below 8. With such numbers, faces lie on grid planes and
  /// vertices coincide.
  double even() { return (byte() - 128) / 16.0; }
  /// Returns any number between -8 and 8.
  double odd() { return even() + (byte() * 256 + byte()) / 1048576.0; }
  double number() {
    const int kind = below(16);
    if (kind < 8) return even();
    if (kind < 14) return odd();
    return special();
  }
  double special() {
    constexpr double kLargest = std::numeric_limits<double>::max();
    constexpr double kValues[] = {0.0,
                                  -0.0,
                                  1e-300,
                                  std::numeric_limits<double>::denorm_min(),
                                  1e-9,
                                  1e-5,
                                  1e5,
                                  1e9,
                                  -1e9,
                                  1.0000001e9,
                                  1e150,
                                  kLargest,
                                  -kLargest,
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
    return kValues[below(16)];
  }
  Eigen::Vector3d point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  const std::uint8_t* data_;
  const std::uint8_t* end_;
};

}  // namespace swept::fuzz
