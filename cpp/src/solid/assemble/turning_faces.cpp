// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/turning_faces.h"

#include <algorithm>
#include <memory>

#include "solid/assemble/envelope_conditions.h"
#include "solid/assemble/fixed_surfaces.h"
#include "solid/assemble/key_crossings.h"
#include "solid/assemble/turning_step.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

// Returns the largest distance of a point of the sweep from the origin, or more.
double reachOf(const MovingBody& moving) {
  constexpr int kTimes = 16, kPoints = 8;
  constexpr double kBetween = 1.1;  // samples may miss the farthest point
  double reach = 0;
  for (const BodyEdge& edge : moving.body.edges) {
    for (const StepPath& path : moving.paths) {
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
  const auto moving = std::make_shared<const MovingBody>(shape, trajectory);
  const BodyGeometry& body = moving->body;
  const bool isClosed = std::all_of(body.edges.begin(), body.edges.end(),
                                    [](const BodyEdge& edge) { return edge.faces[1] >= 0; });
  if (!isClosed) return std::nullopt;
  const std::vector<Pose>& poses = trajectory.poses;
  const std::vector<StepPath>& paths = moving->paths;
  FixedSurfaces fixed(body, poses, moving->motions, reachOf(*moving));
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
        SweptFace& cap = result.faces.emplace_back();
        cap.face = posed[k].of(body.faces[f]);
        cap.group = static_cast<int>(k);
        if (k > 0) cap.conditions.push_back(EnvelopeConditions(moving, k - 1).ofCap(cap.face, 1));
        if (k < paths.size())
          cap.conditions.push_back(EnvelopeConditions(moving, k).ofCap(cap.face, 0));
        continue;
      }
      for (const int e : body.faces[f].edges) fixed.add(surface, posed[k].of(body.edges[e]));
    }
  }
  for (std::size_t k = 0; k < paths.size(); ++k) {
    TurningStep step(moving, k, fixed, result);
    if (!step.append(posed[k], posed[k + 1], {&caps[k], &caps[k + 1]})) return std::nullopt;
    step.addPathsTo(fixed, k);
    if (k > 0) appendKeyCrossings(body, paths[k - 1], paths[k], result.crossings);
  }
  for (std::size_t i = 0; i < fixed.count(); ++i) result.faces[i] = fixed.candidate(i);
  return result;
}

}  // namespace swept::step
