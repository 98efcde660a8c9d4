// Random numbers and points from a seed, the same on every system.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace swept::test {

// The distributions of the standard library differ between systems. The next two functions return
// the numbers of GNU's library: a fraction from two draws, an integer from the upper half of a
// product.

/// Returns a number from low (inclusive) to high.
inline double uniform(std::mt19937& random, double low, double high) {
  constexpr double kDraws = 4294967296.0;  // number of values that the generator can draw: 2^32
  const auto first = static_cast<double>(random());
  const auto second = static_cast<double>(random());
  return (first + second * kDraws) / (kDraws * kDraws) * (high - low) + low;
}

/// Returns an integer from 0 to count - 1.
inline int uniformBelow(std::uint32_t count, std::mt19937& random) {
  // Draws below `uneven` would make some results more likely.
  const std::uint32_t uneven = -count % count;
  std::uint64_t product = 0;
  do {
    product = static_cast<std::uint64_t>(random()) * count;
  } while (static_cast<std::uint32_t>(product) < uneven);
  return static_cast<int>(product >> 32);
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * (double(engine_()) / double(std::mt19937::max()));
  }
  /// Returns a random index below `count`.
  std::size_t index(std::size_t count) {
    return uniformBelow(static_cast<std::uint32_t>(count), engine_);
  }
  /// Returns a random point with coordinates between -half and half.
  Eigen::Vector3d point(double half) {
    return {number(-half, half), number(-half, half), number(-half, half)};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace swept::test
