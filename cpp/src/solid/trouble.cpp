// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/trouble.h"

#include <algorithm>
#include <cmath>

#include "base/sort_unique.h"
#include "solid/carrier/section.h"
#include "solid/carrier/traces.h"
#include "solid/model/gaps.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

/// Share of the tolerance by which an edge between labelled faces may be off.
constexpr double kMeetFraction = 0.1;
/// Triangles of a small face.
constexpr std::size_t kSmall = 30;

template <class Visit>
void forEdges(const ModelFace& face, const Visit& visit) {
  for (const auto& loop : face.loops) {
    for (const ModelUse& use : loop) visit(use.edge);
  }
}

}  // namespace

Trouble::Trouble(const HalfEdgeMesh& mesh, const Partition& labelled, double tolerance, int round)
    : mesh_(mesh), labelled_(labelled), tolerance_(tolerance), round_(round) {}

bool Trouble::isLabelled(const ModelFace& face) const {
  return face.patch < std::ssize(labelled_.patches);
}

std::vector<std::int32_t> Trouble::findLoose(const Model& model) const {
  return findLooseFaces(model, static_cast<std::int32_t>(labelled_.patches.size()),
                        kMeetFraction * tolerance_, tolerance_);
}

void Trouble::noteLoose(const std::vector<std::int32_t>& loose, const Model& model) {
  std::vector<double> allowed(model.edges.size(), kMeetFraction * tolerance_);
  for (const ModelFace& face : model.faces) {
    if (isLabelled(face)) continue;
    forEdges(face, [&](std::int32_t e) { allowed[e] = tolerance_; });
  }
  for (const std::int32_t f : loose) {
    const ModelFace& face = model.faces[f];
    if (!isLabelled(face)) continue;
    forEdges(face,
             [&](std::int32_t e) { noteEdge(model.edges[e].curve, face.surface, allowed[e]); });
  }
}

void Trouble::noteRefused(const std::vector<std::int32_t>& bad, const Model& model) {
  if (spots_.empty()) noteSmall(bad, model);
  if (spots_.empty()) noteLoose(bad, model);
  if (spots_.empty()) noteNarrow(bad, model);
  if (spots_.empty()) noteShared(bad, model);
  if (!spots_.empty()) return;
  std::int32_t smallest = -1;
  const auto sizeOf = [&](std::int32_t patch) { return labelled_.patches[patch].triangles.size(); };
  for (const std::int32_t f : bad) {
    const std::int32_t patch = model.faces[f].patch;
    if (isLabelled(model.faces[f]) && (smallest < 0 || sizeOf(patch) < sizeOf(smallest)))
      smallest = patch;
  }
  if (smallest >= 0) notePatch(smallest);
}

void Trouble::noteSmall(const std::vector<std::int32_t>& bad, const Model& model) {
  for (const std::int32_t f : bad) {
    const std::int32_t patch = model.faces[f].patch;
    if (isLabelled(model.faces[f]) && labelled_.patches[patch].triangles.size() <= kSmall)
      notePatch(patch);
  }
}

// Notes where two edges of a face nearly touch: the face is too narrow there.
void Trouble::noteNarrow(const std::vector<std::int32_t>& bad, const Model& model) {
  constexpr int kSteps = 16;
  constexpr double kTouch = 0.3, kFromCorner = 3;  // of the tolerance
  for (const std::int32_t f : bad) {
    if (!isLabelled(model.faces[f])) continue;
    std::vector<std::int32_t> edges;
    forEdges(model.faces[f], [&](std::int32_t e) { edges.push_back(e); });
    sortUnique(edges);
    for (const std::int32_t e : edges) {
      const Curve& curve = model.edges[e].curve;
      for (int i = 0; i <= kSteps; ++i) {
        const Vector3d p = curve.at(curve.last * i / kSteps);
        const auto touches = [&](std::int32_t other) {
          const Curve& beside = model.edges[other].curve;
          const double t = nearestParameter(beside, p);
          // Edges that share a corner touch there.
          const double toEnd =
              std::min((beside.at(0) - p).norm(), (beside.at(beside.last) - p).norm());
          return other != e && toEnd > kFromCorner * tolerance_ &&
                 (beside.at(t) - p).norm() < kTouch * tolerance_;
        };
        if (std::any_of(edges.begin(), edges.end(), touches)) noteSpot(p);
      }
    }
  }
}

void Trouble::noteShared(const std::vector<std::int32_t>& bad, const Model& model) {
  std::vector<std::int32_t> corners;
  for (const std::int32_t f : bad) {
    std::vector<std::int32_t> own;
    forEdges(model.faces[f], [&](std::int32_t e) {
      own.push_back(model.edges[e].start);
      own.push_back(model.edges[e].end);
    });
    sortUnique(own);
    corners.insert(corners.end(), own.begin(), own.end());
  }
  std::sort(corners.begin(), corners.end());
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i] == corners[i - 1]) noteSpot(model.vertices[corners[i]].point);
  }
}

void Trouble::notePatch(std::int32_t patch) {
  constexpr double kOwnTriangles = 0.7;
  for (const std::int32_t t : labelled_.patches[patch].triangles) {
    const auto& [a, b, c] = mesh_.triangles[t];
    spots_.push_back({(mesh_.points[a] + mesh_.points[b] + mesh_.points[c]) / 3, kOwnTriangles});
  }
}

// An edge with one end off the surface is off up to its other end, but only one end is wrong.
void Trouble::noteEdge(const Curve& curve, const Carrier& surface, double gap) {
  constexpr int kSteps = 96;
  const auto isOff = [&](double t) { return std::abs(surface.distance(curve.at(t))) > gap; };
  const bool first = isOff(0), last = isOff(curve.last);
  if (first) noteSpot(curve.at(0));
  if (last) noteSpot(curve.at(curve.last));
  if (first != last || largestGap(curve, surface) <= gap) return;
  for (int i = 1; i < kSteps; ++i) {
    const double t = curve.last * i / kSteps;
    if (isOff(t)) noteSpot(curve.at(t));
  }
}

void Trouble::noteSpot(const Vector3d& at) {
  constexpr double kFirst = 1.3, kMore = 0.5, kMost = 4;
  spots_.push_back({at, std::min(kFirst + kMore * round_, kMost)});
}

}  // namespace swept::step
