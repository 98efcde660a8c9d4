// The edges of regression of grazing surfaces (also called cuspidal edges): there a surface is
// tangent to itself, as the contact curve has the velocity of the body.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include "base/parallel.h"
#include "solid/assemble/fitted_edge.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/turning_step.h"
#include "solid/sweep/central_difference.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

Eigen::AlignedBox2d TurningStep::domainOf(const Graze& graze) const {
  if (graze.fan) return curves_[graze.surface].extent(*graze.fan);
  return {Vector2d(graze.w.from, graze.s.from), Vector2d(graze.w.to, graze.s.to)};
}

OfTwo TurningStep::areaOf(const Graze& graze) const {
  constexpr double kStep = 1e-3;
  const Vector2d sizes = domainOf(graze).sizes();
  const double stepW = kStep * sizes.x(), stepS = graze.fan ? kStep * sizes.y() : kStep;
  return [this, graze, stepW, stepS](const Vector2d& on) {
    const auto slope = [&](const Vector2d& step) {
      return centralDifference(
          [&](double steps) { return pointOn(graze, onSheet(on + steps * step)); }, 1);
    };
    const auto touch = touchOf(graze, onSheet(on));
    const Vector3d normal =
        path_.at(touch.s).rotation * body_.surfaces[graze.surface].normalAt(touch.p);
    return slope({stepW, 0}).cross(slope({0, stepS})).dot(normal) /
           (stepW * stepS * motion_.length());
  };
}

void TurningStep::appendRegressions() {
  std::vector<Regression> found(grazes_.size());
  parallelBlocks(grazes_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = regressionOf(grazes_[i]);
  });
  for (const Regression& of : found) {
    to_.folds.insert(to_.folds.end(), of.folds.begin(), of.folds.end());
    to_.crossings.insert(to_.crossings.end(), of.crossings.begin(), of.crossings.end());
  }
}

TurningStep::Regression TurningStep::regressionOf(const Graze& graze) const {
  const bool isKnown = std::any_of(grazes_.data(), &graze,
                                   [&](const Graze& other) { return other.face == graze.face; });
  if (isKnown) return {};
  const OfTwo area = areaOf(graze);
  Regression regression;
  const Eigen::AlignedBox2d domain = domainOf(graze);
  for (const ZeroArc& arc : zeroArcs(area, {domain.min().x(), domain.max().x()},
                                     {domain.min().y(), domain.max().y()}, {1, motion_.length()})) {
    const TopoDS_Edge edge =
        fittedEdge([&](double t) { return pointOn(graze, onSheet(arc.at(t))); }, arc.range());
    const auto on = [&](double t) { return onSheet(arc.at(t)); };
    if (!edge.IsNull() && addCurveOn(to_.faces[graze.face].face, edge, on, {1, 1}, arc.range()))
      regression.folds.push_back({edge, {graze.face}});
  }
  if (!regression.folds.empty()) regression.crossings = crossingsOf(graze, area);
  return regression;
}

std::vector<gp_Pnt> TurningStep::crossingsOf(const Graze& graze, const OfTwo& area) const {
  std::vector<gp_Pnt> crossings;
  for (const Contact& contact : contacts_) {
    const Graze* own = grazeOf(contact);
    if (own == nullptr || own->face != graze.face) continue;
    const BodyEdge& edge = body_.edges[contact.edge];
    const auto onSurface = [&](double t) {
      const Vector2d at = contact.arc.at(t);
      const Vector2d there = parametersOn(graze, edge.at(at.x()), at.y());
      return Vector2d(there.x(), there.y() / motion_.length());
    };
    for (const double t : zerosOf([&](double x) { return area(onSurface(x)); }, contact.along)) {
      const Vector2d on = contact.arc.at(t);
      crossings.push_back(pointOf(motion_.at(edge.at(on.x()), on.y())));
    }
  }
  return crossings;
}

}  // namespace swept::step
