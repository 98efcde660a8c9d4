// Random numbers and points from a seed, the same on every system.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <random>

namespace swept::test {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * (double(engine_()) / double(std::mt19937::max()));
  }
  /// Returns a random point with coordinates between -half and half.
  Eigen::Vector3d point(double half) {
    return {number(-half, half), number(-half, half), number(-half, half)};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace swept::test
