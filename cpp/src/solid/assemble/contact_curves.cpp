// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/contact_curves.h"

#include <algorithm>
#include <cmath>

namespace swept::step {

using Eigen::Vector3d;

ContactCurves::ContactCurves(const BodySurface& surface, const StepPath& path)
    : surface_(surface), path_(path), origin_(surface.footOfOrigin()), along_(surface.axis) {
  // The angular velocity is constant in coordinates of the body.
  across_ = surface.axis.cross(Moment(path, 0).angular);
  size_ = across_.norm();
  if (!surface.isPlane || size_ <= kNoSpeed) return;
  across_ /= size_;
  along_ = across_.cross(surface.axis);
}

Vector3d ContactCurves::at(int curve, double w, double s) const {
  const Moment moment(path_, s);
  const Vector3d centre = origin_ + w * along_;
  if (surface_.isPlane) return centre - surface_.axis.dot(moment.linear) / size_ * across_;
  const Vector3d normal = along_.cross(moment.velocityAt(centre)).normalized();
  return centre + (curve == 0 ? 1 : -1) * surface_.radius * normal;
}

int ContactCurves::curveOf(const Vector3d& p, double s) const {
  if (surface_.isPlane) return 0;
  const double w = positionAt(p);
  return (at(0, w, s) - p).squaredNorm() < (at(1, w, s) - p).squaredNorm() ? 0 : 1;
}

Range ContactCurves::extent(const ElementaryBody& body, int surface) const {
  constexpr int kPoints = 32;
  Range w{HUGE_VAL, -HUGE_VAL};
  for (const BodyFace& face : body.faces) {
    if (face.surface != surface) continue;
    for (const int e : face.edges) {
      const BodyEdge& edge = body.edges[e];
      for (int i = 0; i <= kPoints; ++i) {
        const double x = positionAt(edge.at(edge.range.at(static_cast<double>(i) / kPoints)));
        w = {std::min(w.from, x), std::max(w.to, x)};
      }
    }
  }
  return w;
}

}  // namespace swept::step
