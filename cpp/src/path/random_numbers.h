// Random numbers for a search. A seed gives the same numbers on every machine. The distributions of
// the standard library do not guarantee this.
// Source:  uniform rotations: K. Shoemake, Uniform random rotations (Graphics Gems III, 1992).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace swept::path {

class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// Returns a number in [0, 1).
  double fraction() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * fraction(); }
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(fraction() * static_cast<double>(count));
  }
  Eigen::Vector3d inBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    const double x = fraction(), y = fraction(), z = fraction();
    return low + (high - low).cwiseProduct(Eigen::Vector3d(x, y, z));
  }
  Eigen::Vector3d direction() {
    const double z = between(-1, 1), a = between(0, 2 * std::numbers::pi);
    const double s = std::sqrt(1 - z * z);
    return {s * std::cos(a), s * std::sin(a), z};
  }
  Eigen::Quaterniond rotation() {
    const double u = fraction(), a = between(0, 2 * std::numbers::pi);
    const double b = between(0, 2 * std::numbers::pi);
    const double p = std::sqrt(1 - u), q = std::sqrt(u);
    return {q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace swept::path
