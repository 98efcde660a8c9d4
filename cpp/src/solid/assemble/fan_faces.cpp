// What contact curves sweep near a circle that touches the envelope as a whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <cmath>

#include "solid/assemble/fitted_edge.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/turning_step.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

void TurningStep::appendFan(int surface, int curve, const ContactCurves::Fan& fan) {
  const ContactCurves& curves = curves_[surface];
  Graze graze{surface, curve, curves.extent(curve), curves.times(curve), -1, fan};
  for (const Graze& other : grazes_) {
    if (other.surface == surface && other.fan && *other.fan == fan) graze.face = other.face;
  }
  if (graze.face < 0) {
    const Eigen::AlignedBox2d extent = curves.extent(fan);
    const Range u{extent.min().x(), extent.max().x()},
        v = motion_.timeOf(Range{extent.min().y(), extent.max().y()});
    const auto exact = [&](double x, double y) { return pointOn(graze, {x, y}); };
    const auto fitted = fittedGraze(exact, u, v, nullptr);
    if (!fitted) return;
    graze.face = static_cast<int>(to_.faces.size());
    SweptFace& added = to_.faces.emplace_back();
    added.face = BRepBuilderAPI_MakeFace(kernelSheet(*fitted->sheet), u.from, u.to, v.from, v.to,
                                         Precision::Confusion());
    added.conditions = conditions_.ofFan(surface, curves, fan);
    added.own = [curves, fan, length = motion_.length()](const Vector2d& on) {
      constexpr double kSlack = 0.05;  // curves near the border show where others end
      const auto touch = curves.at(fan, {on.x(), on.y() / length});
      return touch.p.allFinite() && curves.doesOwn(fan, touch, kSlack) ? 1.0 : -1.0;
    };
  }
  grazes_.push_back(graze);
}

void TurningStep::appendMoment(const Graze& before, const Graze& after) {
  if (before.surface != after.surface || !before.fan || !after.fan) return;
  const ContactCurves& curves = curves_[before.surface];
  const CriticalCircle& critical = curves.criticalOf(*before.fan);
  const double s = critical.time();
  const bool isPair = before.fan->isBeside(*after.fan) && std::abs(before.s.to - s) < kSameTime &&
                      std::abs(after.s.from - s) < kSameTime;
  if (!isPair) return;
  const Pipe& pipe = curves.pipeOf(*before.fan);
  const double x = critical.position();
  const int half = before.fan->quarter.half;
  if (half == after.fan->quarter.half) {
    const Range psi = critical.onCircle(half);
    const double scale = pipe.radius();
    const auto at = [&](double w) {
      return pipe.at(x, {std::cos(w / scale), std::sin(w / scale)});
    };
    const auto whereIs = [&](const Vector3d& p) {
      return scale * angleNear(psi.at(0.5), pipe.parametersOf(p, x).y());
    };
    appendBorder(before, after, s, {scale * psi.from, scale * psi.to}, at, whereIs);
    return;
  }
  const double scale = pipe.scale(), sign = half == 1 ? 1 : -1;
  const auto whereIs = [&](const Vector3d& p) { return scale * pipe.parametersOf(p, x).x(); };
  for (const bool isBeyond : {false, true}) {
    const Range within = critical.positions(s);
    const Range on{isBeyond ? x : within.from, isBeyond ? within.to : x};
    const auto at = [&](double w) {
      return pipe.at(w / scale, (isBeyond ? sign : -sign) * critical.directionAtMoment(w / scale));
    };
    appendBorder(before, after, s, {scale * on.from, scale * on.to}, at, whereIs);
  }
}

void TurningStep::appendBorder(const Graze& one, const Graze& other, double s, Range range,
                               const std::function<Vector3d(double)>& p,
                               const std::function<double(const Vector3d&)>& whereIs) {
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    if (body_.faces[f].surface != one.surface) continue;
    const int face = static_cast<int>(f);
    std::vector<double> cuts{range.from, range.to};
    for (const Vector3d& contact : contactsOnBorder(face, s)) {
      const double w = whereIs(contact);
      if (w > range.from && w < range.to && isAt(p(w), contact)) cuts.push_back(w);
    }
    for (const Range& w : insideOf(face, std::move(cuts), p)) {
      const TopoDS_Edge edge = fittedEdge([&](double t) { return motion_.at(p(t), s); }, w);
      const auto addTo = [&](const Graze& graze) {
        const auto on = [&](double t) { return parametersOn(graze, p(t), s); };
        return addCurveOn(to_.faces[graze.face].face, edge, on, {1, 1}, w);
      };
      if (!edge.IsNull() && addTo(one) && addTo(other))
        to_.dividers.push_back({edge, {one.face, other.face}});
    }
  }
}

}  // namespace swept::step
