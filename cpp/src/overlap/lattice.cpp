// SPDX-License-Identifier: LGPL-2.1-or-later
#include "overlap/lattice.h"

#include <Eigen/Geometry>
#include <cmath>

#include "base/parallel.h"
#include "geometry/mesh_parts.h"

namespace swept::overlap {
namespace {

constexpr int kBits = 38;
constexpr std::size_t kPointBlock = 1 << 13;

using Cross = std::array<Wide, 3>;

Whole minus(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Cross cross(const Whole& a, const Whole& b) {
  return {Wide(a[1]) * b[2] - Wide(a[2]) * b[1], Wide(a[2]) * b[0] - Wide(a[0]) * b[2],
          Wide(a[0]) * b[1] - Wide(a[1]) * b[0]};
}

Wide dot(const Cross& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

int signOf(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Returns the sign of the first term that is not 0. The terms are the effect of the shrinking,
/// then the effects of the three shifts.
int firstSign(Wide scale, const Cross& shift) {
  for (const Wide term : {scale, shift[0], shift[1], shift[2]})
    if (term != 0) return signOf(term);
  return 0;
}

}  // namespace

Lattice::Lattice(const TriMesh& shrunk, const TriMesh& fixed) {
  const Eigen::AlignedBox3d box = boxOf(shrunk);
  const Eigen::AlignedBox3d all = box.merged(boxOf(fixed));
  const Eigen::Vector3d middle = all.center();
  // A power of two, so that division by it does not round coordinates.
  step_ = std::exp2(std::ceil(std::log2(std::max(all.sizes().maxCoeff(), 1e-30))) - kBits);
  const auto whole = [&](const Eigen::Vector3d& p) {
    Whole out;
    for (int axis = 0; axis < 3; ++axis) out[axis] = std::llround((p[axis] - middle[axis]) / step_);
    return out;
  };
  centre_ = whole(box.center());
  const std::array<const TriMesh*, 2> meshes{&shrunk, &fixed};
  for (int side = 0; side < 2; ++side) {
    const std::vector<Eigen::Vector3d>& from = meshes[side]->vertices;
    points_[side].resize(from.size());
    parallelBlocks(from.size(), kPointBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) points_[side][i] = whole(from[i]);
    });
  }
}

Eigen::Vector3d Lattice::position(Side side, std::int32_t vertex) const {
  const Whole& p = at(side, vertex);
  return {double(p[0]), double(p[1]), double(p[2])};
}

Whole Lattice::fromCentre(const Whole& p) const { return minus(p, centre_); }

int Lattice::sideOf(Side side, std::int32_t vertex, const Corners& triangle) const {
  const Side otherSide = other(side);
  const Whole &p = at(side, vertex), &a = at(otherSide, triangle[0]);
  const Cross normal =
      cross(minus(at(otherSide, triangle[1]), a), minus(at(otherSide, triangle[2]), a));
  if (const int sign = signOf(dot(normal, minus(p, a))); sign != 0) return sign;
  // Seen from the shrunk mesh, a vertex of the fixed mesh moves in the opposite direction.
  const int sign = firstSign(-dot(normal, fromCentre(p)), normal);
  return side == Side::Shrunk ? sign : -sign;
}

double Lattice::heightOf(Side side, std::int32_t vertex, const Corners& triangle) const {
  const Side otherSide = other(side);
  const Whole& a = at(otherSide, triangle[0]);
  const Cross normal =
      cross(minus(at(otherSide, triangle[1]), a), minus(at(otherSide, triangle[2]), a));
  return static_cast<double>(dot(normal, minus(at(side, vertex), a)));
}

int Lattice::turnOf(std::int32_t a0, std::int32_t a1, std::int32_t b0, std::int32_t b1) const {
  const Whole &a = at(Side::Shrunk, a0), &b = at(Side::Fixed, b0), &c = at(Side::Fixed, b1);
  const Whole along = minus(at(Side::Shrunk, a1), a);
  const Wide volume = dot(cross(minus(b, a), minus(c, a)), along);
  if (volume != 0) return signOf(volume);
  const Cross normal = cross(along, minus(c, b));
  return firstSign(-dot(normal, fromCentre(a)), normal);
}

int Lattice::turnInPlane(Side side, const Whole& p, const Whole& a, const Whole& b) const {
  const auto turn = [](const Whole& u, const Whole& v) {
    return Wide(u[0]) * v[1] - Wide(u[1]) * v[0];
  };
  const Whole along = minus(b, a);
  if (const int sign = signOf(turn(minus(a, p), minus(b, p))); sign != 0) return sign;
  const int sign = firstSign(turn(fromCentre(p), along), {-along[1], along[0], 0});
  return side == Side::Shrunk ? sign : -sign;
}

int Lattice::rayThrough(Side side, std::int32_t vertex, const Corners& triangle) const {
  const Side otherSide = other(side);
  const Whole &p = at(side, vertex), &a = at(otherSide, triangle[0]),
              &b = at(otherSide, triangle[1]), &c = at(otherSide, triangle[2]);
  const Wide up = cross(minus(b, a), minus(c, a))[2];
  // The triangle is upright, so no vertical ray in general position meets it.
  if (up == 0) return 0;
  const int ccw = signOf(up);
  if (turnInPlane(side, p, a, b) != ccw || turnInPlane(side, p, b, c) != ccw ||
      turnInPlane(side, p, c, a) != ccw)
    return 0;
  return sideOf(side, vertex, triangle) == -ccw ? ccw : 0;
}

}  // namespace swept::overlap
