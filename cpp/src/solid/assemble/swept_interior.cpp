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

// Returns into how many pieces to divide a curve, so that the boxes of the pieces are small.
int piecesFor(const BoxTree& tree, double length) {
  const double size = (tree.bounds().high - tree.bounds().low).norm();
  return std::clamp(static_cast<int>(32 * length / size), 1, 256);
}

// Visits the items near the segment.
template <class Visit>
void forPieces(const BoxTree& tree, const Vector3d& from, const Vector3d& to, const Visit& visit) {
  const int pieces = piecesFor(tree, (to - from).norm());
  for (int i = 0; i < pieces; ++i) {
    const Vector3d a = from + (to - from) * i / pieces, b = from + (to - from) * (i + 1) / pieces;
    if (!visit(a, b)) return;
  }
}

}  // namespace

SweptInterior::SweptInterior(TriMesh body, const Trajectory& trajectory, double accuracy)
    : body_(std::move(body)), accuracy_(accuracy), pivot_(pivotOf(trajectory)) {
  tree_ = BoxTree(
      body_.triangles.size(),
      [&](std::size_t t) {
        BoxTree::Bounds box;
        for (const std::int32_t v : body_.triangles[t]) box.extend(body_.vertices[v]);
        return box;
      },
      BoxTree::Order::Medians);
  const Trajectory carried = carriedByPivot(trajectory, pivot_);
  for (std::size_t k = 0; k + 1 < carried.poses.size(); ++k)
    steps_.emplace_back(carried.poses[k], carried.poses[k + 1], carried.interpolation);
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

Vector3d SweptInterior::seen(std::size_t step, double s, const Vector3d& point) const {
  return steps_[step].at(s).applyInverse(point) + pivot_;
}

double SweptInterior::bendOf(std::size_t step, const Vector3d& from, const Vector3d& to) const {
  const StepPath& path = steps_[step];
  const double angle = path.angle();
  // Seen from the body, the point moves on a screw, or turns about the origin, which moves along a
  // line.
  if (path.isScrew()) return angle * angle * path.radius(from - pivot_);
  const double radius = std::max((from - pivot_).norm(), (to - pivot_).norm());
  return angle * angle * radius + 2 * angle * path.drift();
}

bool SweptInterior::isHit(std::size_t step, const Vector3d& point, const Piece& piece,
                          double bend) const {
  const double length = piece.to.s - piece.from.s, off = bend * length * length / 8;
  const Vector3d grown = Vector3d::Constant(off);
  if (off <= accuracy_) return isHit(piece.from.at, piece.to.at);
  bool isNear = false;
  tree_.forBox(piece.from.at.cwiseMin(piece.to.at) - grown,
               piece.from.at.cwiseMax(piece.to.at) + grown, [&](std::uint32_t) { isNear = true; });
  if (!isNear) return false;
  const double s = (piece.from.s + piece.to.s) / 2;
  const PointSeen middle{s, seen(step, s, point)};
  return isHit(step, point, {piece.from, middle}, bend) ||
         isHit(step, point, {middle, piece.to}, bend);
}

bool SweptInterior::contains(const Vector3d& point) const {
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    PointSeen from{0, seen(k, 0, point)};
    const Vector3d end = seen(k, 1, point);
    const double bend = bendOf(k, from.at, end);
    const int pieces = piecesFor(tree_, (end - from.at).norm() + bend / 2);
    for (int i = 1; i <= pieces; ++i) {
      const double s = static_cast<double>(i) / pieces;
      const PointSeen to{s, seen(k, s, point)};
      if (isHit(k, point, {from, to}, bend)) return true;
      from = to;
    }
  }
  // The point never crosses the surface of the body, so it is always inside or always outside.
  return isInsideBody(seen(0, 0, point));
}

}  // namespace swept::step
