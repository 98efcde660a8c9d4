// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/dense_trial.h"

#include <algorithm>

#include "base/timer.h"
#include "geometry/half_edges.h"
#include "sampling/dense/candidates.h"
#include "sampling/dense/dense_sampler.h"
#include "sampling/dense/pair_sampler.h"

namespace swept::dense {
namespace {

constexpr std::size_t kTrialFaces = 2000;
/// The search for leaks, and closing them, beside candidates and samples.
constexpr double kWithRepair = 1.5;
/// Bytes of a placement in the tree and in cells, of a face in the lists of candidates and leaks,
/// and of a crossing of the batch that is sorted.
constexpr double kPlacementBytes = 250, kFaceBytes = 300, kSortedBytes = 2 * sizeof(CrossingRecord);

double areaOf(const TriMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    area += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / 2;
  }
  return area;
}

/// Neighbouring faces as far as their numbers tell: most files keep neighbours together.
TriMesh someFacesOf(const TriMesh& body) {
  const std::size_t count = std::min(kTrialFaces, body.triangles.size());
  const std::size_t first = (body.triangles.size() - count) / 2;
  TriMesh part;
  std::vector<std::int32_t> number(body.vertices.size(), -1);
  for (std::size_t f = first; f < first + count; ++f) {
    auto t = body.triangles[f];
    for (std::int32_t& v : t) {
      std::int32_t& known = number[static_cast<std::size_t>(v)];
      if (known < 0) {
        known = static_cast<std::int32_t>(part.vertices.size());
        part.vertices.push_back(body.vertices[static_cast<std::size_t>(v)]);
      }
      v = known;
    }
    part.triangles.push_back(t);
  }
  return part;
}

}  // namespace

DenseCost tryDense(const SamplerInput& input, RunContext& run) {
  const DenseSettings settings;
  const double start = threadSeconds();
  const PlacementSpace space(input.body, input.motion.placements);
  const double built = threadSeconds();
  const TriMesh part = someFacesOf(input.body);
  const BodyTopology topology = buildTopology(part);
  const SamplerInput some{part, topology, input.motion, input.grid, input.cull, input.orientable};
  ListsByKey<> corners = halfEdgesByVertex(part);
  for (std::size_t v = 0; v < corners.keys(); ++v) corners.of(v);
  const FacePlacements candidates = findCandidates(some, space, settings, corners, run);
  PairSampler sampler(some, run);
  for (std::uint32_t f = 0; f < part.triangles.size(); ++f) {
    sampler.add(f, candidates.placement.data() + candidates.start[f],
                candidates.placement.data() + candidates.start[f + 1]);
  }
  sampler.flush();
  const double faces = static_cast<double>(input.body.triangles.size());
  const double times = faces / static_cast<double>(part.triangles.size());
  const double pairs = times * static_cast<double>(sampler.pairs()) + settings.wholeCopies * faces;
  const double each = areaOf(part) / static_cast<double>(part.triangles.size()) /
                      (input.grid.cell * input.grid.cell);
  const double crossings = static_cast<double>(sampler.crossings()) /
                           std::max(1.0, static_cast<double>(sampler.pairs()));  // of a pair
  DenseCost cost;
  cost.seconds = built - start + kWithRepair * times * (threadSeconds() - built);
  cost.bytes = static_cast<double>(input.motion.placements.size()) * kPlacementBytes +
               faces * kFaceBytes + 4 * pairs +
               std::min(pairs, PairSampler::pairsOfBatch(each)) * crossings * kSortedBytes;
  return cost;
}

}  // namespace swept::dense
