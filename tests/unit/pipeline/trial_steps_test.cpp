// Estimates from trials, compared as counts: surfaces, sorted crossings, probes of contouring.
// tests/tools/estimate_suite.py compares seconds.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <optional>
#include <random>

#include "contour/dual_surface.h"
#include "crossings/element_probe.h"
#include "crossings/hermite.h"
#include "pipeline/plan.h"
#include "pipeline/rough_surface.h"
#include "pipeline/sampling_trial.h"
#include "sampling/cpu/deep_inside.h"
#include "sampling/cpu/work_items.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/culling/kept_elements.h"
#include "signs/signs.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

/// Returns `keys` poses along a bow of `length` mm with a turn of `turn` (rad). `noise`: standard
/// deviation of their errors (mm).
Trajectory bow(int keys, double length, double turn, double noise) {
  std::mt19937 random(7);
  std::normal_distribution<double> off(0, noise);
  Trajectory path;
  for (int n = 0; n < keys; ++n) {
    const double s = static_cast<double>(n) / (keys - 1);
    Pose pose;
    pose.timeSeconds = n;
    pose.rotation = Eigen::AngleAxisd(turn * s, Eigen::Vector3d::UnitZ());
    // Drawn in a fixed order, since compilers evaluate arguments in different orders.
    const double z = off(random), y = off(random), x = off(random);
    // The motion is slow at first.
    pose.translation =
        length * Eigen::Vector3d(s * s, 0.3 * std::sin(3 * s * s), 0) + Eigen::Vector3d(x, y, z);
    path.poses.push_back(pose);
  }
  return path;
}

/// A run, ready to be sampled.
struct Planned {
  RunContext run;
  Prepared p;
  BodyTopology topology;
  FaceClusters clusters;

  Planned(const TriMesh& body, const Trajectory& path, int resolution) {
    Options options;
    options.resolution = resolution;
    p.body = checkBody(body, options, run);
    prepareTrajectory(p, path, options);
    planRun(p, options, run);
    topology = buildTopology(p.body.mesh);
    clusters = buildClusters(p.body.mesh, topology);
  }
  SamplerInput input() const {
    return {p.body.mesh,       topology,  p.motion, p.grid,  true,
            p.body.orientable, &clusters, nullptr,  nullptr, true};
  }
};

/// Counts the calls in which contouring casts probe lines.
class CountedProbe : public SurfaceProbe {
 public:
  explicit CountedProbe(const ElementProbe& probe) : probe_(probe) {}
  void cast(const Eigen::AlignedBox3d& region, const std::vector<std::uint32_t>& crossings,
            std::vector<ProbeLine>& lines) const override {
    ++count_;
    probe_.cast(region, crossings, lines);
  }
  double count() const { return static_cast<double>(count_.load()); }

 private:
  const ElementProbe& probe_;
  mutable std::atomic<std::size_t> count_{0};
};

struct Counted {
  double sorted = 0, crossings = 0, casts = 0;
};

/// Counts crossings as a run does.
Counted counted(Planned& planned) {
  SamplerInput input = planned.input();
  std::uint64_t sorted = 0;
  input.crossings = &sorted;
  MarkedEdges marked = sampleCpu(input, planned.run);
  const SignRuns signs = findOutside(marked, planned.p.grid, planned.run);
  const HermiteGrid hermite =
      buildHermiteGrid(input, marked, signs, ExactTimes::Dropped, planned.run);
  const ElementProbe probe(input, marked.elements, hermite.winner, hermite);
  const CountedProbe countedProbe(probe);
  buildDualSurface(hermite, Options().components, &countedProbe, planned.run);
  return {static_cast<double>(sorted), static_cast<double>(hermite.crossings.size()),
          countedProbe.count()};
}

// The bounding box of a diagonal path is mostly empty: an estimate from the box gives 10 times as
// many triangles.
TEST(TrialSteps, TheSurfaceIsGuessedFromTheSweepAndNotFromItsBox) {
  for (const int turns : {0, 3}) {
    Trajectory path;
    for (int n = 0; n <= 12; ++n) {
      Pose pose;
      pose.timeSeconds = n;
      pose.rotation = Eigen::AngleAxisd(0.5 * turns * n, Eigen::Vector3d::UnitZ());
      pose.translation = Eigen::Vector3d::Constant(4.0 * n);
      path.poses.push_back(pose);
    }
    const TriMesh body = makeBall({0, 0, 0}, 2, 3);
    Options options;
    options.resolution = 100;
    RunContext run;
    const double byBox = static_cast<double>(estimate(body, path, options).triangles);
    const double guessed = static_cast<double>(estimateByTrial(body, path, options, run).triangles);
    const Result result = compute(body, path, options, run);
    ASSERT_EQ(result.report.status, Status::Ok);
    const double made = static_cast<double>(result.mesh.triangles.size());
    EXPECT_GT(byBox / made, 6);
    EXPECT_GT(guessed / made, 0.5);
    EXPECT_LT(guessed / made, 3);
  }
}

// With a tolerance, simplification takes most of the time. The finer the cells are, the more it
// takes.
TEST(TrialSteps, SimplificationIsCounted) {
  Trajectory path;
  path.poses = {{}, {1, Eigen::Quaterniond::Identity(), {9, 4, 3}}};
  const TriMesh body = makeBall({0, 0, 0}, 2, 3);
  for (const double offset : {0.0, 0.5}) {
    Options options;
    options.cellSize = 0.1;
    options.offset = offset;
    RunContext run;
    double before = estimateByTrial(body, path, options, run).seconds;
    for (const double cells : {2.0, 0.5, 0.05}) {
      options.tolerance = cells * *options.cellSize;
      const Estimate found = estimateByTrial(body, path, options, run);
      const double least = 2e-6 * static_cast<double>(found.triangles) / 4;  // s
      EXPECT_GT(found.seconds, before + 0.1 * least) << cells;
      before = found.seconds;
    }
  }
}

// A heavy body is sampled along all of its few steps, but only in some clusters. A light one is
// sampled along many steps, in windows, and one body is sampled completely.
TEST(TrialSteps, CrossingsThatAreSortedAreCountedFromParts) {
  struct Kind {
    TriMesh body;
    Trajectory path;
    int resolution;
    bool whole;
  };
  for (const Kind& kind : {Kind{makeTorus(20, 8, 600, 160), bow(30, 60, 1.5, 0), 64, false},
                           Kind{makeTorus(20, 8, 160, 60), bow(600, 300, 3, 0.3), 64, false},
                           Kind{makeTorus(20, 8, 40, 20), bow(30, 60, 1.5, 0), 40, true}}) {
    SCOPED_TRACE(kind.body.triangles.size());
    Planned planned(kind.body, kind.path, kind.resolution);
    const SamplerInput input = planned.input();
    const SamplingTrial trial(input, planned.run);
    const SamplingTrial::Whole whole = trial.whole();
    EXPECT_EQ(whole.marked.has_value(), kind.whole);
    SamplerInput sampled = planned.input();
    std::uint64_t sorted = 0;
    sampled.crossings = &sorted;
    sampleCpu(sampled, planned.run);
    const double ratio = whole.cost.crossings / static_cast<double>(sorted);
    EXPECT_GT(ratio, kind.whole ? 0.999 : 0.67);
    EXPECT_LT(ratio, kind.whole ? 1.001 : 1.5);
  }
}

// The estimate of the memory during sampling. A work item keeps all its crossings until it has
// kMinThinRecords of them. Only then does it remove those that cannot matter. So below this number
// per item, all crossings count; above it, only few. Both kinds of interpolation are tested,
// because Interpolation::None has more work items.
TEST(TrialSteps, CrossingsAreHeldWhereNoItemHasMany) {
  const TriMesh body = makeBox({0, 0, 0}, {10, 10, 10});
  Trajectory path = bow(20000, 60, 0, 0.3);  // noise, so that no steps are merged
  for (const Interpolation interpolation : {Interpolation::None, Interpolation::Linear}) {
    path.interpolation = interpolation;
    Planned planned(body, path, 24);
    SamplerInput input = planned.input();
    const SamplingTrial trial(input, planned.run);
    const auto inside = findDeepInside(input, planned.run);
    input.inside = inside ? &*inside : nullptr;
    const double items = static_cast<double>(workItems(input).size());
    const double most = items * kMinThinRecords, surface = 1e4;
    const bool many = items > 1.2 * kMotionItems;
    EXPECT_TRUE(many || interpolation == Interpolation::Linear) << items;
    const auto bytes = [&](double crossings) {
      return trial.bytesOf({0, crossings, 0}, surface, 1);
    };
    EXPECT_GT(bytes(0.99 * most) / most, 15);
    EXPECT_LT(bytes(1.01 * most) / most, 3);
    EXPECT_GT(bytes(20 * most), items * surface);
  }
}

TEST(TrialSteps, SomeClustersStandForAll) {
  Planned planned(makeTorus(20, 8, 300, 80), bow(6, 60, 1.5, 0), 64);
  SamplerInput input = planned.input();
  std::uint64_t all = 0, part = 0;
  input.crossings = &all;
  sampleCpu(input, planned.run);
  input.crossings = &part;
  input.clusterParts = 4;
  sampleCpu(input, planned.run);
  double faces = 0;
  for (const ShownCluster& s : allClusters(planned.clusters, 4)) {
    faces += planned.clusters.clusters[s.cluster].faceCount;
  }
  const double fraction = faces / static_cast<double>(planned.p.body.mesh.triangles.size());
  EXPECT_NEAR(fraction, 0.25, 0.05);
  EXPECT_NEAR(static_cast<double>(part) / static_cast<double>(all), fraction, 0.25 * fraction);
  input.clusterParts = 0;
  sampleCpu(input, planned.run);
  EXPECT_EQ(part, 0u);
}

// Recordings with noise. Contouring a smooth motion through 192 of their placements needs only a
// third of the probes.
TEST(TrialSteps, ProbesOfContouringAreCountedInCellsOfTheWholeMotion) {
  struct Kind {
    TriMesh body;
    Trajectory path;
    int resolution;
  };
  for (const Kind& kind : {Kind{makeBox({0, 0, 0}, {10, 8, 3}), bow(6000, 400, 20, 0.05), 48},
                           Kind{makeTorus(10, 4, 24, 12), bow(3000, 40, 2, 0.03), 32}}) {
    SCOPED_TRACE(kind.body.triangles.size());
    Planned planned(kind.body, kind.path, kind.resolution);
    const Counted run = counted(planned);
    const RoughSurface surface = roughSurface(planned.input(), RoughLimits(), std::nullopt,
                                              Options().components, planned.run);
    EXPECT_NEAR(surface.crossings / run.crossings, 1, 0.1);
    ASSERT_GT(run.casts, 40);
    EXPECT_GT(surface.probes.casts / run.casts, 0.5);
    EXPECT_LT(surface.probes.casts / run.casts, 2);
  }
}

// With little memory, the grid is coarser; the estimated surface is nearly the same.
TEST(TrialSteps, LargerCellsTellTheSurfaceToo) {
  Planned planned(makeTorus(20, 8, 120, 60), bow(60, 80, 1.5, 0), 120);
  const Counted run = counted(planned);
  const auto guessed = [&](const RoughLimits& room) {
    return roughSurface(planned.input(), room, std::nullopt, Options().components, planned.run)
        .crossings;
  };
  const double all = guessed({1e9, 1e9, 1e9});
  EXPECT_NEAR(all, run.crossings, 0.01 * run.crossings);
  const double faces = static_cast<double>(planned.p.body.mesh.triangles.size());
  for (const RoughLimits& room :
       {RoughLimits{1e9, run.sorted / 30, 1e9}, RoughLimits{1e9, 1e9, 20 * faces}}) {
    EXPECT_NE(guessed(room), all);
    EXPECT_NEAR(guessed(room), run.crossings, 0.2 * run.crossings);
  }
}

}  // namespace
}  // namespace swept::test
