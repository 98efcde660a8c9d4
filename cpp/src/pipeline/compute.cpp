// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/compute.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <sstream>
#include <thread>

#include "base/memory.h"
#include "base/timer.h"
#include "check/mesh_check.h"
#include "check/self_intersections.h"
#include "contour/surface.h"
#include "input/body_check.h"
#include "input/trajectory_check.h"
#include "pipeline/backend.h"
#include "pipeline/finish_surface.h"
#include "pipeline/grown_sweep.h"
#include "pipeline/guarded.h"
#include "pipeline/pilot.h"
#include "pipeline/plan.h"
#include "pipeline/require_passed.h"
#include "sampling/body_topology.h"
#include "sampling/cavities.h"
#include "sampling/cpu/sample_cache.h"
#include "sampling/element_probe.h"
#include "sampling/face_clusters.h"
#include "sampling/hermite.h"
#include "sampling/sampler.h"
#include "simplify/feature_edges.h"
#include "simplify/simplify.h"
#include "swept/preview.h"

namespace swept {
namespace {

/// Copies of triangles up to which an offset is measured from the copies themselves.
constexpr std::size_t kMostCopies = 8'000'000;

void add(std::vector<Finding>& to, const std::vector<Finding>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Fills the result from its kept surface, simplified within `tolerance` (0: as it is).
void cutKept(Result& result, double tolerance, RunContext& run) {
  const SimplifyTree& kept = *result.kept;
  Report& report = result.report;
  if (tolerance > 0) {
    Simplified cut = kept.cut(
        tolerance, [&](const TriMesh& m) { return findSelfIntersections(m, {}, run).pairs; }, run);
    result.mesh = std::move(cut.mesh);
    result.contactTime = std::move(cut.contactTime);
    result.featureEdges = std::move(cut.featureEdges);
    report.simplificationDeviation = cut.deviation;
  } else {
    result.mesh = kept.mesh();
    result.contactTime = kept.contactTime();
    result.featureEdges = kept.featureEdges();
    report.simplificationDeviation = 0;
  }
  report.check = checkMesh(result.mesh, run);
  requirePassed(report.check, "the simplified envelope", report.cellSize);
}

/// What a preview session keeps between calls.
struct WarmBody {
  CheckedBody body;
  BodyTopology topology;
  FaceClusters clusters;
  std::optional<GridPlan> grid;
  SampleCache cache;
};

class Run {
 public:
  Run(const Options& options, RunContext& context, Result& result)
      : options_(options), run_(context), result_(result), report_(result.report) {}

  void compute(const TriMesh& body, const Trajectory& trajectory) {
    begin();
    prepared_.body = checkBody(body, options_, run_);
    sweep(trajectory);
  }

  /// The same for a body that has been checked before. `sketch`: the surface as contoured.
  void compute(WarmBody& warm, const Trajectory& trajectory, bool sketch) {
    begin();
    sketch_ = sketch;
    prepared_.body = warm.body;
    prepared_.keepRoom = true;
    if (warm.grid) prepared_.lastGrid = &*warm.grid;
    topologyOfBody_ = &warm.topology;
    clusters_ = &warm.clusters;
    cache_ = &warm.cache;
    sweep(trajectory);
    warm.grid = prepared_.grid;
  }

 private:
  void begin() {
    checkOptions(options_);
    refuseCombinations();
    run_.checkpoint(Phase::Input);
  }

  void sweep(const Trajectory& trajectory) {
    prepareTrajectory(prepared_, trajectory, options_);
    add(report_.warnings, prepared_.body.findings);
    add(report_.warnings, prepared_.trajectory.findings);
    stage("input");

    planRun(prepared_, options_, run_);
    describePlan();
    BodyTopology own;
    if (topologyOfBody_ == nullptr) own = buildTopology(prepared_.body.mesh);
    const BodyTopology& topology = topologyOfBody_ != nullptr ? *topologyOfBody_ : own;
    Estimate e = estimateOf(prepared_, options_);
    if (!fitsMemory(e, run_, 2)) e = estimateByPilot(e, prepared_, topology, options_, run_);
    report_.estimatedMemoryBytes = e.memoryBytes;
    cpuSeconds_ = e.seconds;
    requireMemory(e, run_);
    stage("motion");

    if (options_.offset > 0 || options_.conservative) {
      grow(topology);
    } else {
      envelope(topology);
      simplify();
    }
    if (options_.tolerance <= 0 && !sketch_) {
      result_.featureEdges = topology_.across.size() > 0
                                 ? findFeatureEdges(result_.mesh, topology_.across)
                                 : findFeatureEdges(result_.mesh);
    }
    stage("features");
  }

  void refuseCombinations() const {
    if (!(options_.positionFilter > 0) || !options_.conservative) return;
    throw Error(
        Status::InvalidInput, "BadOption",
        "a conservative envelope holds every pose: it cannot be had with a position filter; "
        "leave one of them out");
  }
  void stage(const char* name) { report_.seconds.push_back({name, timer_.lap()}); }

  void describePlan() {
    report_.cellSize = prepared_.grid.cell;
    report_.gridOrigin = prepared_.grid.origin;
    report_.grid = prepared_.grid.cells();
    report_.placements = static_cast<std::int64_t>(prepared_.givenPoses);
    report_.positionFilterDistance = prepared_.positionFilterDistance;
    report_.refinedPlacements = static_cast<std::int64_t>(prepared_.motion.placements.size());
    report_.largestStepTravel = prepared_.motion.largestStepTravel;
    report_.chordError = prepared_.motion.chordError;
  }

  SamplerInput samplerInput(const BodyTopology& topology, bool cull) const {
    return {prepared_.body.mesh, topology, prepared_.motion,
            prepared_.grid,      cull,     prepared_.body.orientable,
            clusters_,           cache_};
  }

  /// The swept volume as it is: result_.mesh.
  void envelope(const BodyTopology& topology) {
    const SamplerInput input = samplerInput(topology, options_.cull);
    HermiteGrid hermite = sample(topology, options_.cull);
    // In a preview the ends of thin walls are not worth the time that looking for them takes.
    std::optional<ElementProbe> probe;
    if (cache_ == nullptr) probe.emplace(input, elements_, hermite.winner);
    Surface surface = contourUniform(hermite, options_, run_, probe ? &*probe : nullptr);
    std::vector<SweptElement>().swap(elements_);
    std::vector<std::uint32_t>().swap(hermite.winner);
    stage("contour");
    finish(std::move(surface), hermite);
  }

  void finish(Surface surface, const HermiteGrid& hermite) {
    if (sketch_) {
      report_.warnings.push_back(
          {"NotChecked", 1, {}, "a sketch to be drawn: it was neither mended nor checked"});
    } else {
      const Finishing with{options_, prepared_, run_, [&](const char* name) { stage(name); }};
      topology_ = checkAndMend(surface, hermite, with, report_);
    }
    result_.mesh = std::move(surface.mesh);
    result_.contactTime = std::move(surface.contactTime);
  }

  /// The swept volume grown by the safety distance, or so far that it is proven to be held.
  void grow(const BodyTopology& topology) {
    const SamplerInput input = samplerInput(topology, options_.cull);
    const double cell = prepared_.grid.cell, wanted = options_.offset / cell;
    const bool fromMesh = offset::copiesOf(input) > kMostCopies;
    if (fromMesh && options_.conservative) {
      throw Error(Status::ResourceLimit, "TooManyCopies",
                  "a conservative envelope of a union of copies looks at every triangle of every "
                  "copy: " +
                      std::to_string(offset::copiesOf(input)) + " here, the limit is " +
                      std::to_string(kMostCopies) +
                      "; use fewer poses or a coarser body, or interpolate between poses");
    }
    if (fromMesh) envelope(topology);
    const GrownSweep sweep(
        fromMesh ? offset::coverOfMesh(result_.mesh, result_.contactTime, prepared_.grid)
                 : offset::coverOfMotion(input, options_.conservative, run_),
        prepared_.grid);
    stage("cover");
    if (!options_.conservative) {
      report_.warnings.push_back(offsetFinding(sweep.cover(), fromMesh));
      growTo(sweep, input, wanted);
      return;
    }
    const double chord = sweep.cover().chord;
    offset::Containment proof;
    for (const double margin : kMarginCells) {
      growTo(sweep, input, wanted + margin + options_.tolerance / cell);
      proof = sweep.prove(result_.mesh, wanted + chord, run_);
      stage("proof");
      if (!proof.holds) continue;
      report_.conservativeBound = (proof.farthest + chord - wanted) * cell;
      report_.warnings.push_back(conservativeFinding(proof, sweep.cover()));
      result_.kept.reset();  // another tolerance would need a proof of its own
      return;
    }
    throw Error(Status::InternalError, "NotProven",
                "the surface could not be proven to hold the swept volume: " +
                    std::to_string(proof.tooNear) + " triangles too near, " +
                    std::to_string(proof.outside) + " pieces outside; use a smaller cell");
  }

  void growTo(const GrownSweep& sweep, const SamplerInput& input, double distance) {
    HermiteGrid hermite = sweep.hermite(
        distance,
        [&](const MarkedEdges& marks, const SolidPoint& isSolid) {
          return signs(input, marks, isSolid);
        },
        run_);
    stage("offset");
    report_.crossings = static_cast<std::int64_t>(hermite.crossings.size());
    requireCrossings(hermite);
    Surface surface = contourUniform(hermite, options_, run_);
    stage("contour");
    finish(std::move(surface), hermite);
    hermite = HermiteGrid{};
    simplify();
  }

  Finding offsetFinding(const offset::Cover& cover, bool fromMesh) const {
    std::ostringstream text;
    text.precision(4);
    text << "grown by " << options_.offset << " mm, measured from " << cover.triangles.size();
    if (fromMesh) {
      text << " triangles of the envelope: how far that leaves the true one adds to the deviation";
    } else {
      text << " triangles of the body in motion, which lie within "
           << (cover.largestSlack + cover.chord) * report_.cellSize << " mm of the swept volume";
    }
    return {"Offset", static_cast<std::int64_t>(cover.triangles.size()), {}, text.str()};
  }

  Finding conservativeFinding(const offset::Containment& proof, const offset::Cover& cover) const {
    const double cell = report_.cellSize;
    std::ostringstream text;
    text.precision(4);
    text << "the envelope holds the swept volume";
    if (options_.offset > 0) text << " grown by " << options_.offset << " mm";
    text << ": no point of it is nearer than " << proof.nearest * cell
         << " mm to the sampled motion, which the true one leaves by at most " << cover.chord * cell
         << " mm; no point lies more than " << report_.conservativeBound << " mm outside";
    return {"Conservative", static_cast<std::int64_t>(cover.triangles.size()), {}, text.str()};
  }

  HermiteGrid sample(const BodyTopology& topology, bool cull) {
    const SamplerInput input = samplerInput(topology, cull);
    SampledSurface sampled = sampleSurface(
        input, options_.backend, cpuSeconds_,
        [&](const MarkedEdges& marks) {
          stage("sampling");
          SignRuns found = signs(input, marks, {});
          stage("signs");
          return found;
        },
        run_);
    MarkedEdges& marked = sampled.marked;
    const SignRuns& signs = sampled.signs;
    if (sampled.backend == "gpu") stage("winners");
    report_.backend = sampled.backend;
    report_.device = sampled.device;
    add(report_.warnings, sampled.notes);
    report_.sweptFaces = report_.sweptPatches = 0;
    for (const SweptElement& element : marked.elements) {
      ++(element.isPatch() ? report_.sweptPatches : report_.sweptFaces);
    }
    HermiteGrid hermite = buildHermiteGrid(input, marked, signs, run_);
    elements_ = std::move(marked.elements);
    stage("crossings");
    report_.crossings = static_cast<std::int64_t>(hermite.crossings.size());
    requireEnclosed(hermite);
    return hermite;
  }

  /// The outside, and where cavities are kept the hollow spaces that it does not reach.
  SignRuns signs(const SamplerInput& input, const MarkedEdges& marks, const SolidPoint& isSolid) {
    if (!options_.keepCavities) return findOutside(marks, prepared_.grid, run_);
    const auto note = [&](const char* code, std::int64_t count, const std::string& text) {
      auto& notes = report_.warnings;  // signs may be asked for again
      notes.erase(std::remove_if(notes.begin(), notes.end(),
                                 [&](const Finding& f) { return f.code == code; }),
                  notes.end());
      notes.push_back({code, count, {}, text});
    };
    if (!prepared_.body.closed) {
      note("CavitiesFilled", 1,
           "the body is open, so inside has no meaning: sealed-off hollow spaces are filled; close "
           "its holes to keep them");
      return findOutside(marks, prepared_.grid, run_);
    }
    std::vector<std::uint32_t> component;
    SignRuns found = findOutside(marks, prepared_.grid, run_, &component);
    const std::int64_t opened = openCavities(found, component, marks, input, isSolid, run_);
    note("CavitiesKept", opened,
         std::to_string(opened) + " sealed-off hollow spaces are kept as inner shells");
    return found;
  }

  static void requireCrossings(const HermiteGrid& hermite) {
    if (!hermite.crossings.empty()) return;
    throw Error(Status::InvalidInput, "CellTooLarge",
                "no line of the grid meets the body: it is thinner than the cell everywhere; use a "
                "smaller cell");
  }

  /// The outside must not reach in through an open body, and there must be something to contour.
  void requireEnclosed(const HermiteGrid& hermite) {
    requireCrossings(hermite);
    const auto crossings = static_cast<std::int64_t>(hermite.crossings.size());
    if (prepared_.body.closed || hermite.sheetEdges == 0) return;
    const double share =
        2.0 * static_cast<double>(hermite.sheetEdges) / static_cast<double>(crossings);
    const bool still = !prepared_.motion.continuous;
    std::ostringstream text;
    text.precision(3);
    text << "the body is open and " << 100 * share
         << " % of the surface has the outside on both sides";
    if (still && share > 0.01) {
      throw Error(Status::InvalidInput, "OpenMesh",
                  text.str() + "; close its holes, or move it so that the sweep closes it");
    }
    report_.warnings.push_back({"OpenSheets",
                                hermite.sheetEdges,
                                {},
                                text.str() + "; these sheets get a thickness of 0.002 cell"});
  }

  void simplify() {
    if (options_.tolerance <= 0) return;
    topology_ = MeshTopology{};
    if (!report_.check.passes()) {
      report_.warnings.push_back(
          {"NotSimplified",
           1,
           {},
           "the surface is not a closed manifold and stays as it is; use the "
           "consistent components to simplify it"});
      result_.featureEdges = findFeatureEdges(result_.mesh);
      return;
    }
    result_.kept = std::make_shared<const SimplifyTree>(
        std::move(result_.mesh), std::move(result_.contactTime), prepared_.grid, run_);
    cutKept(result_, options_.tolerance, run_);
    stage("simplify");
  }

  const Options& options_;
  RunContext& run_;
  Result& result_;
  Report& report_;
  Prepared prepared_;
  const BodyTopology* topologyOfBody_ = nullptr;  ///< null: not known yet
  const FaceClusters* clusters_ = nullptr;
  SampleCache* cache_ = nullptr;
  bool sketch_ = false;
  MeshTopology topology_;  ///< of the mended surface, if it was checked without its pairs
  std::vector<SweptElement> elements_;  // while the contouring may ask for them
  Timer timer_;
  double cpuSeconds_ = 0;
};

/// Threads that a run may use.
int threadsOf(const RunContext& run) {
  if (run.threads > 0) return run.threads;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// What becomes of the memory that a run has freed: a session's next run takes it again.
enum class Freed : std::uint8_t { Returned, Kept };

/// Runs work(run) in an arena of the wanted number of threads and puts how it went in the report.
template <class Work>
Result runWith(const Options& options, RunContext& run, Freed freed, const Work& work) {
  Result result;
  const Timer total;
  const int threads = threadsOf(run);
  result.report.threads = threads;
  guarded(result, [&] {
    resetPeakMemory();
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(threads);
    arena.execute([&] {
      Run one(options, run, result);
      work(one);
    });
    run.checkpoint(Phase::Done);
  });
  const auto close = [&] {
    result.report.seconds.push_back({"total", total.seconds()});
    result.report.peakMemoryBytes = peakMemoryBytes();
    if (freed == Freed::Returned) returnFreeMemory();
  };
  if (result.report.status == Status::Ok) {
    guarded(result, close);
  } else {
    try {
      close();
    } catch (const std::bad_alloc&) {  // the failure is told already, only its figures are missing
    }
  }
  return result;
}

}  // namespace

Result compute(const TriMesh& body, const Trajectory& trajectory, const Options& options,
               RunContext& run) {
  return runWith(options, run, Freed::Returned, [&](Run& one) { one.compute(body, trajectory); });
}

struct PreviewSession::Warm : WarmBody {
  Options options;
};

PreviewSession::PreviewSession(const TriMesh& body, const Options& options, RunContext& run) {
  auto warm = std::make_unique<Warm>();
  warm->options = options;
  warm->options.chordTolerance = std::max(options.chordTolerance, kPreviewChord);
  warm->options.tolerance = 0;
  checkOptions(warm->options);
  warm->body = checkBody(body, warm->options, run);
  warm->topology = buildTopology(warm->body.mesh);
  warm->clusters = buildClusters(warm->body.mesh, warm->topology);
  warm_ = std::move(warm);
}
PreviewSession::~PreviewSession() {
  if (warm_ == nullptr) return;  // moved from
  warm_.reset();
  returnFreeMemory();
}
PreviewSession::PreviewSession(PreviewSession&&) noexcept = default;
PreviewSession& PreviewSession::operator=(PreviewSession&&) noexcept = default;

Result PreviewSession::compute(const Trajectory& trajectory, RunContext& run) {
  return runWith(warm_->options, run, Freed::Kept,
                 [&](Run& one) { one.compute(*warm_, trajectory, false); });
}

Result PreviewSession::sketch(const Trajectory& trajectory, RunContext& run) {
  if (warm_->options.conservative) {
    throw Error(Status::InvalidInput, "BadOption",
                "a conservative envelope is proven, which a sketch is not: compute it");
  }
  return runWith(warm_->options, run, Freed::Kept,
                 [&](Run& one) { one.compute(*warm_, trajectory, true); });
}

std::int64_t PreviewSession::stepsKept() const { return warm_->cache.hits(); }

void recut(Result& result, double tolerance, RunContext& run) {
  if (!(tolerance >= 0)) {
    throw Error(Status::InvalidInput, "BadOption",
                "tolerance is " + std::to_string(tolerance) + " mm, must be 0 or more");
  }
  if (!result.kept) {
    throw Error(Status::InvalidInput, "NothingKept",
                "the envelope was made without a simplification tolerance; compute it again");
  }
  Result next;
  next.kept = result.kept;
  next.report = result.report;
  const int threads = threadsOf(run);
  tbb::task_arena arena(threads);
  arena.execute([&] { cutKept(next, tolerance, run); });
  result = std::move(next);
}

}  // namespace swept
