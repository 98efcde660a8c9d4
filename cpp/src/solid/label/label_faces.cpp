// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/label/label_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "simplify/thin.h"
#include "solid/label/label_steps.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

// Mean length of the edges of triangles.
double spacingOf(const HalfEdgeMesh& mesh) {
  return std::sqrt(2 * mesh.area / static_cast<double>(mesh.triangles.size()));
}

// How far surfaces go on beyond what an edge sweeps, in edges of triangles.
constexpr double kRoom = 4;

Labels emptyLabels(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance) {
  const double spacing = spacingOf(mesh);
  return {mesh,
          tolerance,
          spacing,
          SweptCarriers(*origin.shape, origin.trajectory, kRoom * spacing),
          std::vector<std::int32_t>(mesh.triangles.size(), -1),
          std::vector<Eigen::Vector3d>(mesh.triangles.size())};
}

void takeSources(const SolidOrigin& origin, Labels& labels, RunContext& run) {
  const HalfEdgeMesh& mesh = labels.mesh;
  const std::vector<SurfaceSource>& rows = *origin.sources.rows;
  std::vector<const std::vector<std::int32_t>*> allowed(mesh.triangles.size(), nullptr);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if ((t & 0xffffU) == 0) run.checkpoint(Phase::Export);
    const std::uint32_t row = origin.sources.of[t];
    const auto& [a, b, c] = mesh.triangles[t];
    labels.points[t] = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
    if (row == Sources::kNone) continue;
    labels.points[t] = rows[row].point;
    allowed[t] = &labels.known.carriersOf(rows[row]);
  }
  const double limit = std::min(labels.tolerance, 3 * origin.chordError + 0.02 * labels.spacing);
  parallelBlocks(allowed.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (allowed[t] == nullptr) continue;
      double smallest = limit;
      for (const std::int32_t n : *allowed[t]) {
        const double off = std::abs(labels.known.carriers()[n].distance(labels.points[t]));
        if (off >= smallest) continue;
        smallest = off;
        labels.of[t] = n;
      }
    }
  });
}

// Returns the carrier with its normal pointing away from the material.
Carrier outward(const Carrier& given, const Labels& labels,
                const std::vector<std::int32_t>& members) {
  double sum = 0;
  for (const std::int32_t t : members)
    sum += given.normal(labels.points[t]).dot(labels.mesh.areaVector(t));
  Carrier carrier = given;
  if (sum < 0 && carrier.isPlanar()) carrier.axis = -carrier.axis;
  if (sum < 0 && !carrier.isPlanar()) carrier.reversed = !carrier.reversed;
  return carrier;
}

class Parts : LabelTools {
 public:
  using LabelTools::LabelTools;

  Partition make(const Labels& labels) const {
    Partition partition;
    partition.patchOf.assign(of_.size(), kNone);
    const Regions all = regions();
    for (const auto& members : all.triangles) {
      const std::int32_t n = of_[members.front()];
      if (n < 0) continue;
      const auto id = static_cast<std::int32_t>(partition.patches.size());
      for (const std::int32_t t : members) partition.patchOf[t] = id;
      partition.patches.push_back({outward(carrier(n), labels, members), members, 0, id});
    }
    return partition;
  }
};

// Moves vertices where labelled borders end in open ground onto all carriers that meet there. The
// border of the mesh may be a cell away.
class Ends : LabelTools {
 public:
  explicit Ends(Labels& labels) : LabelTools(labels) {}

  // Moves the vertices of `points`. Returns those that have no place.
  std::vector<std::int32_t> settle(std::vector<Vector3d>& points) const {
    std::vector<std::int32_t> left;
    anyVertex([&](std::int32_t first) {
      std::vector<const Carrier*> around;
      bool isOpen = false;
      std::vector<std::int32_t> triangles;
      std::int32_t h = first;
      do {
        triangles.push_back(h / 3);
        const std::int32_t n = of_[h / 3];
        isOpen = isOpen || n < 0;
        if (n >= 0 && std::find(around.begin(), around.end(), &carrier(n)) == around.end())
          around.push_back(&carrier(n));
        h = mesh_.opposite[HalfEdgeMesh::previous(h)];
      } while (h != first);
      const std::int32_t v = mesh_.origin(first);
      if (!isOpen || around.empty() || areOn(points[v], around)) return false;
      const auto known = knownPlace(points[v], around, kReach * spacing_);
      const Vector3d to = known ? *known : meetingPoint(points[v], around);
      if (areOn(to, around) && (to - points[v]).norm() <= kReach * spacing_ &&
          keepsSides(v, to, triangles)) {
        points[v] = to;
      } else {
        left.push_back(v);
      }
      return false;
    });
    return left;
  }

 private:
  static constexpr double kReach = 1.5;

  static bool areOn(const Vector3d& p, const std::vector<const Carrier*>& around) {
    return std::all_of(around.begin(), around.end(),
                       [&](const Carrier* s) { return std::abs(s->distance(p)) <= kMeet; });
  }

  // Whether no triangle turns over if the vertex moves.
  bool keepsSides(std::int32_t v, const Vector3d& to,
                  const std::vector<std::int32_t>& triangles) const {
    constexpr double kLeastCosine = 0.2;
    return std::all_of(triangles.begin(), triangles.end(), [&](std::int32_t t) {
      std::array<Vector3d, 3> c;
      for (int k = 0; k < 3; ++k)
        c[k] = mesh_.triangles[t][k] == v ? to : mesh_.points[mesh_.triangles[t][k]];
      const Vector3d now = (c[1] - c[0]).cross(c[2] - c[0]), before = mesh_.areaVector(t);
      return now.dot(before) > kLeastCosine * now.norm() * before.norm() &&
             now.norm() > 0.02 * before.norm();
    });
  }
};

}  // namespace

FaceLabels::FaceLabels(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance,
                       RunContext& run)
    : labels_(std::make_unique<Labels>(emptyLabels(mesh, origin, tolerance))) {
  constexpr int kRounds = 8;
  Labels& labels = *labels_;
  takeSources(origin, labels, run);
  const auto explained =
      std::count_if(labels.of.begin(), labels.of.end(), [](std::int32_t n) { return n >= 0; });
  explainMost_ = 2 * explained >= std::ssize(labels.of);
  if (!explainMost_) return;
  labels.known.finish();
  for (int round = 0; round < kRounds; ++round) {
    run.checkpoint(Phase::Export);
    const bool tidied = tidyRegions(labels), mended = mendCorners(labels);
    if (!tidied && !mended) break;
  }
  removeSpecks(labels);
  thin(mesh, run);
}

// Only the borders of faces need small triangles.
void FaceLabels::thin(const HalfEdgeMesh& mesh, RunContext& run) {
  constexpr int kRings = 5;
  constexpr double kFraction = 0.15;  // of the tolerance
  const Labels& labels = *labels_;
  std::vector<char> kept(mesh.points.size(), 0);
  for (std::size_t h = 0; h < mesh.opposite.size(); ++h) {
    const std::int32_t own = labels.of[h / 3];
    if (own < 0 || own != labels.of[mesh.opposite[h] / 3])
      kept[mesh.origin(static_cast<std::int32_t>(h))] = 1;
  }
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<char> wider = kept;
    for (const auto& [a, b, c] : mesh.triangles) {
      if (kept[a] || kept[b] || kept[c]) wider[a] = wider[b] = wider[c] = 1;
    }
    kept.swap(wider);
  }
  const Thinned thinned = thinOut({mesh.points, mesh.triangles}, kFraction * labels.tolerance,
                                  ThinFor::Collapse, Phase::Export, run, std::move(kept));
  thin_ = buildHalfEdges(thinned.mesh, run);
  std::vector<std::int32_t> of;
  std::vector<Eigen::Vector3d> points;
  for (const std::int32_t t : thinned.triangle) {
    of.push_back(labels.of[t]);
    points.push_back(labels.points[t]);
  }
  labels_ =
      std::make_unique<Labels>(Labels{thin_, labels.tolerance, labels.spacing,
                                      std::move(labels_->known), std::move(of), std::move(points)});
}

FaceLabels::~FaceLabels() = default;

void FaceLabels::open(const std::vector<OpenSpot>& spots) {
  constexpr int kRounds = 6;
  constexpr double kWider = 1.2;
  std::vector<OpenSpot> next = spots;
  for (int round = 0; round < kRounds && !next.empty(); ++round) {
    openGround(next, *labels_);
    next.clear();
    for (const std::int32_t v : Ends(*labels_).settle(thin_.points))
      next.push_back({thin_.points[v], kWider});
  }
}

Partition FaceLabels::partition() const {
  Partition partition = Parts(*labels_).make(*labels_);
  cutRoundPatches(thin_, partition);
  return partition;
}

}  // namespace swept::step
