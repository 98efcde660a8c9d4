// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/swept_elements.h"

#include <algorithm>
#include <cmath>

namespace swept {
namespace {

constexpr float kSnapCells = 0x1p-17f;
constexpr float kRounding = 1e-4f;  ///< of the displacement: float arithmetic, with room

}  // namespace

FaceDirections::FaceDirections(const SamplerInput& input) : input_(input) {
  Eigen::Vector3d low = input.body.vertices.front(), high = low;
  for (const auto& v : input.body.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  centre_ = (low + high) / 2;
  local_.resize(input.body.vertices.size());
  for (std::size_t v = 0; v < local_.size(); ++v) {
    local_[v] = (input.body.vertices[v] - centre_).cast<float>();
  }
  before_.resize(local_.size());
  after_.resize(local_.size());
  const auto cell = static_cast<float>(input.grid.cell);
  slack_.resize(input.topology.heights.size());
  for (std::size_t f = 0; f < slack_.size(); ++f) {
    // Snapping turns the normal by at most about this angle.
    slack_[f] = 4 * kSnapCells * cell / std::max(input.topology.heights[f], 1e-30f);
  }
}

void FaceDirections::compute(std::size_t step, std::vector<std::int8_t>& out) {
  const Placement& p = input_.motion.placements[step];
  const Placement& q = input_.motion.placements[step + 1];
  const Eigen::Matrix3d turn = p.rotation.transpose() * q.rotation;
  const Eigen::Matrix3f bend = (turn - Eigen::Matrix3d::Identity()).cast<float>();
  const Eigen::Matrix3f turnBack = turn.transpose().cast<float>();
  const Eigen::Vector3f shift =
      (p.rotation.transpose() * (q.apply(centre_) - p.apply(centre_))).cast<float>();
  const auto angle2 = static_cast<float>((turn - Eigen::Matrix3d::Identity()).squaredNorm() / 2);
  for (std::size_t v = 0; v < local_.size(); ++v) {
    before_[v] = bend * local_[v] + shift;
    after_[v] = turnBack * before_[v];
  }
  const float snap = 4 * kSnapCells * static_cast<float>(input_.grid.cell);
  const std::size_t faces = input_.body.triangles.size();
  out.resize(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    const auto& t = input_.body.triangles[f];
    const Eigen::Vector3f& n = input_.topology.normals[f];
    float low = n.dot(before_[t[0]]), high = low, travel2 = before_[t[0]].squaredNorm();
    for (int c = 0; c < 3; ++c) {
      const float x = n.dot(before_[t[c]]), y = n.dot(after_[t[c]]);
      low = std::min({low, x, y});
      high = std::max({high, x, y});
      travel2 = std::max(travel2, before_[t[c]].squaredNorm());
    }
    const float margin = std::sqrt(travel2) * (slack_[f] + angle2 + kRounding) + snap;
    out[f] = static_cast<std::int8_t>((low > margin) - (high < -margin));
  }
}

bool faceIsEnclosed(int directionBefore, int directionAfter, bool hasBefore, bool hasAfter,
                    bool orientable) {
  if (hasBefore && hasAfter && directionBefore != 0 && directionBefore == directionAfter)
    return true;
  return orientable && ((hasAfter && directionAfter > 0) || (hasBefore && directionBefore < 0));
}

bool patchIsEnclosed(const BodyEdge& edge, const std::vector<std::int8_t>& directions) {
  if (edge.right < 0) return false;
  const int left = directions[edge.left];
  const int right = edge.opposed ? -directions[edge.right] : directions[edge.right];
  return left != 0 && left == right;
}

}  // namespace swept
