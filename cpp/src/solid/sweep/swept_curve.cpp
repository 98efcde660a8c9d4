// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include "solid/sweep/exact_kinds.h"
#include "solid/sweep/interpolate.h"
#include "solid/sweep/regular.h"
#include "solid/sweep/swept_surface.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr int kSteps = 16;

// Returns the range with its margin. The range of a circle does not extend beyond one turn.
Range withMargin(const Curve& curve, Range range) {
  const Range grown = range.grown(kMargin);
  if (curve.kind != CurveKind::Circle || grown.length() < 2 * M_PI) return grown;
  const double spare = std::max(0.0, 2 * M_PI - range.length()) / 2;
  return {range.from - spare, range.to + spare};
}

// Returns the knots of a line or spline in the range. Beyond the ends of the curve, its first and
// last polynomials are continued. A circle has no knots.
std::optional<Knots> knotsOf(const Curve& curve, Range range) {
  if (curve.kind == CurveKind::Circle) return std::nullopt;
  std::vector<double> breaks{range.from};
  if (curve.kind == CurveKind::Line) return Knots(1, {range.from, range.to});
  const double least = 1e-6 * range.length();
  for (std::size_t i = 1; i + 1 < curve.knots.size(); ++i) {
    if (curve.knots[i] > range.from + least && curve.knots[i] < range.to - least)
      breaks.push_back(curve.knots[i]);
  }
  breaks.push_back(range.to);
  return Knots(curve.degree, std::move(breaks), curve.joints);
}

// Returns AtRest if the curve does not move, AlongItself if it moves only along itself, otherwise
// None.
Degeneracy idle(const ExactSurface& exact, Range u, Range t) {
  double movement = 0, length = 0, area = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double u0 = u.at(i / double{kSteps}), u1 = u.at((i + 1) / double{kSteps});
      const double t0 = t.at(j / double{kSteps}), t1 = t.at((j + 1) / double{kSteps});
      const Vector3d p = exact(u0, t0), along = exact(u1, t0) - p, moved = exact(u0, t1) - p;
      movement = std::max(movement, moved.norm());
      length = std::max(length, along.norm());
      // If the curve slides along itself, both chords lie along it and span no area. This fails for
      // bent curves; see turnsInItself().
      area = std::max(area, along.cross(moved).norm());
    }
  }
  if (!(movement > kNoSpeed * length)) return Degeneracy::AtRest;
  return area > kNoSpeed * movement * length ? Degeneracy::None : Degeneracy::AlongItself;
}

// Returns whether the curve is a circle that turns about its own axis. Its chords are not parallel,
// so idle() cannot detect this.
bool turnsInItself(const Curve& curve, const StepPath& path) {
  const auto axis = fixedAxis(path);
  if (curve.kind != CurveKind::Circle || !axis) return false;
  const Placement start = path.at(0);
  const Vector3d centre = start.apply(curve.start), normal = start.rotation * curve.axis;
  const Vector3d off = (centre - axis->point).cross(axis->direction);
  const Vector3d slid = path.at(1).apply(curve.start) - centre;
  return off.norm() <= kNoSpeed * curve.radius && slid.norm() <= kNoSpeed * curve.radius &&
         normal.cross(axis->direction).norm() <= kNoSpeed;
}

}  // namespace

const char* degeneracyText(Degeneracy why) {
  switch (why) {
    case Degeneracy::None:
      return "sound";
    case Degeneracy::AtRest:
      return "it does not move";
    case Degeneracy::AlongItself:
      return "it slides along itself";
    case Degeneracy::Singular:
      return "the surface has a pole, a crease or an edge of regression";
    case Degeneracy::NoContact:
      return "the face does not touch the envelope somewhere in the range";
    case Degeneracy::Fold:
      return "the contact curve turns back";
    case Degeneracy::LeavesFace:
      return "the contact leaves the face";
    case Degeneracy::TooComplex:
      return "the surface needs too many poles";
    case Degeneracy::NotKnown:
      return "no method is known for this kind of face";
  }
  return "";
}

void faceOutwards(Carrier& carrier, const Vector3d& p, const Vector3d& outward) {
  if (carrier.normal(p).dot(outward) >= 0) return;
  if (carrier.isPlanar()) {
    carrier.axis = -carrier.axis;
  } else {
    carrier.reversed = !carrier.reversed;
  }
}

SweptSurface sweptBy(const Curve& curve, Range along, const StepPath& path, Range during,
                     double bound) {
  const ExactSurface exact = [&](double u, double s) { return path.at(s).apply(curve.at(u)); };
  const Range u = withMargin(curve, along), s = during.grown(kMargin);
  SweptSurface result;
  result.where = {along.at(0.5), during.at(0.5)};
  result.why = turnsInItself(curve, path) ? Degeneracy::AlongItself : idle(exact, u, s);
  if (result.why != Degeneracy::None) return result;
  result.carrier = exactKind(exact, u, s, path, bound);
  if (result.carrier) return result;
  const auto given = knotsOf(curve, u);
  const auto fitted = fitSheet(exact, u, s, given ? &*given : nullptr, bound);
  if (!fitted) {
    result.why = Degeneracy::TooComplex;
    return result;
  }
  if (const auto singular = findSingular(*fitted->sheet, along, during)) {
    result.why = Degeneracy::Singular;
    result.where = *singular;
    return result;
  }
  Carrier carrier;
  carrier.kind = CarrierKind::Sheet;
  carrier.sheet = fitted->sheet;
  result.carrier = carrier;
  result.error = fitted->error;
  return result;
}

}  // namespace swept::step
