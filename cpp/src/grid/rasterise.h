// Finds the exact crossings of one triangle with the lattice lines of one axis.
//
// In: snapped corners of a triangle. Out: lattice edges and fractions. Units: 2^-17 cell. Cost:
// O(lattice lines that the triangle's projection covers).
// Promise: the crossings of a closed surface are consistent: the three axes agree on which side of
// the surface every lattice point lies.
// Source: simulation of simplicity (Edelsbrunner and Muecke 1990).
//
// Vertices are odd integers in units of 2^-17 cell, and lattice lines lie at multiples of 2^17. So
// a vertex never has a coordinate in common with a lattice line. A line may still meet an edge
// exactly, or a lattice point may lie exactly on a plane. Then the lattice is treated as shifted by
// (e, e^2, e^3), where e tends to 0. The shift is the same for all axes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "grid/snap.h"

namespace swept {

namespace detail {

/// Breaks the tie for a line that lies exactly on an edge with the direction (du, dv) of a
/// counter-clockwise triangle. Returns whether the line lies on the inner side of the edge once the
/// line is shifted a little along u, and far less along v (see the top of this file).
inline bool tieIsInside(std::int64_t du, std::int64_t dv) { return dv < 0 || (dv == 0 && du > 0); }

/// Decides exactly whether a crossing lies above the shifted lattice point k of its line. `e`:
/// barycentric coordinates of the line in the triangle, times area2. `w`: coordinates of the
/// corners along the line. Used for crossings so near to the lattice point that a rounded position
/// cannot decide.
template <int W>
bool crossingIsAbove(const std::array<std::int64_t, 3>& e, const std::array<std::int64_t, 3>& w,
                     std::int64_t area2, std::int64_t k, const SnappedPoint& a,
                     const SnappedPoint& b, const SnappedPoint& c) {
  const __int128 numerator = static_cast<__int128>(e[0]) * w[0] +
                             static_cast<__int128>(e[1]) * w[1] +
                             static_cast<__int128>(e[2]) * w[2];
  const __int128 point = static_cast<__int128>(area2) * (k * static_cast<std::int64_t>(kSubUnits));
  if (numerator != point) return numerator > point;
  // The lattice point lies on the plane of the triangle. Decide as if it moved slightly along the
  // first axis with a non-zero component of the normal. Along an axis other than W, the height of
  // the plane then changes by -n_axis / n_W. Along W, the lattice point itself moves up, above the
  // crossing.
  const auto component = [&](int axis) {
    const int p = (axis + 1) % 3, q = (axis + 2) % 3;
    const std::int64_t bp = b[p] - a[p], bq = b[q] - a[q], cp = c[p] - a[p], cq = c[q] - a[q];
    return bp * cq - bq * cp;
  };
  const std::int64_t nW = component(W);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == W) return false;  // the shifted point is above the crossing
    const std::int64_t n = component(axis);
    if (n != 0) return (n > 0) != (nW > 0);  // the height of the plane changes by -n / nW
  }
  return false;
}

}  // namespace detail

/// Calls emit(u, v, k, fraction) for each lattice line (u, v) along axis W that meets the triangle
/// between lattice points k and k + 1. u and v are indices along the other two axes, in ascending
/// order of the axes.
template <int W, class Emit>
inline void rasteriseTriangle(const SnappedPoint& a, const SnappedPoint& b0, const SnappedPoint& c0,
                              const Emit& emit) {
  constexpr int U = W == 0 ? 1 : 0, V = W == 2 ? 1 : 2;
  const std::int32_t u0 = (std::min({a[U], b0[U], c0[U]}) + kSubUnits - 1) >> kSubBits;
  const std::int32_t u1 = std::max({a[U], b0[U], c0[U]}) >> kSubBits;
  if (u0 > u1) return;
  const std::int32_t v0 = (std::min({a[V], b0[V], c0[V]}) + kSubUnits - 1) >> kSubBits;
  const std::int32_t v1 = std::max({a[V], b0[V], c0[V]}) >> kSubBits;
  if (v0 > v1) return;

  std::int64_t area2 = static_cast<std::int64_t>(b0[U] - a[U]) * (c0[V] - a[V]) -
                       static_cast<std::int64_t>(b0[V] - a[V]) * (c0[U] - a[U]);
  if (area2 == 0) return;
  const bool swap = area2 < 0;
  const SnappedPoint& b = swap ? c0 : b0;
  const SnappedPoint& c = swap ? b0 : c0;
  if (swap) area2 = -area2;

  // Edge i is opposite vertex i.
  const SnappedPoint* from[3] = {&b, &c, &a};
  const SnappedPoint* to[3] = {&c, &a, &b};
  std::int64_t du[3], dv[3], row[3];
  bool tie[3];
  for (int i = 0; i < 3; ++i) {
    du[i] = (*to[i])[U] - (*from[i])[U];
    dv[i] = (*to[i])[V] - (*from[i])[V];
    tie[i] = detail::tieIsInside(du[i], dv[i]);
    row[i] = du[i] * ((static_cast<std::int64_t>(v0) << kSubBits) - (*from[i])[V]) -
             dv[i] * ((static_cast<std::int64_t>(u0) << kSubBits) - (*from[i])[U]);
  }
  const std::array<std::int64_t, 3> w{a[W], b[W], c[W]};
  const double scale = 1.0 / (static_cast<double>(area2) * kSubUnits);
  const auto wa = static_cast<double>(w[0]), wb = static_cast<double>(w[1]),
             wc = static_cast<double>(w[2]);
  const bool wide = u1 - u0 > 8;
  double perRow[3] = {0, 0, 0};
  for (int i = 0; wide && i < 3; ++i) {
    if (dv[i] != 0) perRow[i] = 1.0 / (static_cast<double>(dv[i]) * kSubUnits);
  }

  for (std::int32_t v = v0; v <= v1; ++v) {
    std::int32_t first = u0, last = u1;
    if (wide) {  // each edge narrows first..last, with a margin of one line
      for (int i = 0; i < 3; ++i) {
        if (dv[i] == 0) continue;
        const double at = static_cast<double>(row[i]) * perRow[i];
        if (dv[i] > 0) {
          last = std::min(last, static_cast<std::int32_t>(std::min(at + u0 + 1, 1e6)));
        } else {
          first = std::max(first, static_cast<std::int32_t>(std::max(at + u0 - 1, -1e6)));
        }
      }
    }
    const std::int64_t ahead = static_cast<std::int64_t>(first - u0) << kSubBits;
    std::array<std::int64_t, 3> e{row[0] - dv[0] * ahead, row[1] - dv[1] * ahead,
                                  row[2] - dv[2] * ahead};
    for (std::int32_t u = first; u <= last; ++u) {
      const bool inside = (e[0] > 0 || (e[0] == 0 && tie[0])) &&
                          (e[1] > 0 || (e[1] == 0 && tie[1])) &&
                          (e[2] > 0 || (e[2] == 0 && tie[2]));
      if (inside) {
        const double g = (static_cast<double>(e[0]) * wa + static_cast<double>(e[1]) * wb +
                          static_cast<double>(e[2]) * wc) *
                         scale;
        auto k = static_cast<std::int32_t>(g);
        double fraction = g - k;
        constexpr double kNear = 1e-6;  // cells, far above the rounding of g (4e-12)
        if (fraction < kNear) {
          if (!detail::crossingIsAbove<W>(e, w, area2, k, a, b, c)) {
            --k;
            fraction = 1;
          }
        } else if (fraction > 1 - kNear) {
          if (detail::crossingIsAbove<W>(e, w, area2, k + 1, a, b, c)) {
            ++k;
            fraction = 0;
          }
        }
        emit(u, v, k, fraction);
      }
      for (int i = 0; i < 3; ++i) e[i] -= dv[i] << kSubBits;
    }
    for (int i = 0; i < 3; ++i) row[i] += du[i] << kSubBits;
  }
}

/// Calls emit(axis, i, j, k, fraction) for each lattice edge that the triangle crosses. The edge
/// leads from lattice point (i, j, k) along the axis.
template <class Emit>
inline void rasteriseAllAxes(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c,
                             const Emit& emit) {
  using Index = std::int32_t;
  rasteriseTriangle<0>(a, b, c, [&](Index j, Index k, Index i, double f) { emit(0, i, j, k, f); });
  rasteriseTriangle<1>(a, b, c, [&](Index i, Index k, Index j, double f) { emit(1, i, j, k, f); });
  rasteriseTriangle<2>(a, b, c, [&](Index i, Index j, Index k, double f) { emit(2, i, j, k, f); });
}

}  // namespace swept
