// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplify.h"

#include <algorithm>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "geometry/self_intersections.h"
#include "simplify/collapse.h"
#include "simplify/collapse_log.h"
#include "simplify/deviation.h"
#include "simplify/feature_edges.h"
#include "simplify/simplified_sources.h"
#include "simplify/thin.h"

namespace swept {
namespace {

using Eigen::Vector3d;

/// Fraction of the tolerance that thinning may use; edge collapses use the rest.
constexpr double kThinFraction = 0.3;
constexpr double kFirstLevel = 0.025;  ///< limit of the first level, in cells
/// Fraction of the remaining tolerance for the collapses. They test points only, and the surface
/// between the points may deviate more.
constexpr double kPointFraction = 0.97;
constexpr double kLessEachRound = 0.9;  ///< factor of the tolerance after a round that failed
/// Rounds of improvement. With 4, four points still deviated too much in the trial that chose
/// kWatchFolds (collapse.cpp), and all steps were repeated; with 8, the fifth round was enough.
constexpr int kRounds = 8;
/// Steps undone at each triangle that deviates too far, in the first round; doubled in each further
/// round.
constexpr int kFirstDepth = 2;
constexpr int kThinTrials = 4;  ///< attempts of thinning, each with more vertices kept
/// The tolerance is reduced until a trial succeeds, but not below this fraction. If no trial
/// succeeds, nothing is simplified.
constexpr double kMinFraction = 0.1;

// Attaches each missed point of the original to the nearest changed triangle, so that further
// collapses stay near the point.
void attachMissed(CollapseState& state, const std::vector<std::int32_t>& changed,
                  const std::vector<FarPoint>& missed) {
  for (const FarPoint& place : missed) {
    double best = 1e300;
    std::int32_t nearestTriangle = -1;
    for (const std::int32_t t : changed) {
      if (state.dead[t]) continue;
      const double d = squaredDistance(place.onOriginal, state.mesh, t);
      if (d >= best) continue;
      best = d;
      nearestTriangle = t;
    }
    if (nearestTriangle >= 0) state.attached[nearestTriangle].push_back(place.onOriginal);
  }
}

// Restored triangles may intersect triangles that later steps have moved. Undoes steps there until
// no more than `pairs` pairs of triangles intersect. Adds the changed triangles to `changed`.
void undoIntersecting(CollapseState& state, CollapseLog& log, std::int64_t pairs,
                      std::vector<std::int32_t>& changed, RunContext& run) {
  constexpr int kAllSteps = 1 << 20;
  for (int depth = 1;; depth = std::min(2 * depth, kAllSteps)) {
    std::vector<std::int32_t> number;
    const SelfIntersections found = findSelfIntersections(takeMesh(state, &number), {}, run);
    if (found.count <= pairs) return;
    std::vector<std::int32_t> wrong;
    for (const auto& [a, b] : found.pairs) wrong.insert(wrong.end(), {number[a], number[b]});
    const std::vector<std::int32_t> more = log.takeBack(state, wrong, depth);
    if (more.empty()) return;
    changed.insert(changed.end(), more.begin(), more.end());
  }
}

// Undoes steps at triangles that deviate too far, and collapses again with denser sample points.
// `pairs`: number of pairs of triangles that intersected before. Returns false if no step can be
// undone.
bool improve(CollapseState& state, CollapseLog& log, const std::vector<std::int32_t>& wrong,
             const std::vector<FarPoint>& missed, int depth, std::int64_t pairs, RunContext& run) {
  std::vector<std::int32_t> changed = log.takeBack(state, wrong, depth);
  if (changed.empty()) return false;
  undoIntersecting(state, log, pairs, changed, run);
  sortUnique(changed);
  attachMissed(state, changed, missed);
  for (const std::int32_t t : changed) {
    for (const std::int32_t v : state.mesh.triangles[t]) state.care[v] = Care::Deviated;
  }
  collapseAgain(state, changed, run, log);
  return true;
}

}  // namespace

Simplifier::Simplifier(TriMesh mesh, std::vector<double> contactTime, double cell, Sources sources)
    : mesh_(std::move(mesh)),
      contactTime_(std::move(contactTime)),
      cell_(cell),
      sources_(std::move(sources)) {}

std::unique_ptr<Simplifier::Level> Simplifier::thinned(const Level* from, double limit,
                                                       RunContext& run,
                                                       std::vector<char> kept) const {
  Thinned thin = thinOut(from != nullptr ? from->mesh : mesh_, limit, ThinFor::Collapse,
                         Phase::Simplify, run, std::move(kept));
  auto level = std::make_unique<Level>();
  level->mesh = std::move(thin.mesh);
  level->source = std::move(thin.source);
  level->limit = limit + (from != nullptr ? from->limit : 0);
  if (from != nullptr) {
    for (std::int32_t& v : level->source) v = from->source[v];
  }
  level->nearest = std::make_unique<NearestTriangle>(level->mesh.vertices, level->mesh.triangles,
                                                     NearestTriangle::Walks::Yes);
  return level;
}

const Simplifier::Level* Simplifier::levelWithin(double limit, RunContext& run) const {
  const std::lock_guard lock(mutex_);
  const Level* found = nullptr;
  double step = kFirstLevel * cell_;
  for (std::size_t n = 0;; ++n, step *= 2) {
    if (step + (found != nullptr ? found->limit : 0) > limit) return found;
    // Thinning such a small mesh further saves nothing.
    if (found != nullptr && n > 0 && found->mesh.triangles.size() < 1000) return found;
    if (n == levels_.size()) levels_.push_back(thinned(found, step, run));
    found = levels_[n].get();
  }
}

const NearestTriangle& Simplifier::nearest() const {
  const std::lock_guard lock(mutex_);
  if (nearest_ == nullptr)
    nearest_ = std::make_unique<NearestTriangle>(mesh_.vertices, mesh_.triangles,
                                                 NearestTriangle::Walks::Yes);
  return *nearest_;
}

Simplified Simplifier::simplifyTo(double tolerance, RunContext& run) const {
  run.checkpoint(Phase::Simplify);
  // If no trial keeps within the tolerance, tries again with half of it.
  for (double within = tolerance; within > kMinFraction * tolerance; within /= 2) {
    const double limit = kThinFraction * within;
    const Level* level = levelWithin(limit, run);
    std::vector<char> kept;
    for (int trial = 0; trial < kThinTrials; ++trial) {
      const std::vector<char> before = kept;
      std::unique_ptr<Level> own;
      if (trial > 0 || level == nullptr) {
        own = thinned(nullptr, limit, run, kept);
        level = own.get();
      }
      if (std::optional<Simplified> cut = simplifyFrom(*level, within, run, kept))
        return std::move(*cut);
      // If no vertex was added to `kept`, a further trial would give the same result.
      if (kept == before) break;
    }
  }
  return {mesh_, contactTime_, featureEdges(), sources_, 0};
}

// Gives each vertex of the result the contact time of the nearest vertex of the level.
void Simplifier::addContactTime(const Level& level, Simplified& out) const {
  std::int32_t near = -1;
  for (const Vector3d& p : out.mesh.vertices) {
    level.nearest->query(p, 1e300, 0, near);
    const auto& tri = level.mesh.triangles[near];
    const std::int32_t v = *std::min_element(tri.begin(), tri.end(), [&](auto a, auto b) {
      return (level.mesh.vertices[a] - p).squaredNorm() <
             (level.mesh.vertices[b] - p).squaredNorm();
    });
    out.contactTime.push_back(contactTime_[level.source[v]]);
  }
}

std::optional<Simplified> Simplifier::simplifyFrom(const Level& level, double tolerance,
                                                   RunContext& run, std::vector<char>& kept) const {
  CollapseState state = startFrom(level);
  state.tolerance = kPointFraction * (tolerance - level.limit / 2);
  watchLongEdges(state, std::vector<char>(level.mesh.triangles.size(), 0));
  CollapseLog log;
  collapseEdges(state, false, run, &log);
  DeviationMeter meter(mesh_, nearest(), cell_, tolerance);
  std::int64_t pairs = 0;
  for (int round = 0;; ++round) {
    std::vector<std::int32_t> number;
    TriMesh small = takeMesh(state, &number);
    run.checkpoint(Phase::Simplify, 3, 4);
    const Deviation deviation = meter.measure(small, number);
    std::vector<std::int32_t> wrong;
    for (const auto* places : {&deviation.missed, &deviation.strays}) {
      for (const FarPoint& place : *places) wrong.push_back(place.triangle);
    }
    if (wrong.empty()) return finished(std::move(small), deviation.largest, level);
    // Where a fold was flattened, the nearest triangle may be one that never changed. So the steps
    // at the triangle of the level are undone, too.
    for (const FarPoint& place : deviation.missed) {
      std::int32_t near = -1;
      level.nearest->query(place.onOriginal, 1e300, 0, near);
      wrong.push_back(near);
    }
    if (round == 0) pairs = findSelfIntersections(small, {}, run).count;
    if (round == kRounds ||
        !improve(state, log, wrong, deviation.missed, kFirstDepth << round, pairs, run)) {
      keepAround(deviation.missed, kept);
      return std::nullopt;
    }
    state.tolerance *= kLessEachRound;
  }
}

// Marks the vertices of the triangles at the missed places, and of their neighbours.
void Simplifier::keepAround(const std::vector<FarPoint>& missed, std::vector<char>& kept) const {
  if (missed.empty()) return;
  kept.resize(mesh_.vertices.size(), 0);
  std::vector<char> at(kept.size(), 0);
  for (const FarPoint& place : missed) {
    std::int32_t near = -1;
    nearest().query(place.onOriginal, 1e300, 0, near);
    for (const std::int32_t v : mesh_.triangles[near]) at[v] = 1;
  }
  for (const auto& tri : mesh_.triangles) {
    if (!at[tri[0]] && !at[tri[1]] && !at[tri[2]]) continue;
    for (const std::int32_t v : tri) kept[v] = 1;
  }
}

CollapseState Simplifier::startFrom(const Level& level) {
  CollapseState state;
  state.original = level.nearest.get();
  state.mesh = level.mesh;
  state.label.assign(level.mesh.triangles.size(), -1);
  state.nearby.resize(level.mesh.vertices.size());
  for (std::size_t h = 0; h < 3 * level.mesh.triangles.size(); ++h)
    state.nearby[level.mesh.triangles[h / 3][h % 3]] = static_cast<std::int32_t>(h / 3);
  return state;
}

Simplified Simplifier::finished(TriMesh mesh, double deviation, const Level& level) const {
  Simplified out;
  out.deviation = deviation;
  out.mesh = std::move(mesh);
  addContactTime(level, out);
  out.featureEdges = findFeatureEdges(out.mesh);
  if (sources_.rows) out.sources = sourcesOfSimplified(mesh_, nearest(), sources_, out.mesh, cell_);
  return out;
}

std::vector<std::array<std::int32_t, 2>> Simplifier::featureEdges() const {
  return findFeatureEdges(mesh_);
}

}  // namespace swept
