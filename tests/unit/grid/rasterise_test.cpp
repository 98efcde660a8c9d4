// Compares the rasteriser with a reference that really shifts the lattice, by (e, e^2, e^3). In the
// reference, every number is a polynomial in e with integer coefficients. Its sign is that of the
// coefficient of the lowest power that is not zero.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "grid/rasterise.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <tuple>

namespace swept::test {
namespace {

/// The number c[0] + c[1] e + c[2] e^2 + ..., for an infinitely small positive e.
struct Polynomial {
  std::array<__int128, 7> c{};

  Polynomial operator*(const Polynomial& o) const {
    Polynomial out;
    for (std::size_t i = 0; i < c.size(); ++i) {
      for (std::size_t j = 0; i + j < c.size(); ++j) out.c[i + j] += c[i] * o.c[j];
    }
    return out;
  }
  Polynomial operator+(const Polynomial& o) const {
    Polynomial out = *this;
    for (std::size_t i = 0; i < c.size(); ++i) out.c[i] += o.c[i];
    return out;
  }
  Polynomial operator-(const Polynomial& o) const {
    Polynomial out = *this;
    for (std::size_t i = 0; i < c.size(); ++i) out.c[i] -= o.c[i];
    return out;
  }
  int sign() const {
    for (const __int128 x : c) {
      if (x != 0) return x > 0 ? 1 : -1;
    }
    return 0;
  }
};

Polynomial number(std::int64_t x) {
  Polynomial out;
  out.c[0] = x;
  return out;
}
/// Returns the coordinate of lattice index n along an axis. The lattice is shifted by (e, e^2,
/// e^3).
Polynomial shifted(std::int32_t n, int axis) {
  Polynomial out = number(std::int64_t{n} * kSubUnits);
  out.c[static_cast<std::size_t>(axis) + 1] = 1;
  return out;
}

using Edge = std::tuple<int, std::int32_t, std::int32_t, std::int32_t>;  // axis, i, j, k
using Corners = std::array<SnappedPoint, 3>;

/// Returns twice the area of (from, to, line) as seen along the third axis.
Polynomial side(const SnappedPoint& from, const SnappedPoint& to, int u, int v,
                const std::array<Polynomial, 3>& line) {
  return number(to[u] - from[u]) * (line[v] - number(from[v])) -
         number(to[v] - from[v]) * (line[u] - number(from[u]));
}

/// Returns all lattice edges between 0 and `points` that the triangle crosses. `ties` counts how
/// often the shift decided.
std::set<Edge> oracle(const Corners& t, std::int32_t points, std::int64_t& ties) {
  std::set<Edge> found;
  for (int w = 0; w < 3; ++w) {
    const int u = w == 0 ? 1 : 0, v = w == 2 ? 1 : 2;
    for (std::int32_t n = 0; n < points; ++n) {
      for (std::int32_t m = 0; m < points; ++m) {
        std::array<Polynomial, 3> line{};
        line[u] = shifted(n, u);
        line[v] = shifted(m, v);
        std::array<Polynomial, 3> weight;
        for (int i = 0; i < 3; ++i) {
          weight[i] = side(t[(i + 1) % 3], t[(i + 2) % 3], u, v, line);
          ties += weight[i].c[0] == 0;
        }
        const int turn = weight[0].sign();
        if (turn == 0 || weight[1].sign() != turn || weight[2].sign() != turn) continue;
        const Polynomial area = weight[0] + weight[1] + weight[2];
        Polynomial height;  // times the area
        for (int i = 0; i < 3; ++i) height = height + weight[i] * number(t[i][w]);
        std::int32_t below = 0;
        for (std::int32_t k = 0; k < points; ++k) {
          const Polynomial over = height - area * shifted(k, w);
          ties += over.c[0] == 0;
          if (over.sign() * area.sign() > 0) below = k;
        }
        std::array<std::int32_t, 3> low{};
        low[u] = n;
        low[v] = m;
        low[w] = below;
        found.insert({w, low[0], low[1], low[2]});
      }
    }
  }
  return found;
}

/// Returns an odd coordinate (sub-units), near a lattice plane or anywhere between.
std::int32_t randomCoordinate(std::mt19937& random, std::int32_t points) {
  std::uniform_int_distribution<std::int32_t> plane(1, points - 2), odd(-2, 1);
  std::uniform_int_distribution<std::int32_t> anywhere(kSubUnits / 2,
                                                       (points - 1) * kSubUnits / 2 - 1);
  return random() % 2 == 0 ? plane(random) * kSubUnits + 2 * odd(random) + 1
                           : 2 * anywhere(random) + 1;
}

/// Returns the point reflected in the nearest lattice point. The edge between both points passes
/// through this lattice point.
SnappedPoint opposite(const SnappedPoint& p) {
  SnappedPoint out;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t centre = (p[axis] + kSubUnits / 2) / kSubUnits * kSubUnits;
    out[axis] = 2 * centre - p[axis];
  }
  return out;
}

TEST(Rasterise, CrossesTheEdgesOfTheShiftedLattice) {
  constexpr std::int32_t kPoints = 7;
  std::mt19937 random(20261123);
  std::int64_t ties = 0, crossings = 0;
  for (int n = 0; n < 3000; ++n) {
    Corners t;
    for (SnappedPoint& p : t) {
      for (std::int32_t& x : p) x = randomCoordinate(random, kPoints);
    }
    if (n % 2 == 0) t[1] = opposite(t[0]);  // an edge through a lattice point
    if (n % 4 == 0) t[2] = opposite(t[0]), t[2][n % 3] += 2;
    if (n % 5 == 0) t[1][n % 3] = t[0][n % 3];  // an edge along a lattice plane
    const std::set<Edge> expected = oracle(t, kPoints, ties);
    std::set<Edge> found;
    rasteriseAllAxes(t[0], t[1], t[2],
                     [&](int axis, std::int32_t i, std::int32_t j, std::int32_t k, double f) {
                       EXPECT_TRUE(found.insert({axis, i, j, k}).second) << "twice, case " << n;
                       EXPECT_GE(f, 0);
                       EXPECT_LE(f, 1);
                     });
    EXPECT_EQ(found, expected) << "case " << n;
    crossings += static_cast<std::int64_t>(expected.size());
  }
  EXPECT_GT(crossings, 3000);
  EXPECT_GT(ties, 1000) << "no line met an edge: the shift was not tested";
}

/// Whether a lattice point is inside a closed surface must not depend on the axis along which
/// crossings are counted.
TEST(Rasterise, TheThreeAxesAgreeAboutEveryPointOfAClosedSurface) {
  constexpr std::int32_t kPoints = 7;
  std::mt19937 random(5);
  std::int64_t inside = 0;
  for (int n = 0; n < 300; ++n) {
    std::array<SnappedPoint, 4> corner;
    for (SnappedPoint& p : corner) {
      for (std::int32_t& x : p) x = randomCoordinate(random, kPoints);
    }
    if (n % 2 == 0) corner[1] = opposite(corner[0]);
    std::map<Edge, int> times;
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) {
      rasteriseAllAxes(corner[a], corner[b], corner[c],
                       [&](int axis, std::int32_t i, std::int32_t j, std::int32_t k, double) {
                         ++times[{axis, i, j, k}];
                       });
    }
    for (std::int32_t i = 0; i < kPoints; ++i) {
      for (std::int32_t j = 0; j < kPoints; ++j) {
        for (std::int32_t k = 0; k < kPoints; ++k) {
          std::array<int, 3> below{};
          for (std::int32_t m = 0; m < kPoints; ++m) {
            const auto count = [&](int axis, const Edge& edge, std::int32_t end) {
              if (m < end && times.contains(edge)) below[axis] += times.at(edge);
            };
            count(0, {0, m, j, k}, i);
            count(1, {1, i, m, k}, j);
            count(2, {2, i, j, m}, k);
          }
          EXPECT_EQ(below[0] % 2, below[1] % 2) << "case " << n;
          EXPECT_EQ(below[0] % 2, below[2] % 2) << "case " << n;
          inside += below[0] % 2;
        }
      }
    }
  }
  EXPECT_GT(inside, 300);
}

}  // namespace
}  // namespace swept::test
