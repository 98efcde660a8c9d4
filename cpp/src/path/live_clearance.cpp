// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/live_clearance.h"

#include <cmath>
#include <limits>

#include "base/number_text.h"
#include "path/scene.h"

namespace swept {
namespace {

using clearance::PairDistance;
using clearance::PairSearch;

const std::vector<ClearanceNeighbour>& atLeastOne(const std::vector<ClearanceNeighbour>& given) {
  if (given.empty())
    throw Error(Status::InvalidInput, "NoNeighbours",
                "no neighbour is given; give at least one part that stands still");
  return given;
}

}  // namespace

struct LiveClearance::Parts {
  Parts(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours, RunContext& run)
      : scene(part, atLeastOne(neighbours), PathOptions{}, run), memory(scene.memory()) {}

  path::Scene scene;
  /// Nearest pairs at the previous placement, as a first guess for the next one.
  path::Memory memory;
};

LiveClearance::LiveClearance(const TriMesh& part, const std::vector<ClearanceNeighbour>& neighbours,
                             RunContext& run)
    : parts_(std::make_unique<Parts>(part, neighbours, run)) {}

LiveClearance::~LiveClearance() = default;
LiveClearance::LiveClearance(LiveClearance&&) noexcept = default;
LiveClearance& LiveClearance::operator=(LiveClearance&&) noexcept = default;

LiveDistance LiveClearance::at(const Pose& pose) {
  const path::Scene& scene = parts_->scene;
  path::Memory& memory = parts_->memory;
  const path::State state = scene.inside(pose);
  const Eigen::Matrix3d R = state.pose.rotation.toRotationMatrix();
  const Eigen::Vector3d& t = state.pose.translation;
  LiveDistance best;
  best.distance = std::numeric_limits<double>::infinity();
  // The neighbour that was nearest at the previous placement is measured first. Most others can
  // then be discarded quickly.
  const std::size_t first = memory.last;
  for (std::size_t k = 0; k < scene.count() && best.distance > 0; ++k) {
    const std::size_t i = (first + k) % scene.count();
    const PairSearch pair(scene.part(), scene.neighbour(i));
    const PairDistance found = pair.distanceAt(R, t, best.distance, memory.pairs[i]);
    if (found.pair.body >= 0) memory.pairs[i] = found.pair;
    const bool contained = found.distance > 0 && pair.containedAt(R, t);
    if (!contained && found.pair.body < 0) continue;
    memory.last = i;
    best = LiveDistance{};
    best.neighbour = i;
    best.inside = contained;
    if (contained) continue;
    best.distance = found.distance;
    best.pointOnPart = scene.world().transpose() * found.onBody;
    best.pointOnNeighbour = scene.world().transpose() * found.onNeighbour;
  }
  return best;
}

Pose LiveClearance::reached(const Pose& from, const Pose& to, double apart) {
  if (!(apart > 0) || !std::isfinite(apart))
    throw Error(Status::InvalidInput, "BadOption",
                "the required distance is " + numberText(apart, kTellingDigits) +
                    " mm, but must be a finite number greater than 0 mm");
  const path::Scene& scene = parts_->scene;
  const path::Rule rule(scene.count(), apart);
  const path::State a = scene.inside(from), b = scene.inside(to);
  if (!scene.isFree(a, rule, parts_->memory))
    return scene.isFree(b, rule, parts_->memory) ? to : from;
  const double free = scene.follow(a, b, rule, parts_->memory).fraction;
  return free >= 1 ? to : free <= 0 ? from : scene.outside(scene.stateBetween(a, b, free));
}

}  // namespace swept
