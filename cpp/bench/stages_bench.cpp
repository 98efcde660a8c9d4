// Times each stage alone, on shapes made here: a torus on a turning path, at two resolutions.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <benchmark/benchmark.h>

#include <map>
#include <memory>

#include "check/mesh_check.h"
#include "check/mesh_topology.h"
#include "contour/mend/mend.h"
#include "contour/mend/surface_intersections.h"
#include "contour/surface.h"
#include "crossings/hermite.h"
#include "geometry/body_topology.h"
#include "grid/plan_grid.h"
#include "input/body_check.h"
#include "motion/refine_motion.h"
#include "sampling/sampler.h"
#include "signs/signs.h"
#include "simplify/feature_edges.h"
#include "support/shapes.h"

namespace swept::bench {
namespace {

Trajectory turningPath() {
  Trajectory path;
  for (int n = 0; n < 5; ++n) {
    path.poses.push_back(
        test::poseOf(n, test::placement({1, 0.3, 0.2}, 35.0 * n, {2.0 * n, 0.5 * n * n, 0})));
  }
  return path;
}

/// A scene with the input of every stage, made once per resolution.
struct Scene {
  explicit Scene(int resolution) {
    RunContext run;
    Options options;
    options.resolution = resolution;
    body = checkBody(test::makeTorus(5, 2, 96, 48), options, run);
    topology = buildTopology(body.mesh);
    const Trajectory path = turningPath();
    options.cellSize =
        plannedCell(sweptBox(body.mesh, refineMotion(body.mesh, path, 0.3, run), run), options);
    motion = refineMotion(body.mesh, path, 0.02 * options.cellSize, run);
    Eigen::AlignedBox3d box;
    for (const auto& v : body.mesh.vertices) box.extend(v);
    grid = planGrid(sweptBox(body.mesh, motion, run), box, options);
    marked = sampleCpu(input(), run);
    signs = findOutside(marked, grid, run);
    hermite = buildHermiteGrid(input(), marked, signs, run);
    raw = contourUniform(hermite, Options{}, run);
    pairs = findSurfaceIntersections(raw, hermite, run);
    mended = raw;
    mendSelfIntersections(mended, hermite, pairs, run);
    neighbours = findTopology(mended.mesh, false, run);
  }
  SamplerInput input() const { return {body.mesh, topology, motion, grid, true, body.orientable}; }

  CheckedBody body;
  BodyTopology topology;
  Motion motion;
  GridPlan grid;
  MarkedEdges marked;
  SignRuns signs;
  HermiteGrid hermite;
  Surface raw, mended;
  SelfIntersections pairs;
  MeshTopology neighbours;
};

Scene& scene(const benchmark::State& state) {
  static std::map<std::int64_t, std::unique_ptr<Scene>> scenes;
  auto& found = scenes[state.range(0)];
  if (!found) found = std::make_unique<Scene>(static_cast<int>(state.range(0)));
  return *found;
}

/// Registers one stage: work(scene, run) is what is timed.
template <class Work>
void stage(benchmark::State& state, const Work& work) {
  Scene& s = scene(state);
  RunContext run;
  for (auto _ : state) work(s, run);
  state.counters["triangles"] = static_cast<double>(s.mended.mesh.triangles.size());
}

void sampling(benchmark::State& state) {
  stage(state,
        [](Scene& s, RunContext& run) { benchmark::DoNotOptimize(sampleCpu(s.input(), run)); });
}
void signs(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext& run) {
    benchmark::DoNotOptimize(findOutside(s.marked, s.grid, run));
  });
}
void crossings(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext& run) {
    benchmark::DoNotOptimize(buildHermiteGrid(s.input(), s.marked, s.signs, run));
  });
}
void contour(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext& run) {
    benchmark::DoNotOptimize(contourUniform(s.hermite, Options{}, run));
  });
}
void intersections(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext& run) {
    benchmark::DoNotOptimize(findSurfaceIntersections(s.raw, s.hermite, run));
  });
}
void intersectionsOfAnyMesh(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext& run) {
    benchmark::DoNotOptimize(findSelfIntersections(s.raw.mesh, {}, run));
  });
}
void mend(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext& run) {
    Surface copy = s.raw;
    benchmark::DoNotOptimize(mendSelfIntersections(copy, s.hermite, s.pairs, run));
  });
}
void check(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext& run) {
    benchmark::DoNotOptimize(checkMesh(s.mended.mesh, false, run));
  });
}
void features(benchmark::State& state) {
  stage(state, [](Scene& s, RunContext&) {
    benchmark::DoNotOptimize(findFeatureEdges(s.mended.mesh, s.neighbours.adjacency.across));
  });
}

#define SWEPT_STAGE(name) \
  BENCHMARK(name)->Arg(128)->Arg(384)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()
SWEPT_STAGE(sampling);
SWEPT_STAGE(signs);
SWEPT_STAGE(crossings);
SWEPT_STAGE(contour);
SWEPT_STAGE(intersections);
SWEPT_STAGE(intersectionsOfAnyMesh);
SWEPT_STAGE(mend);
SWEPT_STAGE(check);
SWEPT_STAGE(features);

}  // namespace
}  // namespace swept::bench

BENCHMARK_MAIN();
