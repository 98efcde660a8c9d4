// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/exact_predicates.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace swept {
namespace {

/// A sum of doubles whose bits do not overlap, the smallest first. The last double has the sign of
/// the sum.
template <int kCapacity>
struct Expansion {
  std::array<double, kCapacity> part;
  int size = 0;

  /// Adds one double without error.
  void add(double value) {
    int kept = 0;
    double rest = value;
    for (int i = 0; i < size; ++i) {
      const double sum = rest + part[i];
      const double virtualPart = sum - rest;
      const double error = (rest - (sum - virtualPart)) + (part[i] - virtualPart);
      rest = sum;
      if (error != 0) part[kept++] = error;
    }
    if (rest != 0) part[kept++] = rest;
    size = kept;
  }

  void addProduct(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  int sign() const { return size == 0 ? 0 : (part[size - 1] > 0 ? 1 : -1); }
};

/// Returns a - b as two doubles, the small part first.
std::array<double, 2> difference(double a, double b) {
  const double high = a - b;
  const double virtualB = a - high;
  const double low = (a - (high + virtualB)) + (virtualB - b);
  return {low, high};
}

using Exact3 = std::array<std::array<double, 2>, 3>;

Exact3 exactDifference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {difference(a.x(), b.x()), difference(a.y(), b.y()), difference(a.z(), b.z())};
}

/// Adds sign * x * y * z. The factors x, y and z are sums of two doubles each.
template <int kCapacity>
void addTriple(Expansion<kCapacity>& sum, const std::array<double, 2>& x,
               const std::array<double, 2>& y, const std::array<double, 2>& z, double sign) {
  for (const double a : x) {
    for (const double b : y) {
      const double product = a * b;
      const double error = std::fma(a, b, -product);
      for (const double c : z) {
        sum.addProduct(error, sign * c);
        sum.addProduct(product, sign * c);
      }
    }
  }
}

int exactOrientation3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d) {
  const Exact3 u = exactDifference(b, a);
  const Exact3 v = exactDifference(c, a);
  const Exact3 w = exactDifference(d, a);
  Expansion<192> sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    addTriple(sum, u[i], v[j], w[k], 1);
    addTriple(sum, u[i], v[k], w[j], -1);
  }
  return sum.sign();
}

int exactOrientation2d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       int u, int v) {
  Expansion<32> sum;
  for (const double x : difference(b[u], a[u])) {
    for (const double y : difference(c[v], a[v])) sum.addProduct(x, y);
  }
  for (const double x : difference(b[v], a[v])) {
    for (const double y : difference(c[u], a[u])) sum.addProduct(x, -y);
  }
  return sum.sign();
}

}  // namespace

int orientation3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d) {
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const Eigen::Vector3d w = d - a;
  const Eigen::Vector3d n = u.cross(v);
  const double value = n.dot(w);
  // Sum of the absolute values of the six products. The bound covers 16 roundings of 2^-53 each.
  const Eigen::Vector3d p = u.cwiseAbs();
  const Eigen::Vector3d q = v.cwiseAbs();
  const Eigen::Vector3d r = w.cwiseAbs();
  const double size = (p.y() * q.z() + p.z() * q.y()) * r.x() +
                      (p.z() * q.x() + p.x() * q.z()) * r.y() +
                      (p.x() * q.y() + p.y() * q.x()) * r.z();
  const double bound = 1.8e-15 * size;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return exactOrientation3d(a, b, c, d);
}

int orientation2d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  int u, int v) {
  const double left = (b[u] - a[u]) * (c[v] - a[v]);
  const double right = (b[v] - a[v]) * (c[u] - a[u]);
  const double value = left - right;
  const double bound = 6e-16 * (std::abs(left) + std::abs(right));
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return exactOrientation2d(a, b, c, u, v);
}

bool collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return orientation2d(a, b, c, 0, 1) == 0 && orientation2d(a, b, c, 1, 2) == 0 &&
         orientation2d(a, b, c, 2, 0) == 0;
}

}  // namespace swept
