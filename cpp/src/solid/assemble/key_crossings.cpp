// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/key_crossings.h"

#include <algorithm>
#include <cmath>

#include "solid/assemble/contact_curves.h"
#include "solid/assemble/kernel_geometry.h"
#include "solid/assemble/zero_curves.h"
#include "solid/sweep/contact.h"

namespace swept::step {

using Eigen::Vector3d;

namespace {

// Returns whether a function is zero everywhere, but for rounding errors. `scale`: of its values.
bool isZero(const OfOne& f, Range range, double scale) {
  constexpr int kPoints = 8;
  constexpr double kRounding = 1e-9;
  double largest = 0;
  for (int i = 0; i <= kPoints; ++i)
    largest = std::max(largest, std::abs(f(range.at(static_cast<double>(i) / kPoints))));
  return largest <= kRounding * scale;
}

}  // namespace

void appendKeyCrossings(const BodyGeometry& body, const StepPath& before, const StepPath& after,
                        std::vector<gp_Pnt>& to) {
  const Moment end(before, 1), start(after, 0);
  const auto append = [&](const Vector3d& p) { to.push_back(pointOf(end.placement.apply(p))); };
  for (const BodyEdge& edge : body.edges) {
    const auto volume = [&](double u) {
      const Vector3d p = edge.at(u);
      return edge.tangent(u).dot(end.velocityAt(p).cross(start.velocityAt(p)));
    };
    const Vector3d p = edge.at(edge.range.from);
    const double speeds = end.velocityAt(p).norm() * start.velocityAt(p).norm();
    if (isZero(volume, edge.range, speeds)) continue;  // both steps move in a plane with the edge
    for (const double u : zerosOf(volume, edge.range)) append(edge.at(u));
  }
  for (std::size_t i = 0; i < body.surfaces.size(); ++i) {
    const BodySurface& surface = body.surfaces[i];
    const ContactCurves curves(body, static_cast<int>(i), before);
    for (int curve = 0; curve < curves.count(); ++curve) {
      if (curves.times(curve).to < 1) continue;
      const Range w = curves.extent(curve);
      const auto speed = [&](double x) {
        const Vector3d p = curves.at(curve, x, 1);
        return surface.normalAt(p).dot(start.velocityAt(p));
      };
      const double speedThere = start.velocityAt(curves.at(curve, w.from, 1)).norm();
      if (isZero(speed, w, speedThere)) continue;  // the curve is the same in both steps
      for (const double x : zerosOf(speed, w)) append(curves.at(curve, x, 1));
    }
  }
}

}  // namespace swept::step
