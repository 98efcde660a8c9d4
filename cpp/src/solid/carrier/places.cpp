// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/places.h"

#include <algorithm>
#include <cmath>

#include "solid/carrier/section.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

double largestDistance(const Vector3d& p, const std::vector<const Carrier*>& surfaces) {
  double largest = 0;
  for (const Carrier* s : surfaces) largest = std::max(largest, std::abs(s->distance(p)));
  return largest;
}

// Returns a parameter at which the curve meets the surface. The search starts at t and stays within
// `reach` (mm) of the point at t.
std::optional<double> meet(const Curve& curve, const Carrier& surface, double t, double reach) {
  const bool closed = isClosed(curve);
  const auto inRange = [&](double s) {
    if (closed) return s - curve.last * std::floor(s / curve.last);
    return std::clamp(s, 0.0, curve.last);
  };
  const Vector3d start = curve.at(t);
  for (int round = 0; round < 60; ++round) {
    const Vector3d p = curve.at(t);
    if (!((p - start).norm() <= reach)) return std::nullopt;
    const double off = surface.distance(p);
    if (std::abs(off) < 1e-10) return t;
    const double rate = surface.normal(p).dot(slopeAt(curve, t));
    if (!(std::abs(rate) > 1e-12)) break;
    const double next = inRange(t - off / rate);
    if (std::abs(next - t) < 1e-15 * curve.last) break;
    t = next;
  }
  return std::abs(surface.distance(curve.at(t))) <= kOnCarrier ? std::optional<double>(t)
                                                               : std::nullopt;
}

// Returns whether the curve lies on the surface for a short distance on both sides of t.
bool runsAlong(const Curve& curve, const Carrier& surface, double t, double reach) {
  const double step = 0.5 * reach / std::max(1e-300, slopeAt(curve, t).norm());
  for (const double s : {t - step, t, t + step}) {
    const double in = isClosed(curve) ? s - curve.last * std::floor(s / curve.last)
                                      : std::clamp(s, 0.0, curve.last);
    if (std::abs(surface.distance(curve.at(in))) > kOnCarrier) return false;
  }
  return true;
}

std::optional<Vector3d> onCurve(const Curve& curve, const Vector3d& from,
                                const std::vector<const Carrier*>& surfaces, double reach) {
  double t = nearestParameter(curve, from);
  if (!((curve.at(t) - from).norm() <= reach)) return std::nullopt;
  std::size_t on = 0;
  const Carrier* other = nullptr;
  for (const Carrier* s : surfaces) {
    if (runsAlong(curve, *s, t, reach)) {
      ++on;
    } else if (other == nullptr) {
      other = s;
    }
  }
  if (on < 2) return std::nullopt;
  if (other != nullptr) {
    const auto found = meet(curve, *other, t, reach);
    if (!found) return std::nullopt;
    t = *found;
  }
  const Vector3d p = curve.at(t);
  if (!((p - from).norm() <= reach) || largestDistance(p, surfaces) > kOnCarrier)
    return std::nullopt;
  return p;
}

template <class Use>
void forTraces(const std::vector<const Carrier*>& surfaces, const Use& use) {
  for (const Carrier* s : surfaces) {
    if (s->traces != nullptr) use(*s->traces);
  }
}

}  // namespace

std::optional<Vector3d> knownPoint(const Vector3d& from,
                                   const std::vector<const Carrier*>& surfaces, double reach) {
  std::optional<Vector3d> best;
  double smallest = reach;
  const auto take = [&](const Vector3d& p) {
    const double d = (p - from).norm();
    if (!(d < smallest)) return;
    smallest = d;
    best = p;
  };
  forTraces(surfaces, [&](const Traces& traces) {
    for (const Vector3d& p : traces.points) {
      if ((p - from).norm() < smallest && largestDistance(p, surfaces) <= kOnCarrier) take(p);
    }
  });
  if (best) return best;
  forTraces(surfaces, [&](const Traces& traces) {
    for (const Curve& curve : traces.curves) {
      if (const auto p = onCurve(curve, from, surfaces, reach)) take(*p);
    }
  });
  return best;
}

std::optional<Curve> knownCurve(const std::vector<Vector3d>& along, const Carrier& a,
                                const Carrier& b, double gap, double maxDeviation) {
  std::optional<Curve> best;
  double nearest = 1e300;
  for (const Carrier* s : {&a, &b}) {
    if (s->traces == nullptr) continue;
    for (const Curve& curve : s->traces->curves) {
      const auto isOn = [&](const Vector3d& p) {
        return (curve.at(nearestParameter(curve, p)) - p).norm() <= 2 * gap;
      };
      if (!isOn(along.front()) || !isOn(along.back())) continue;
      double farthest = 0;
      for (const Vector3d& p : along)
        farthest = std::max(farthest, (curve.at(nearestParameter(curve, p)) - p).norm());
      if (!(farthest <= maxDeviation) || farthest >= nearest) continue;
      const auto piece = pieceAlong(curve, along);
      if (!piece || largestGap(*piece, a) > gap || largestGap(*piece, b) > gap) continue;
      nearest = farthest;
      best = piece;
    }
  }
  return best;
}

}  // namespace swept::step
