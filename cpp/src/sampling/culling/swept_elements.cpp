// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/culling/swept_elements.h"

#include <algorithm>
#include <cmath>

namespace swept {

const FaceClusters& clustersOf(const SamplerInput& input, FaceClusters& own) {
  if (input.clusters != nullptr) return *input.clusters;
  own = buildClusters(input.body, input.topology);
  return own;
}

double snapAngle(double height, double cell) {
  return 4 * kSnapCells * cell / std::max(height, 1e-300);
}

FaceDirections::FaceDirections(const SamplerInput& input, const FaceClusters& clusters)
    : input_(&input),
      clusters_(&clusters),
      decidedAt_(clusters.clusters.size(), 0),
      clusterDirection_(clusters.clusters.size()),
      faceDirection_(input.body.triangles.size()) {
  for (const FaceCluster& c : clusters.clusters) {
    farthest_ = std::max(farthest_, c.centre.norm() + c.radius);
  }
}

int FaceDirections::decideCluster(const FaceCluster& cluster) const {
  const MotionStep& step = step_;
  const Eigen::Vector3d d = step.bend * cluster.centre + step.shift;
  const double length = d.norm(), spread = step.angle * cluster.radius;
  const double travel = length + spread;
  const double margin = spread +
                        travel * (step.angle * step.angle + kNormalRounding +
                                  snapAngle(cluster.minHeight, input_->grid.cell)) +
                        step.snap;
  // Finds the smallest |n . d| over the normal cone, at one end of the step. Returns 0 if this
  // value is within the margin, otherwise the sign of n . d.
  const auto side = [&](double along) {
    const double across = std::sqrt(std::max(0.0, length * length - along * along));
    const double least = std::abs(along) * cluster.cosCone - across * cluster.sinCone;
    return least > margin ? (along > 0 ? 1 : -1) : 0;
  };
  const int first = side(cluster.axis.dot(d));
  return first != 0 && first == side(cluster.axis.dot(step.turnBack * d)) ? first : 0;
}

/// Decides a face from the centre of its ball alone: n . d changes by at most angle * radius inside
/// the ball. This decides most faces.
int FaceDirections::decideBall(const FaceClusters::FaceBall& ball) const {
  const MotionStep& step = step_;
  const Eigen::Vector3f d = bendFloat_ * ball.centre + shiftFloat_;
  const float first = ball.normal.dot(d), second = ball.normal.dot(turnBackFloat_ * d);
  const auto angle = static_cast<float>(step.angle);
  const float reach = angle * ball.radius;
  const float travel = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]) + reach;
  const auto snap = static_cast<float>(snapAngle(ball.height, input_->grid.cell));
  const float margin =
      reach + travel * (angle * angle + 1e-5f + snap) + static_cast<float>(step.snap) + rounding_;
  return (std::min(first, second) > margin) - (std::max(first, second) < -margin);
}

int directionOf(const SamplerInput& input, const MotionStep& step, std::size_t face) {
  const auto& t = input.body.triangles[face];
  const Eigen::Vector3d n = input.topology.normals[face].cast<double>();
  const Eigen::Vector3d turned = step.turnBack.transpose() * n;
  double low = 1e300, high = -1e300, travel2 = 0;
  for (const std::int32_t v : t) {
    const Eigen::Vector3d d = step.bend * input.body.vertices[v] + step.shift;
    const double x = n.dot(d), y = turned.dot(d);
    low = std::min({low, x, y});
    high = std::max({high, x, y});
    travel2 = std::max(travel2, d.squaredNorm());
  }
  const double margin =
      std::sqrt(travel2) * (snapAngle(input.topology.heights[face], input.grid.cell) +
                            step.angle * step.angle + kNormalRounding) +
      step.snap;
  return (low > margin) - (high < -margin);
}

MotionStep::MotionStep(const SamplerInput& input, std::size_t k) {
  const Placement& p = input.motion.placements[k];
  const Placement& q = input.motion.placements[k + 1];
  const Eigen::Matrix3d turn = p.rotation.transpose() * q.rotation;
  bend = turn - Eigen::Matrix3d::Identity();
  turnBack = turn.transpose();
  shift = p.rotation.transpose() * (q.translation - p.translation);
  // The turn changes a unit vector by at most twice the sine of half its angle. The factor covers
  // rounding.
  angle = bend.norm() / std::sqrt(2.0) * (1 + 1e-9);
  snap = 4 * kSnapCells * input.grid.cell;
}

float displacementRounding(const MotionStep& step, double farthest) {
  return 1e-6f * static_cast<float>(step.shift.norm() + step.angle * farthest);
}

void FaceDirections::setStep(std::size_t k) {
  step_ = MotionStep(*input_, k);
  bendFloat_ = step_.bend.cast<float>();
  turnBackFloat_ = step_.turnBack.cast<float>();
  shiftFloat_ = step_.shift.cast<float>();
  rounding_ = displacementRounding(step_, farthest_);
  ++stamp_;
}

void FaceDirections::decide(std::size_t c) const {
  const FaceCluster& cluster = clusters_->clusters[c];
  const auto whole = static_cast<std::int8_t>(decideCluster(cluster));
  decidedAt_[c] = stamp_;
  clusterDirection_[c] = whole;
  std::fill_n(faceDirection_.begin() + cluster.firstFace, cluster.faceCount,
              whole != 0 ? whole : kNotDecided);
}

void FaceDirections::decideFace(std::size_t index) const {
  const int direction = decideBall(clusters_->balls[index]);
  faceDirection_[index] = static_cast<std::int8_t>(
      direction != 0 ? direction : directionOf(*input_, step_, clusters_->faces[index]));
}

bool faceIsEnclosed(int directionBefore, int directionAfter, bool hasBefore, bool hasAfter,
                    bool orientable) {
  if (hasBefore && hasAfter && directionBefore != 0 && directionBefore == directionAfter)
    return true;
  return orientable && ((hasAfter && directionAfter > 0) || (hasBefore && directionBefore < 0));
}

bool patchIsEnclosed(const BodyEdge& edge, const FaceDirections& directions) {
  if (edge.right < 0) return false;
  const int left = directions.ofFace(static_cast<std::size_t>(edge.left));
  if (left == 0) return false;
  const int right = directions.ofFace(static_cast<std::size_t>(edge.right));
  return left == (edge.opposed ? -right : right);
}

}  // namespace swept
