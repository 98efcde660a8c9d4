// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/fixed_planes.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <utility>

#include "solid/assemble/kernel_geometry.h"

namespace swept::step {

using Eigen::Vector3d;

FixedPlanes::FixedPlanes(const ElementaryBody& body, const std::vector<Pose>& poses,
                         const std::vector<BodyMotion>& motions) {
  const auto faceCount = static_cast<int>(body.faces.size());
  std::vector<char> isOfUse;
  std::vector<std::size_t> firstPose;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    std::vector<int>& planes = planeOf_.emplace_back(faceCount, -1);
    for (int f = 0; f < faceCount; ++f) {
      const BodySurface& surface = body.surfaceOf(f);
      if (!surface.isPlane) continue;
      const int plane = planes[f] =
          indexOf(poses[k].rotation * surface.axis,
                  poses[k].rotation * surface.origin + poses[k].translation);
      isOfUse.resize(planes_.size());
      firstPose.resize(planes_.size(), k);
      const bool doesSlide =
          (k > 0 && motions[k - 1].slides(f)) || (k + 1 < poses.size() && motions[k].slides(f));
      if (doesSlide || firstPose[plane] != k) isOfUse[plane] = 1;
    }
  }
  for (const BodyMotion& motion : motions) {
    std::vector<int>& planes = planeOfEdge_.emplace_back(body.edges.size(), -1);
    for (std::size_t e = 0; e < body.edges.size(); ++e) {
      const BodyEdge& edge = body.edges[e];
      if (!body.isConvex(edge) || !motion.isOutline(edge)) continue;
      const auto normal = motion.planeOf(edge);
      if (!normal) continue;
      planes[e] = indexOf(*normal, motion.at(edge.at(edge.range.from), 0));
      isOfUse.resize(planes_.size());
      isOfUse[planes[e]] = 1;
    }
  }
  std::vector<Plane> kept;
  std::vector<int> numbers(planes_.size(), -1);
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (!isOfUse[i]) continue;
    numbers[i] = static_cast<int>(kept.size());
    kept.push_back(planes_[i]);
  }
  planes_ = std::move(kept);
  for (std::vector<std::vector<int>>* indices : {&planeOf_, &planeOfEdge_}) {
    for (std::vector<int>& of : *indices) {
      for (int& plane : of) plane = plane < 0 ? -1 : numbers[plane];
    }
  }
}

int FixedPlanes::indexOf(const Vector3d& normal, const Vector3d& point) {
  constexpr double kSame = 1e-9, kSameHeight = 1e-7;  // the latter in mm
  const double height = normal.dot(point);
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const double sign = planes_[i].normal.dot(normal) < 0 ? -1 : 1;
    if ((planes_[i].normal - sign * normal).norm() < kSame &&
        std::abs(planes_[i].height - sign * height) < kSameHeight)
      return static_cast<int>(i);
  }
  planes_.push_back({normal, height, {}});
  return static_cast<int>(planes_.size()) - 1;
}

void FixedPlanes::add(int plane, const TopoDS_Edge& edge) {
  std::vector<TopoDS_Edge>& edges = planes_[plane].edges;
  const bool isKnown = std::any_of(edges.begin(), edges.end(),
                                   [&](const TopoDS_Edge& known) { return known.IsSame(edge); });
  if (!isKnown) edges.push_back(edge);
}

SweptFace FixedPlanes::candidate(std::size_t plane, double reach) const {
  // Its borders coincide with nothing else.
  constexpr double kLarger = 1.0371;
  const Plane& of = planes_[plane];
  const double size = kLarger * reach;
  const gp_Pln surface(pointOf(of.height * of.normal), dirOf(of.normal));
  return {BRepBuilderAPI_MakeFace(surface, -size, size, -size, size), SweptFace::kAlone, of.edges};
}

}  // namespace swept::step
