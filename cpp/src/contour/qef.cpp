// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/qef.h"

#include <array>
#include <limits>

namespace swept {
Eigen::Vector3d Qef::solve(double margin, double damping, Eigen::Vector3d& free) const {
  const double low = margin, high = 1 - margin;
  const Eigen::Vector3d m = massPoint();
  Eigen::Matrix3d a = matrix();
  const Eigen::Vector3d g = planes_.b - a * m;
  a.diagonal().array() += damping * count_;
  // Inverse of a symmetric 3x3 matrix by cofactors. The damping limits its condition number to 1e5,
  // which leaves enough digits of a double.
  const double c00 = a(1, 1) * a(2, 2) - a(1, 2) * a(1, 2);
  const double c01 = a(0, 2) * a(1, 2) - a(0, 1) * a(2, 2);
  const double c02 = a(0, 1) * a(1, 2) - a(0, 2) * a(1, 1);
  const double det = a(0, 0) * c00 + a(0, 1) * c01 + a(0, 2) * c02;
  const double c11 = a(0, 0) * a(2, 2) - a(0, 2) * a(0, 2);
  const double c12 = a(0, 1) * a(0, 2) - a(0, 0) * a(1, 2);
  const double c22 = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
  free = m + Eigen::Vector3d(c00 * g[0] + c01 * g[1] + c02 * g[2],
                             c01 * g[0] + c11 * g[1] + c12 * g[2],
                             c02 * g[0] + c12 * g[1] + c22 * g[2]) /
                 det;
  if ((free.array() >= low).all() && (free.array() <= high).all()) return free;
  return solveInBox(a, g, low, high, free);
}

Eigen::Vector3d Qef::solveInBox(const Eigen::Matrix3d& a, const Eigen::Vector3d& g, double low,
                                double high, const Eigen::Vector3d& unbounded) const {
  // y = x - m minimises y^T a y / 2 - g . y. The state of each coordinate is 0 (free), 1 (fixed at
  // low) or 2 (fixed at high).
  const Eigen::Vector3d m = massPoint();
  // Solves for the free coordinates. Returns false if the solution lies outside the box.
  const auto solveFor = [&](const std::array<int, 3>& state, Eigen::Vector3d& y) {
    y.setZero();
    int free[3], n = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (state[axis] == 0) {
        free[n++] = axis;
      } else {
        y[axis] = (state[axis] == 1 ? low : high) - m[axis];
      }
    }
    // Fixed coordinates are in the box, so only the free ones are computed and tested.
    constexpr double kSlack = 1e-12;
    const auto isOut = [&](int axis) {
      const double x = m[axis] + y[axis];
      return x < low - kSlack || x > high + kSlack;
    };
    if (n == 1) {
      const int p = free[0], f = (p + 1) % 3, h = (p + 2) % 3;
      y[p] = (g[p] - (a(p, f) * y[f] + a(p, h) * y[h])) / a(p, p);
      if (isOut(p)) return false;
    } else if (n == 2) {
      const int p = free[0], q = free[1], f = 3 - p - q;
      const double rp = g[p] - a(p, f) * y[f], rq = g[q] - a(q, f) * y[f];
      const double det = a(p, p) * a(q, q) - a(p, q) * a(p, q);
      y[p] = (rp * a(q, q) - rq * a(p, q)) / det;
      y[q] = (rq * a(p, p) - rp * a(p, q)) / det;
      if (isOut(p) || isOut(q)) return false;
    }
    return true;
  };
  // First try: coordinates whose value in `unbounded` lies beyond a wall of the box are fixed at
  // this wall. The result is the best point if the error grows from each of these walls into the
  // box.
  Eigen::Vector3d y;
  std::array<int, 3> out;
  for (int axis = 0; axis < 3; ++axis)
    out[axis] = unbounded[axis] < low ? 1 : unbounded[axis] > high ? 2 : 0;
  if (solveFor(out, y)) {
    const Eigen::Vector3d slope = a * y - g;
    bool least = true;
    for (int axis = 0; axis < 3; ++axis) {
      if (out[axis] != 0) least &= out[axis] == 1 ? slope[axis] > 0 : slope[axis] < 0;
    }
    if (least) return m + y;
  }
  Eigen::Vector3d best = m.cwiseMax(low).cwiseMin(high);
  double bestError = std::numeric_limits<double>::max();
  for (int pattern = 1; pattern < 27; ++pattern) {
    if (!solveFor({pattern % 3, pattern / 3 % 3, pattern / 9}, y)) continue;
    const double error = y.dot(a * y) / 2 - g.dot(y);
    if (error < bestError) {
      bestError = error;
      best = m + y;
    }
  }
  return best;
}

}  // namespace swept
