// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/single_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "geometry/exact_predicates.h"

namespace swept {
namespace {

using FloatPoint = Eigen::Vector3f;

/// Hashes the bytes of the coordinates.
struct Hash {
  template <class Vector>
  std::size_t operator()(const Vector& p) const {
    return std::hash<std::string_view>{}(
        std::string_view(reinterpret_cast<const char*>(p.data()), 3 * sizeof(p[0])));
  }
};

/// Rounds to single precision. Turns -0 into 0, so that equal points have equal bytes.
FloatPoint rounded(const Eigen::Vector3d& p) { return p.cast<float>() + FloatPoint::Zero(); }

float stepped(float value, int steps) {
  const float to =
      steps > 0 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
  for (int k = 0; k < std::abs(steps); ++k) value = std::nextafter(value, to);
  return value + 0.0F;
}

/// Rounds a mesh. Works on distinct positions, so vertices with equal coordinates stay equal.
class Rounding {
 public:
  explicit Rounding(const TriMesh& mesh) : mesh_(mesh) {
    std::unordered_map<Eigen::Vector3d, std::size_t, Hash> indexOf;
    indexOf.reserve(mesh.vertices.size());
    taken_.reserve(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      const Eigen::Vector3d exact = vertex + Eigen::Vector3d::Zero();
      const auto [at, isNew] = indexOf.try_emplace(exact, exact_.size());
      positionOf_.push_back(at->second);
      if (!isNew) continue;
      exact_.push_back(exact);
      points_.push_back(rounded(exact));
      if (!taken_.insert(points_.back()).second) collided_.push_back(at->second);
    }
  }

  void keepVerticesApart() {
    for (const std::size_t position : collided_)
      move(position, [](const FloatPoint&) { return true; });
  }

  void keepAreas() {
    std::vector<std::size_t> flat;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [a, b, c] = positionsOf(t);
      if (isFlat(t) && !collinear(exact_[a], exact_[b], exact_[c])) flat.push_back(t);
    }
    if (flat.empty()) return;
    std::unordered_map<std::size_t, std::vector<std::size_t>> around;
    for (const std::size_t t : flat)
      for (const std::size_t position : positionsOf(t)) around[position];
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const std::size_t position : positionsOf(t)) {
        if (const auto at = around.find(position); at != around.end()) at->second.push_back(t);
      }
    }
    for (const std::size_t t : flat) {
      for (const std::size_t position : positionsOf(t)) {
        if (!isFlat(t)) break;
        move(position, [&](const FloatPoint& to) {
          const FloatPoint old = std::exchange(points_[position], to);
          const std::vector<std::size_t>& fan = around[position];
          const bool allHaveArea =
              std::none_of(fan.begin(), fan.end(), [&](std::size_t near) { return isFlat(near); });
          points_[position] = old;
          return allHaveArea;
        });
      }
    }
  }

  TriMesh mesh() const {
    TriMesh out;
    out.triangles = mesh_.triangles;
    out.vertices.reserve(positionOf_.size());
    for (const std::size_t position : positionOf_)
      out.vertices.emplace_back(points_[position].cast<double>());
    return out;
  }

 private:
  std::array<std::size_t, 3> positionsOf(std::size_t triangle) const {
    const auto& t = mesh_.triangles[triangle];
    return {positionOf_[t[0]], positionOf_[t[1]], positionOf_[t[2]]};
  }
  bool isFlat(std::size_t triangle) const {
    const auto [a, b, c] = positionsOf(triangle);
    return collinear(points_[a].cast<double>(), points_[b].cast<double>(),
                     points_[c].cast<double>());
  }

  /// Moves a position to the nearest free point for which suits() is true. Leaves the position
  /// unchanged if there is no such point.
  template <class Suits>
  void move(std::size_t position, const Suits& suits) {
    constexpr int kReach = 2;
    std::vector<std::pair<double, FloatPoint>> points;
    const FloatPoint centre = rounded(exact_[position]);
    for (int x = -kReach; x <= kReach; ++x) {
      for (int y = -kReach; y <= kReach; ++y) {
        for (int z = -kReach; z <= kReach; ++z) {
          const FloatPoint to(stepped(centre[0], x), stepped(centre[1], y), stepped(centre[2], z));
          points.emplace_back((to.cast<double>() - exact_[position]).squaredNorm(), to);
        }
      }
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [distance, to] : points) {
      if (taken_.count(to) != 0 || !suits(to)) continue;
      taken_.insert(points_[position] = to);
      return;
    }
  }

  const TriMesh& mesh_;
  std::vector<std::size_t> positionOf_;  // per vertex: index of its position
  std::vector<Eigen::Vector3d> exact_;   // per position: its exact coordinates
  std::vector<FloatPoint> points_;       // per position: its rounded coordinates
  std::unordered_set<FloatPoint, Hash> taken_;
  // Positions whose rounded coordinates are those of an earlier position.
  std::vector<std::size_t> collided_;
};

}  // namespace

TriMesh inSinglePrecision(const TriMesh& mesh) {
  Rounding rounding(mesh);
  rounding.keepVerticesApart();
  rounding.keepAreas();
  return rounding.mesh();
}

}  // namespace swept
