// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/collapse_log.h"

#include <algorithm>
#include <unordered_map>

namespace swept {
using Eigen::Vector3d;

void CollapseLog::add(std::int32_t from, std::int32_t to, const Vector3d& position,
                      const std::vector<std::int32_t>& remaining,
                      const std::vector<Corners>& corners,
                      const std::vector<std::int32_t>& removed) {
  steps_.push_back({from, to, position, triangles_.size(),
                    static_cast<std::int32_t>(remaining.size()),
                    static_cast<std::int32_t>(removed.size())});
  triangles_.insert(triangles_.end(), remaining.begin(), remaining.end());
  triangles_.insert(triangles_.end(), removed.begin(), removed.end());
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  corners_.resize(triangles_.size());
}

void CollapseLog::append(const CollapseLog& later) {
  const std::size_t shift = triangles_.size();
  for (Step step : later.steps_) {
    step.first += shift;
    steps_.push_back(step);
  }
  triangles_.insert(triangles_.end(), later.triangles_.begin(), later.triangles_.end());
  corners_.insert(corners_.end(), later.corners_.begin(), later.corners_.end());
}

template <class Visit>
void CollapseLog::forTriangles(const Step& step, const Visit& visit) const {
  for (std::size_t i = step.first; i < step.first + step.remaining + step.removed; ++i)
    visit(triangles_[i]);
}

std::vector<char> CollapseLog::chosenSteps(const std::vector<std::int32_t>& triangles, int depth,
                                           std::vector<char>& dirty) const {
  std::vector<char> chosen(steps_.size(), 0);
  std::unordered_map<std::int32_t, int> left;
  for (const std::int32_t t : triangles) left[t] = depth;
  for (std::size_t s = steps_.size(); s-- > 0;) {
    forTriangles(steps_[s], [&](std::int32_t t) {
      const auto found = left.find(t);
      if (found == left.end()) return;
      chosen[s] = 1;
      if (--found->second == 0) left.erase(found);
    });
    if (left.empty()) break;
  }
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    forTriangles(steps_[s], [&](std::int32_t t) { chosen[s] |= dirty[t]; });
    if (!chosen[s]) continue;
    forTriangles(steps_[s], [&](std::int32_t t) { dirty[t] = 1; });
  }
  return chosen;
}

std::vector<std::int32_t> CollapseLog::takeBack(CollapseState& state,
                                                const std::vector<std::int32_t>& triangles,
                                                int depth) {
  std::vector<char> dirty(state.dead.size(), 0);
  const std::vector<char> chosen = chosenSteps(triangles, depth, dirty);
  for (std::size_t s = steps_.size(); s-- > 0;) {
    if (chosen[s]) takeBack(state, steps_[s]);
  }
  std::size_t kept = 0;
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    if (!chosen[s]) steps_[kept++] = steps_[s];
  }
  steps_.resize(kept);
  std::vector<std::int32_t> changed;
  for (std::size_t t = 0; t < dirty.size(); ++t) {
    if (dirty[t]) changed.push_back(static_cast<std::int32_t>(t));
  }
  return changed;
}

void CollapseLog::takeBack(CollapseState& state, const Step& step) const {
  std::vector<std::int32_t> open;  // triangles of open ground, to which points may be attached
  std::vector<Vector3d> points;
  std::vector<std::int32_t>&aroundTo = state.around[step.to], &aroundFrom = state.around[step.from];
  state.gone[step.from] = 0;
  state.mesh.vertices[step.to] = step.position;
  state.quadric[step.to] -= state.quadric[step.from];
  forTriangles(step, [&](std::int32_t t) {
    if (state.label[t] < 0) open.push_back(t);
    points.insert(points.end(), state.attached[t].begin(), state.attached[t].end());
    state.attached[t].clear();
  });
  for (std::size_t i = step.first; i < step.first + step.remaining; ++i) {
    const std::int32_t t = triangles_[i];
    state.mesh.triangles[t] = corners_[i];
    if (!has(corners_[i], step.from)) continue;
    std::erase(aroundTo, t);
    aroundFrom.push_back(t);
  }
  for (std::int32_t i = 0; i < step.removed; ++i) {
    const std::int32_t t = triangles_[step.first + step.remaining + i];
    state.dead[t] = 0;
    for (const std::int32_t v : state.mesh.triangles[t]) state.around[v].push_back(t);
  }
  for (const Vector3d& p : points) {
    const auto nearer = [&](std::int32_t a, std::int32_t b) {
      return squaredDistance(p, state.mesh, a) < squaredDistance(p, state.mesh, b);
    };
    state.attached[*std::min_element(open.begin(), open.end(), nearer)].push_back(p);
  }
}

}  // namespace swept
