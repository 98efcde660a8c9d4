// Estimates the cost of a solid: by a guess from the mesh, or by a trial that builds and writes the
// solid without a file. A trial cannot measure the time to read the file back and check it; this
// time is predicted from the number of faces.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <ostream>
#include <streambuf>

#include "base/threads.h"
#include "base/timer.h"
#include "solid/mesh/patches.h"
#include "solid/solid_build.h"
#include "solid/text/tessellated.h"
#include "swept/solid.h"

namespace swept {
namespace {

using namespace step;

// Seconds, measured on triangulated bodies and swept parts (tests/tools/solid_estimate_suite.py).
constexpr double kGuessPerFace = 3e-4, kGuessPerTriangle = 8e-6;
constexpr double kTessellatedPerTriangle = 2e-6;  // per triangle of a tessellated solid
// Seconds to read back and check a plane face, and an edge of a curved face. A BREP file takes less
// time, because the kernel need not heal it.
constexpr double kStepFace = 2e-4, kStepCurvedEdge = 1e-3;
constexpr double kBrepFace = 2e-5, kBrepCurvedEdge = 1e-4;

// Counts the bytes that are written.
class CountingBuffer : public std::streambuf {
 public:
  std::uint64_t count() const { return count_; }

 private:
  int_type overflow(int_type c) override {
    ++count_;
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* /*text*/, std::streamsize length) override {
    count_ += static_cast<std::uint64_t>(length);
    return length;
  }
  std::uint64_t count_ = 0;
};

bool isTessellated(const SolidOptions& options, SolidFormat format) {
  return options.schema == StepSchema::Ap242Tessellated && format == SolidFormat::Step;
}

SolidEstimate ofTriangles(const HalfEdgeMesh& mesh) {
  SolidEstimate estimate;
  estimate.triangles = estimate.faces = static_cast<std::int64_t>(mesh.triangles.size());
  estimate.megabytes = tessellatedMegabytes(estimate.faces);
  estimate.seconds = kTessellatedPerTriangle * static_cast<double>(estimate.triangles);
  estimate.tried = true;
  return estimate;
}

SolidEstimate guess(const TriMesh& input, const SolidOptions& options, SolidFormat format,
                    RunContext& run) {
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  if (isTessellated(options, format)) return ofTriangles(mesh);
  SolidEstimate estimate;
  estimate.triangles = static_cast<std::int64_t>(mesh.triangles.size());
  if (options.tolerance > 0) {
    double tolerance = options.tolerance;
    estimate.faces = static_cast<std::int64_t>(
        uprightWithin(tolerance, [&] { return thinned(mesh, tolerance, run); }).triangles.size());
  } else {
    Partition partition;
    partition.patchOf.assign(mesh.triangles.size(), -1);
    if (options.mergeCoplanar) growPlanes(mesh, options.planarTolerance, partition, run);
    estimate.faces =
        static_cast<std::int64_t>(partition.patches.size()) +
        std::count(partition.patchOf.begin(), partition.patchOf.end(), std::int32_t{-1});
    // Above the limit of faces, the export searches for a tolerance with fewer faces.
    if (!options.exact) estimate.faces = std::min(estimate.faces, options.maxFaces);
  }
  estimate.megabytes = megabytesOf(estimate.faces, mesh, options, format);
  if (options.maxMegabytes)
    estimate.megabytes = std::min(estimate.megabytes, *options.maxMegabytes);
  estimate.seconds = kGuessPerFace * static_cast<double>(estimate.faces) +
                     kGuessPerTriangle * static_cast<double>(estimate.triangles);
  return estimate;
}

// Returns the seconds that the kernel needs to read the file back and check it.
double secondsToReadBack(const Built& built, SolidFormat format) {
  const bool brep = format == SolidFormat::Brep;
  const double face = brep ? kBrepFace : kStepFace, edge = brep ? kBrepCurvedEdge : kStepCurvedEdge;
  double seconds = 0;
  if (built.model.faces.empty()) {
    constexpr double kEdgesPerFace = 5;  // a swept pulley: 504 edges, each of two of its 194 faces
    for (const auto& [kind, count] : built.facesByKind)
      seconds += static_cast<double>(count) *
                 (kind == surfaceKindName(CarrierKind::Plane) ? face : kEdgesPerFace * edge);
    return seconds;
  }
  for (const ModelFace& modelFace : built.model.faces) {
    if (modelFace.surface.isPlanar()) {
      seconds += face;
      continue;
    }
    for (const auto& loop : modelFace.loops) seconds += edge * static_cast<double>(loop.size());
  }
  return seconds;
}

SolidEstimate tryOut(const TriMesh& input, SolidOptions& options, SolidFormat format,
                     RunContext& run) {
  Timer watch;
  const HalfEdgeMesh mesh = buildHalfEdges(input, run);
  if (isTessellated(options, format)) return ofTriangles(mesh);
  const std::unique_ptr<Judge> judge = openJudge();
  SolidEstimate estimate;
  withJudge(*judge, mesh.triangles.size(), run, [&] {
    const Built built = buildWithinLimits(mesh, options, format, *judge, run);
    CountingBuffer buffer;
    std::ostream out(&buffer);
    writeBuilt(built, *judge, out, "", options, format, run);
    estimate.tried = true;
    estimate.triangles = static_cast<std::int64_t>(mesh.triangles.size());
    estimate.faces = built.faceCount();
    estimate.megabytes = 1e-6 * static_cast<double>(buffer.count());
    estimate.tolerance = options.tolerance;
    estimate.deviation = built.deviation;
    estimate.trialSeconds = watch.seconds();
    estimate.seconds = estimate.trialSeconds + secondsToReadBack(built, format);
  });
  return estimate;
}

}  // namespace

SolidEstimate guessSolid(const TriMesh& mesh, const SolidOptions& options, SolidFormat format,
                         RunContext& run) {
  checkOptions(options);
  tbb::task_arena arena(threadsOf(run));
  return arena.execute([&] { return guess(mesh, options, format, run); });
}

SolidEstimate trySolid(const TriMesh& mesh, const SolidOptions& options, SolidFormat format,
                       RunContext& run) {
  checkOptions(options);
  tbb::task_arena arena(threadsOf(run));
  return arena.execute([&] {
    std::string why;
    return orFacets(options, why,
                    [&](SolidOptions& used) { return tryOut(mesh, used, format, run); });
  });
}

}  // namespace swept
