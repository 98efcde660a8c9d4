// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/swept_interior.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sort_unique.h"
#include "geometry/segment_triangle.h"
#include "motion/pivot.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Visits the items near the segment, in pieces so short that their boxes are small.
template <class Visit>
void forPieces(const BoxTree& tree, const Vector3d& from, const Vector3d& to, const Visit& visit) {
  const double size = (tree.bounds().high - tree.bounds().low).norm();
  const int pieces = std::clamp(static_cast<int>(32 * (to - from).norm() / size), 1, 256);
  for (int i = 0; i < pieces; ++i) {
    const Vector3d a = from + (to - from) * i / pieces, b = from + (to - from) * (i + 1) / pieces;
    if (!visit(a, b)) return;
  }
}

}  // namespace

SweptInterior::SweptInterior(TriMesh body, const Trajectory& trajectory, double accuracy)
    : body_(std::move(body)), pivot_(pivotOf(trajectory)) {
  tree_ = BoxTree(
      body_.triangles.size(),
      [&](std::size_t t) {
        BoxTree::Bounds box;
        for (const std::int32_t v : body_.triangles[t]) box.extend(body_.vertices[v]);
        return box;
      },
      BoxTree::Order::Medians);
  const Trajectory carried = carriedByPivot(trajectory, pivot_);
  const Sphere sphere = boundingSphere(body_);
  const Sphere around{sphere.centre - pivot_, sphere.radius};
  for (std::size_t k = 0; k + 1 < carried.poses.size(); ++k) {
    steps_.emplace_back(carried.poses[k], carried.poses[k + 1], carried.interpolation);
    // A point within the swept volume moves, seen from the body, on an arc of at most this radius.
    const double radius = 2 * steps_.back().radius(around) + steps_.back().drift();
    const double angle = steps_.back().angle();
    chords_.push_back(
        std::max(1, static_cast<int>(std::ceil(angle * std::sqrt(radius / (8 * accuracy))))));
  }
}

bool SweptInterior::isHit(const Vector3d& from, const Vector3d& to) const {
  bool hit = false;
  forPieces(tree_, from, to, [&](const Vector3d& a, const Vector3d& b) {
    tree_.forBox(a.cwiseMin(b), a.cwiseMax(b), [&](std::uint32_t place) {
      const auto& t = body_.triangles[tree_.item(place)];
      hit = hit ||
            throughTriangle(a, b, body_.vertices[t[0]], body_.vertices[t[1]], body_.vertices[t[2]]);
    });
    return !hit;
  });
  return hit;
}

// Counts the triangles between the point and a point outside of the body.
bool SweptInterior::isInsideBody(const Vector3d& point) const {
  const BoxTree::Bounds& box = tree_.bounds();
  if ((point.array() < box.low.array()).any() || (point.array() > box.high.array()).any())
    return false;
  // The direction is arbitrary. It is unlikely that the line meets an edge of a triangle.
  const Vector3d outside =
      point + 1.01 * (box.high - box.low).norm() * Vector3d(0.5773, 0.1234, 0.8071).normalized();
  std::vector<std::int32_t> crossed;
  forPieces(tree_, point, outside, [&](const Vector3d& a, const Vector3d& b) {
    tree_.forBox(a.cwiseMin(b), a.cwiseMax(b), [&](std::uint32_t place) {
      const std::int32_t item = tree_.item(place);
      const auto& t = body_.triangles[item];
      if (throughTriangle(point, outside, body_.vertices[t[0]], body_.vertices[t[1]],
                          body_.vertices[t[2]]))
        crossed.push_back(item);
    });
    return true;
  });
  sortUnique(crossed);
  return crossed.size() % 2 == 1;
}

bool SweptInterior::contains(const Vector3d& point) const {
  const auto seen = [&](std::size_t step, double s) -> Vector3d {
    return steps_[step].at(s).applyInverse(point) + pivot_;
  };
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    Vector3d from = seen(k, 0);
    for (int i = 1; i <= chords_[k]; ++i) {
      const Vector3d to = seen(k, static_cast<double>(i) / chords_[k]);
      if (isHit(from, to)) return true;
      from = to;
    }
  }
  // The point never crosses the surface of the body, so it is always inside or always outside.
  return isInsideBody(seen(0, 0));
}

}  // namespace swept::step
