// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/dense/dense_trial.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "base/timer.h"
#include "geometry/half_edges.h"
#include "sampling/dense/candidates.h"
#include "sampling/dense/dense_sampler.h"
#include "sampling/dense/leak_repair.h"
#include "sampling/dense/pair_sampler.h"

namespace swept::dense {
namespace {

/// The patches are spaced evenly in the order of the faces. Together they have about 1 /
/// kPartOfFaces of the faces of the body, within the limits for the number of patches.
constexpr std::size_t kFacesOfPatch = 1300, kMinPatches = 4, kMaxPatches = 12, kPartOfFaces = 4;
/// Only the middle of a patch is sampled: 1 / kPartOfPatch of its faces. The faces missing around
/// the patch have no effect there.
constexpr std::size_t kPartOfPatch = 6;
/// Largest number of faces at one vertex that are added to a patch, because the faces of a large
/// fan lie far apart.
constexpr std::size_t kMaxOfStar = 48;
/// Number of exact tests that are timed, and number of exact tests that a run needs for each open
/// point.
constexpr std::size_t kTests = 500;
constexpr double kFollowed = 3;
/// Bytes per placement (in the tree and in cells), per face (in the lists of candidates, whole
/// copies and leaks), per candidate pair (while the lists of blocks are joined), and per crossing
/// of the batch that is being sorted.
constexpr double kPlacementBytes = 250, kFaceBytes = 300, kPairBytes = 8,
                 kSortedBytes = 2 * sizeof(CrossingRecord);

/// Some faces of the body, with their vertices.
struct Patches {
  TriMesh mesh;
  std::vector<std::uint8_t> inner;    ///< per face: whether it is in the middle of a patch
  std::vector<std::uint32_t> faceOf;  ///< per face: its index in the body
};

enum PatchPart : std::uint8_t { kNone, kRim, kMiddle };

/// Adds one patch: the faces around a first face, the nearest ones first.
void addPatch(const TriMesh& body, const ListsByKey<>& corners, std::size_t number,
              std::size_t patches, std::vector<PatchPart>& partOf) {
  const std::size_t first = (2 * number + 1) * body.triangles.size() / (2 * patches);
  std::vector<std::uint32_t> faces{static_cast<std::uint32_t>(first)};
  std::vector<bool> added(body.triangles.size()), spread(body.vertices.size());
  added[first] = true;
  for (std::size_t n = 0; n < faces.size() && faces.size() < kFacesOfPatch; ++n) {
    for (const std::int32_t v : body.triangles[faces[n]]) {
      if (spread[static_cast<std::size_t>(v)]) continue;
      spread[static_cast<std::size_t>(v)] = true;
      const auto star = corners.asTheyStand(static_cast<std::size_t>(v));
      const std::size_t some = std::min(star.size(), kMaxOfStar);
      const std::size_t from = star.size() * number / patches;  // each patch takes other faces
      for (std::size_t i = 0; i < some && faces.size() < kFacesOfPatch; ++i) {
        const std::uint32_t face = star[(i * star.size() + from) / some] / 3;
        if (!added[face]) faces.push_back(face);
        added[face] = true;
      }
    }
  }
  for (std::size_t n = 0; n < faces.size(); ++n)
    partOf[faces[n]] =
        std::max(partOf[faces[n]], n < kFacesOfPatch / kPartOfPatch ? kMiddle : kRim);
}

Patches somePatchesOf(const TriMesh& body) {
  const std::size_t faces = body.triangles.size();
  const std::size_t patches =
      std::clamp(faces / (kPartOfFaces * kFacesOfPatch), kMinPatches, kMaxPatches);
  if (faces <= patches * kFacesOfPatch) {
    Patches all{body, std::vector<std::uint8_t>(faces, 1), std::vector<std::uint32_t>(faces)};
    std::iota(all.faceOf.begin(), all.faceOf.end(), 0u);
    return all;
  }
  ListsByKey<> corners = halfEdgesByVertex(body);
  for (std::size_t v = 0; v < corners.keys(); ++v) corners.of(v);
  std::vector<PatchPart> partOf(faces, kNone);
  for (std::size_t n = 0; n < patches; ++n) addPatch(body, corners, n, patches, partOf);
  Patches some;
  std::vector<std::int32_t> number(body.vertices.size(), -1);
  for (std::size_t f = 0; f < faces; ++f) {
    if (partOf[f] == kNone) continue;
    auto t = body.triangles[f];
    for (std::int32_t& v : t) {
      std::int32_t& known = number[static_cast<std::size_t>(v)];
      if (known < 0) {
        known = static_cast<std::int32_t>(some.mesh.vertices.size());
        some.mesh.vertices.push_back(body.vertices[static_cast<std::size_t>(v)]);
      }
      v = known;
    }
    some.mesh.triangles.push_back(t);
    some.inner.push_back(partOf[f] == kMiddle);
    some.faceOf.push_back(static_cast<std::uint32_t>(f));
  }
  return some;
}

/// Returns the CPU seconds of an exact test of a point.
double secondsOfTest(const TriMesh& body, const BodyTests& tests) {
  const std::size_t step = 1 + body.vertices.size() / kTests;
  const double start = threadSeconds();
  double count = 0, inside = 0;
  for (std::size_t v = 0; v < body.vertices.size(); v += step, ++count)
    inside += tests.rays.winding(body.vertices[v]);
  return inside < 0 ? 0 : (threadSeconds() - start) / count;
}

/// Expected numbers of crossings of a copy of the body, and of a copy of the inner faces.
struct Work {
  double body = 0, inner = 0;
  double pairs = 0;  ///< crossings of all candidate pairs of inner faces
};

}  // namespace

DenseCost tryDense(const SamplerInput& input, double surface, RunContext& run) {
  const DenseSettings settings;
  double start = threadSeconds();
  const auto lap = [&start] {
    const double before = std::exchange(start, threadSeconds());
    return start - before;
  };
  const PlacementSpace space(input.body, input.motion.placements);
  const BodyTests tests(input.body);
  DenseCost cost;
  cost.seconds = lap();
  const auto [part, inner, faceOf] = somePatchesOf(input.body);
  const BodyTopology topology = buildTopology(part);
  const SamplerInput some{part, topology, input.motion, input.grid, input.cull, input.orientable};
  ListsByKey<> corners = halfEdgesByVertex(part);
  for (std::size_t v = 0; v < corners.keys(); ++v) corners.of(v);
  const double faces = static_cast<double>(input.body.triangles.size());
  lap();
  const FacePlacements candidates = findCandidates(some, space, settings, corners, run);
  cost.seconds += lap() * faces / static_cast<double>(inner.size());
  PairSampler sampler(some, run);
  Work work;
  double count = 0;
  for (std::uint32_t f = 0; f < part.triangles.size(); ++f) {
    if (inner[f] == 0) continue;
    const std::uint64_t begin = candidates.start[f], end = candidates.start[f + 1];
    sampler.add(f, candidates.placement.data() + begin, candidates.placement.data() + end);
    count += 1;
    work.inner += sampler.workOf(f);
    work.pairs += sampler.workOf(f) * static_cast<double>(end - begin);
  }
  sampler.flush();
  const double sampled = lap();
  const LeakTrial leaks = tryLeaks(
      input, tests, space,
      {faceOf, candidates, sampler.marked(), static_cast<std::size_t>(sampler.crossings())},
      settings.margin(input.grid.cell, space.remainder()));
  cost.seconds +=
      surface * (leaks.seconds + leaks.open * kFollowed * secondsOfTest(input.body, tests));
  const PairSampler whole(input, run);
  for (std::uint32_t f = 0; f < input.body.triangles.size(); ++f) work.body += whole.workOf(f);
  const auto copies = wholeCopies(space, input.motion.placements.size(), settings.wholeCopies);
  const double all = work.body * (work.pairs / work.inner + static_cast<double>(copies.size()));
  const double times = all / work.pairs;
  cost.pairs = faces / count * static_cast<double>(sampler.pairs());
  cost.seconds += times * sampled;
  cost.bytes = static_cast<double>(input.motion.placements.size()) * kPlacementBytes +
               faces * kFaceBytes + cost.pairs * kPairBytes +
               std::min(1.0, PairSampler::kBatchWork / all) * times *
                   static_cast<double>(sampler.crossings()) * kSortedBytes;
  return cost;
}

}  // namespace swept::dense
