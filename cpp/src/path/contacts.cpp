// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/contacts.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace swept::path {
namespace {

using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t kMaxPairs = 4000, kMaxContacts = 200;

// Returns the gradient of the contact's distance with respect to the twist. The rotation of the
// twist is scaled by the radius of the part, as in Scene::length().
Vector6d opening(const Scene& scene, const State& state, const Contact& contact) {
  Vector6d row;
  row << contact.normal, (contact.point - state.middle).cross(contact.normal) / scene.radius();
  return row;
}

Twist unscaled(const Scene& scene, const Vector6d& v) {
  return {v.head<3>(), v.tail<3>() / scene.radius()};
}

// Returns the normal of a contact. If the triangles touch, their nearest points give no direction.
// Then the normal of the neighbour's triangle is used.
Vector3d normalOf(const NearestPoints& near, const Triangle3d& still) {
  const double distance = std::sqrt(near.squared);
  if (distance > 1e-6) return (near.a - near.b) / distance;
  const Vector3d n = (still[1] - still[0]).cross(still[2] - still[0]);
  const double size = n.norm();
  return size > 0 ? Vector3d(n / size) : Vector3d::Zero();
}

// Returns 200 directions, spread evenly over the sphere.
std::vector<Vector3d> spreadDirections() {
  constexpr int kCount = 200;
  std::vector<Vector3d> list;
  for (int i = 0; i < kCount; ++i) {
    const double z = 1 - (2 * i + 1.0) / kCount;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double s = std::sqrt(1 - z * z);
    list.emplace_back(s * std::cos(angle), s * std::sin(angle), z);
  }
  return list;
}

class MoveList {
 public:
  explicit MoveList(const Scene& scene) : scene_(scene) {}
  void add(const Vector6d& v) {
    const double length = scene_.length(unscaled(scene_, v));
    if (!(length > 0)) return;
    const Vector6d unit = v / length;
    for (const Vector6d& other : seen_)
      if ((other - unit).norm() < 0.02) return;
    seen_.push_back(unit);
  }
  void addShift(const Vector3d& d) {
    Vector6d v = Vector6d::Zero();
    v.head<3>() = d;
    add(v);
  }
  std::vector<Twist> moves() const {
    std::vector<Twist> list;
    for (const Vector6d& v : seen_) list.push_back(unscaled(scene_, v));
    return list;
  }

 private:
  const Scene& scene_;
  std::vector<Vector6d> seen_;
};

}  // namespace

std::vector<Contact> contactsOf(const Scene& scene, const State& state, const Rule& within) {
  std::vector<Contact> contacts;
  const Eigen::Matrix3d R = state.pose.rotation.toRotationMatrix();
  const Vector3d t = state.pose.translation;
  for (std::size_t i = 0; i < scene.count(); ++i) {
    if (within[i] < 0) continue;
    const clearance::PairSearch pair(scene.part(), scene.neighbour(i));
    const auto pairs = pair.pairsWithin(R, t, within[i], kMaxPairs);
    const std::size_t step = pairs.size() / kMaxContacts + 1;
    for (std::size_t k = 0; k < pairs.size(); k += step) {
      const NearestPoints near = pair.leafDistance(R, t, pairs[k]);
      const Vector3d n = normalOf(near, scene.neighbour(i).corners(pairs[k].neighbour));
      if (n.squaredNorm() > 0)
        contacts.push_back({static_cast<int>(i), std::sqrt(near.squared), near.a, n});
    }
  }
  return contacts;
}

std::vector<Twist> freeMoves(const Scene& scene, const State& state,
                             const std::vector<Contact>& contacts, bool turns) {
  MoveList list(scene);
  Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
  Vector3d mean = Vector3d::Zero();
  for (const Contact& contact : contacts) {
    const Vector6d row = opening(scene, state, contact);
    gram += row * row.transpose();
    mean += contact.normal;
  }
  if (!contacts.empty()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shifts(gram.topLeftCorner<3, 3>());
    for (int k = 0; k < 3; ++k)
      for (const double sign : {1.0, -1.0}) {
        const Vector3d d = shifts.eigenvectors().col(k);
        list.addShift((mean.dot(d) < 0 ? -sign : sign) * d);
      }
    list.addShift(mean);
    // Sorts directions by their smallest component along any contact normal, largest first. If this
    // component is positive, the direction leads away from all contacts.
    std::vector<std::pair<double, Vector3d>> ranked;
    for (const Vector3d& d : spreadDirections()) {
      double least = 1;
      for (const Contact& contact : contacts) least = std::min(least, contact.normal.dot(d));
      ranked.emplace_back(-least, d);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < 4; ++k) list.addShift(ranked[k].second);
  }
  // Both directions of the main axes of the neighbours (x, y, z here), of the axes of the caller's
  // world, and of the axes of the part.
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) list.addShift(sign * Vector3d::Unit(axis));
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) list.addShift(sign * scene.world().col(axis));
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0})
      list.addShift(sign * (state.pose.rotation * Vector3d::Unit(axis)));
  if (turns && !contacts.empty()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> all(gram);
    for (int k = 0; k < 4; ++k)
      for (const double sign : {1.0, -1.0}) list.add(sign * all.eigenvectors().col(k));
  }
  return list.moves();
}

}  // namespace swept::path
