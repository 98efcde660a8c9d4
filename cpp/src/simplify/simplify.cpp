// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplify.h"

#include <algorithm>

#include "base/parallel.h"
#include "simplify/collapse.h"
#include "simplify/deviation.h"
#include "simplify/feature_edges.h"
#include "simplify/simplified_sources.h"
#include "simplify/thin.h"

namespace swept {
namespace {

using Eigen::Vector3d;

/// Of the tolerance, for thinning; the rest is left to the edge collapse.
constexpr double kThinFraction = 0.15;
constexpr double kFirstLevel = 0.025;  ///< cells
/// Of what is left of the tolerance: limit of the collapse, which looks at points; between them the
/// surface may lie farther.
constexpr double kPointFraction = 0.97;
constexpr double kLessEachRound = 0.9;  ///< of the tolerance, where the measured deviation failed
constexpr int kRounds = 4;
constexpr double kLeastFraction = 0.1;  ///< of the tolerance, before nothing is simplified at all

// Where triangles stray from the original, those that are made in the next round are looked at more
// closely.
void markCareful(const TriMesh& small, const std::vector<std::int32_t>& strays, double reach,
                 const std::vector<Vector3d>& vertices, std::vector<char>& careful) {
  const Vector3d around = Vector3d::Constant(reach);
  const BoxTree boxes(strays.size(), [&](std::size_t i) {
    BoxTree::Bounds box;
    for (const std::int32_t v : small.triangles[strays[i]]) {
      box.extend(small.vertices[v] - around);
      box.extend(small.vertices[v] + around);
    }
    return box;
  });
  for (std::size_t v = 0; v < vertices.size(); ++v)
    boxes.forBox(vertices[v], vertices[v], [&](std::uint32_t) { careful[v] = 1; });
}

}  // namespace

Simplifier::Simplifier(TriMesh mesh, std::vector<double> contactTime, double cell, Sources sources)
    : mesh_(std::move(mesh)),
      contactTime_(std::move(contactTime)),
      cell_(cell),
      sources_(std::move(sources)) {}

std::unique_ptr<Simplifier::Level> Simplifier::thinned(const Level* from, double limit,
                                                       RunContext& run) const {
  Thinned thin =
      thinOut(from != nullptr ? from->mesh : mesh_, limit, ThinFor::Collapse, Phase::Simplify, run);
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
    // Nothing becomes smaller than a handful of triangles.
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

Simplified Simplifier::cut(double tolerance, RunContext& run) const {
  run.checkpoint(Phase::Simplify);
  // Where no round holds the tolerance, what half of it allows does.
  for (double within = tolerance; within > kLeastFraction * tolerance; within /= 2) {
    const Level* level = levelWithin(kThinFraction * within, run);
    std::unique_ptr<Level> own;
    if (level == nullptr) {
      own = thinned(nullptr, kThinFraction * within, run);
      level = own.get();
    }
    if (std::optional<Simplified> cut = cutFrom(*level, within, run)) return std::move(*cut);
  }
  return {mesh_, contactTime_, featureEdges(), sources_, 0};
}

// By the nearest vertex of the level.
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

std::optional<Simplified> Simplifier::cutFrom(const Level& level, double tolerance,
                                              RunContext& run) const {
  Simplified out;
  double within = kPointFraction * (tolerance - level.limit / 2);
  std::vector<std::pair<std::int32_t, Vector3d>> missed;  // by triangle of the level
  std::vector<char> careful(level.mesh.vertices.size(), 0);
  for (int round = 0; round < kRounds; ++round) {
    if (round > 1) within *= kLessEachRound;
    CollapseState state;
    state.tolerance = within;
    state.original = level.nearest.get();
    state.mesh = level.mesh;
    state.label.assign(level.mesh.triangles.size(), -1);
    watchLongEdges(state, std::vector<char>(level.mesh.triangles.size(), 0));
    for (const auto& [triangle, p] : missed) state.attached[triangle].push_back(p);
    state.careful = careful;
    state.nearby.resize(level.mesh.vertices.size());
    for (std::size_t h = 0; h < 3 * level.mesh.triangles.size(); ++h)
      state.nearby[level.mesh.triangles[h / 3][h % 3]] = static_cast<std::int32_t>(h / 3);
    collapseEdges(state, false, run);
    TriMesh small = takeMesh(state);
    run.checkpoint(Phase::Simplify, 3, 4);
    const Deviation deviation = measureDeviation(mesh_, nearest(), small, cell_, tolerance);
    if (deviation.largest <= tolerance) {
      out.deviation = deviation.largest;
      out.mesh = std::move(small);
      addContactTime(level, out);
      out.featureEdges = findFeatureEdges(out.mesh);
      if (sources_.rows)
        out.sources = sourcesOfSimplified(mesh_, nearest(), sources_, out.mesh, cell_);
      return out;
    }
    for (const Vector3d& p : deviation.missed) {
      std::int32_t near = -1;
      level.nearest->query(p, 1e300, 0, near);
      missed.emplace_back(near, p);
    }
    markCareful(small, deviation.strays, tolerance, level.mesh.vertices, careful);
  }
  return std::nullopt;
}

std::vector<std::array<std::int32_t, 2>> Simplifier::featureEdges() const {
  return findFeatureEdges(mesh_);
}

}  // namespace swept
