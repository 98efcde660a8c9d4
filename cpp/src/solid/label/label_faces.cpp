// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/label/label_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "solid/label/label_steps.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

// Returns the approximate mean length of the edges of the triangles.
double spacingOf(const HalfEdgeMesh& mesh) {
  return std::sqrt(2 * mesh.area / static_cast<double>(mesh.triangles.size()));
}

// How far the surface that an edge sweeps is extended at its borders, as a multiple of the mean
// length of the edges of triangles.
constexpr double kExtension = 4;

Labels emptyLabels(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance) {
  const double spacing = spacingOf(mesh);
  return {mesh,
          tolerance,
          spacing,
          SweptCarriers(*origin.shape, origin.trajectory, kExtension * spacing),
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

}  // namespace

Partition labelFaces(const HalfEdgeMesh& mesh, const SolidOrigin& origin, double tolerance,
                     const std::vector<Eigen::Vector3d>& open, RunContext& run) {
  constexpr int kRounds = 8;
  Labels labels = emptyLabels(mesh, origin, tolerance);
  takeSources(origin, labels, run);
  const auto explained =
      std::count_if(labels.of.begin(), labels.of.end(), [](std::int32_t n) { return n >= 0; });
  if (2 * explained < std::ssize(labels.of)) return {};
  labels.known.finish();
  for (int round = 0; round < kRounds; ++round) {
    run.checkpoint(Phase::Export);
    const bool tidied = tidyRegions(labels), mended = mendCorners(labels);
    if (!tidied && !mended) break;
  }
  if (!open.empty()) makeFacets(open, labels);
  Partition partition = Parts(labels).make(labels);
  cutRoundPatches(mesh, partition);
  return partition;
}

}  // namespace swept::step
