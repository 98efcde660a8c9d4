// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "clearance/pair_check.h"
#include "path/main_axes.h"

namespace swept::path {
namespace {

using clearance::MotionNode;
using clearance::PairSearch;
using Eigen::Vector3d;

// With a larger rotation between two keys, the direction of turning could become ambiguous
// (input/trajectory_check.h requires less than 179 degrees).
constexpr double kMaxTurn = 170 * std::numbers::pi / 180;
// Largest number of pairs of boxes that the first proof of a move examines. It doubles each time
// the move is halved.
constexpr std::int64_t kEffort = 300;

Vector3d rotationVector(const Eigen::Quaterniond& q) {
  const Eigen::AngleAxisd turn(q.w() < 0 ? Eigen::Quaterniond(-q.coeffs()) : q);
  return turn.axis() * turn.angle();
}

Eigen::Quaterniond turned(const Eigen::Quaterniond& q, const Vector3d& turn) {
  const double angle = turn.norm();
  if (!(angle > 0)) return q;
  return (Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * q).normalized();
}

std::vector<const TriMesh*> meshesOf(const std::vector<ClearanceNeighbour>& neighbours) {
  std::vector<const TriMesh*> meshes;
  for (const ClearanceNeighbour& n : neighbours) meshes.push_back(&n.mesh);
  return meshes;
}

}  // namespace

Scene::Scene(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours,
             const PathOptions& options, RunContext& run)
    : world_(mainAxes(meshesOf(neighbours)).transpose()),
      own_(mainAxes({&part}).transpose()),
      part_(clearance::closedPart(turnedMesh(part, own_), "the part", run, partMended_)),
      mended_(neighbours.size(), 0),
      interpolation_(options.interpolation) {
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    run.checkpoint(Phase::Motion, i, neighbours.size());
    const ClearanceNeighbour& still = neighbours[i];
    bool mended = false;
    neighbours_.push_back(clearance::closedPart(turnedMesh(still.mesh, world_),
                                                "neighbour '" + still.name + "'", run, mended));
    mended_[i] = mended ? 1 : 0;
    box_.extend(neighbours_.back().tree().bounds().low);
    box_.extend(neighbours_.back().tree().bounds().high);
  }
  partBox_ = part_.box(part_.tree().root());
  middle_ = partBox_.centre;
  for (std::uint32_t place = 0; place < part_.tree().size(); ++place)
    for (const Vector3d& x : part_.corners(place))
      radius_ = std::max(radius_, (x - middle_).norm());
  resolution_ = std::max(0.25 * options.tolerance, 2e-5 * radius_);
}

// Both coordinate systems are rotated (W: world_, P: own_): x_world = R x + t becomes
// W x_world = (W R P^T) (P x) + W t.
State Scene::inside(const Pose& pose) const {
  Pose turned = pose;
  turned.rotation =
      Eigen::Quaterniond(world_ * pose.rotation.toRotationMatrix() * own_.transpose()).normalized();
  turned.translation = world_ * pose.translation;
  return at(turned);
}

Pose Scene::outside(const State& state) const {
  Pose pose = state.pose;
  pose.rotation =
      Eigen::Quaterniond(world_.transpose() * state.pose.rotation.toRotationMatrix() * own_)
          .normalized();
  pose.translation = world_.transpose() * state.pose.translation;
  return pose;
}

State Scene::at(const Pose& pose) const {
  State state{pose, pose.rotation * middle_ + pose.translation};
  state.pose.timeSeconds = 0;
  return state;
}

State Scene::at(const Eigen::Quaterniond& rotation, const Vector3d& middle) const {
  return {{0, rotation, middle - rotation * middle_}, middle};
}

State Scene::moved(const State& from, const Twist& twist) const {
  return at(turned(from.pose.rotation, twist.turn), from.middle + twist.shift);
}

Twist Scene::between(const State& from, const State& to) {
  return {to.middle - from.middle,
          rotationVector(to.pose.rotation * from.pose.rotation.conjugate())};
}

double Scene::distance(const State& a, const State& b) const {
  const double cosine = std::min(1.0, std::abs(a.pose.rotation.dot(b.pose.rotation)));
  return (a.middle - b.middle).norm() + radius_ * 2 * std::acos(cosine);
}

State Scene::stateBetween(const State& a, const State& b, double fraction) const {
  return at(StepPath(a.pose, b.pose, interpolation_).poseAt(fraction));
}

Memory Scene::memory() const {
  Memory memory;
  memory.pairs.resize(count());
  memory.blocked.assign(count(), 0);
  return memory;
}

bool Scene::isFree(const State& state, const Rule& rule, Memory& memory) const {
  const Eigen::Matrix3d R = state.pose.rotation.toRotationMatrix();
  for (std::size_t k = 0; k < count(); ++k) {
    const std::size_t i = (memory.last + k) % count();
    if (rule[i] < 0) continue;
    ++memory.steps;
    const PairSearch pair(part_, neighbours_[i]);
    const clearance::LeafPair found =
        pair.anyNearerThan(R, state.pose.translation, rule[i], memory.pairs[i]);
    if (found.body < 0) continue;
    memory.pairs[i] = found;
    memory.last = i;
    ++memory.blocked[i];
    return false;
  }
  return true;
}

Follow Scene::follow(const State& from, const State& to, const Rule& rule, Memory& memory,
                     double finest) const {
  Follow result;
  const double turn = from.pose.rotation.angularDistance(to.pose.rotation);
  if (turn > kMaxTurn) return {0, -1};
  Trajectory step{{from.pose, to.pose}, interpolation_};
  step.poses.back().timeSeconds = 1;
  const clearance::MotionTree motion = motionTree(step);
  const std::size_t first = memory.last;
  for (std::size_t k = 0; k < count() && result.fraction > 0; ++k) {
    const std::size_t i = (first + k) % count();
    if (rule[i] >= 0) followOne(motion, i, rule[i], finest, result, memory);
  }
  if (result.neighbour >= 0) ++memory.blocked[static_cast<std::size_t>(result.neighbour)];
  return result;
}

// Finds how far one neighbour leaves the move free. Processes spans of the move, from its start. A
// span is proven free, or halved, or it ends the free part of the move.
void Scene::followOne(const clearance::MotionTree& motion, std::size_t i, double apart,
                      double finest, Follow& result, Memory& memory) const {
  struct Span {
    double from, to;
    int level;
  };
  const PairSearch pair(part_, neighbours_[i]);
  clearance::LeafPair& hint = memory.pairs[i];
  const double least = std::max(resolution_, finest * motion.bound({-1, 0, 0, 1}).reach);
  std::vector<Span> spans{{0, result.fraction, 0}};
  while (!spans.empty()) {
    const Span span = spans.back();
    spans.pop_back();
    if (span.from >= result.fraction) continue;
    const clearance::MotionBound bound = motion.bound({-1, 0, span.from, span.to});
    ++memory.steps;
    const clearance::Certificate proof =
        pair.certify(bound, apart, kEffort << std::min(span.level, 12), hint);
    if (proof.holds) continue;
    if (proof.obstacle.body >= 0) hint = proof.obstacle;
    if (bound.reach <= least) {
      result = {span.from, static_cast<int>(i)};
      memory.last = i;
      continue;
    }
    const double middle = 0.5 * (span.from + span.to);
    if (hint.body >= 0 && pair.leafDistance(bound.R, bound.t, hint).squared < apart * apart) {
      result = {middle, static_cast<int>(i)};
      memory.last = i;
    } else {
      spans.push_back({middle, span.to, span.level + 1});
    }
    spans.push_back({span.from, middle, span.level + 1});
  }
}

}  // namespace swept::path
