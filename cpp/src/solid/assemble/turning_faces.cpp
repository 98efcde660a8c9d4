// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/turning_faces.h"

#include <algorithm>

#include "motion/step_path.h"
#include "solid/assemble/body_motion.h"
#include "solid/assemble/elementary_body.h"
#include "solid/assemble/fixed_surfaces.h"
#include "solid/assemble/key_crossings.h"
#include "solid/assemble/turning_step.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Returns the largest distance of a point of the sweep from the origin, or more.
double reachOf(const ElementaryBody& body, const std::vector<StepPath>& paths) {
  constexpr int kTimes = 16, kPoints = 8;
  constexpr double kBetween = 1.1;  // samples may miss the farthest point
  double reach = 0;
  for (const BodyEdge& edge : body.edges) {
    for (const StepPath& path : paths) {
      for (int i = 0; i <= kTimes; ++i) {
        for (int j = 0; j <= kPoints; ++j) {
          const Vector3d p = edge.at(edge.range.at(static_cast<double>(j) / kPoints));
          reach = std::max(reach, path.at(static_cast<double>(i) / kTimes).apply(p).norm());
        }
      }
    }
  }
  return kBetween * reach;
}

}  // namespace

std::optional<TurningFaces> turningFaces(const TopoDS_Shape& shape, const Trajectory& trajectory) {
  const ElementaryBody body(shape);
  const bool isClosed = std::all_of(body.edges.begin(), body.edges.end(),
                                    [](const BodyEdge& edge) { return edge.faces[1] >= 0; });
  if (!isClosed) return std::nullopt;
  const std::vector<Pose>& poses = trajectory.poses;
  std::vector<StepPath> paths;
  std::vector<BodyMotion> motions;
  paths.reserve(poses.size());
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    paths.emplace_back(poses[k], poses[k + 1], trajectory.interpolation);
    motions.emplace_back(body, paths.back());
  }
  FixedSurfaces fixed(body, poses, motions, reachOf(body, paths));
  if (fixed.doOverlap()) return std::nullopt;
  TurningFaces result;
  for (std::size_t i = 0; i < fixed.count(); ++i) result.faces.push_back(fixed.candidate(i));
  std::vector<PosedBody> posed;
  std::vector<std::vector<int>> caps;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    posed.emplace_back(body.shape, poses[k]);
    std::vector<int>& of = caps.emplace_back();
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
      const int surface = fixed.surfaceOf(k, f);
      of.push_back(surface >= 0 ? surface : static_cast<int>(result.faces.size()));
      if (surface < 0) {
        result.faces.push_back({posed[k].of(body.faces[f]), static_cast<int>(k), {}});
        continue;
      }
      for (const int e : body.faces[f].edges) fixed.add(surface, posed[k].of(body.edges[e]));
    }
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    TurningStep step(body, paths[k], motions[k], fixed, result);
    if (!step.append(posed[k], posed[k + 1], {&caps[k], &caps[k + 1]})) return std::nullopt;
    step.addPathsTo(fixed, k);
    if (k > 0) appendKeyCrossings(body, paths[k - 1], paths[k], result.crossings);
  }
  for (std::size_t i = 0; i < fixed.count(); ++i) result.faces[i] = fixed.candidate(i);
  return result;
}

}  // namespace swept::step
