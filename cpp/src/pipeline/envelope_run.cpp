// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/envelope_run.h"

#include "base/fault_text.h"
#include "base/number_text.h"
#include "crossings/crossing_sources.h"
#include "crossings/element_probe.h"
#include "crossings/hermite.h"
#include "input/body_check.h"
#include "input/options_check.h"
#include "motion/pivot.h"
#include "pipeline/backend.h"
#include "pipeline/enclosure.h"
#include "pipeline/finish_surface.h"
#include "pipeline/kept_surface.h"
#include "pipeline/pilot.h"
#include "simplify/feature_edges.h"
#include "simplify/simplify.h"

namespace swept {
namespace {

/// Up to this number of copies of triangles (each triangle of the body at each placement), an
/// offset is measured from these copies. Above it, the offset is measured from the mesh of an
/// envelope without offset.
constexpr std::size_t kMaxCopies = 8'000'000;

void add(std::vector<Finding>& to, const std::vector<Finding>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

void WarmBody::setBody(CheckedBody checked) {
  body = std::move(checked);
  topology = buildTopology(body.mesh);
  clusters = buildClusters(body.mesh, topology);
  cache.clear();
}

void WarmBody::setPivot(const Eigen::Vector3d& wanted) {
  if (wanted == pivot) return;
  CheckedBody moved = body;
  moved.mesh = seenFromPivot(std::move(moved.mesh), wanted - pivot);
  setBody(std::move(moved));
  pivot = wanted;
  grid.reset();
}

void EnvelopeRun::compute(const TriMesh& body, const Trajectory& trajectory) {
  begin();
  prepared_.pivot = pivotOf(trajectory);
  prepared_.body = prepared_.pivot.isZero(0)
                       ? checkBody(body, options_, run_)
                       : checkBody(seenFromPivot(body, prepared_.pivot), options_, run_);
  sweep(trajectory);
}

void EnvelopeRun::compute(WarmBody& warm, const Trajectory& trajectory, bool sketch) {
  begin();
  sketch_ = sketch;
  prepared_.pivot = pivotOf(trajectory);
  warm.setPivot(prepared_.pivot);
  prepared_.body = warm.body;
  prepared_.keepRoom = true;
  if (warm.grid) prepared_.lastGrid = &*warm.grid;
  warm_ = &warm;
  sweep(trajectory);
  warm.grid = prepared_.grid;
}

void EnvelopeRun::begin() {
  checkOptions(options_);
  refuseCombinations();
  run_.checkpoint(Phase::Input);
}

void EnvelopeRun::sweep(const Trajectory& trajectory) {
  prepareTrajectory(prepared_, trajectory, options_);
  add(report_.warnings, prepared_.body.findings);
  add(report_.warnings, prepared_.trajectory.findings);
  stage("input");

  planRun(prepared_, options_, run_);
  describePlan();
  adviseFilter();
  if (warm_ != nullptr && prepared_.body.mesh.triangles != warm_->body.mesh.triangles) {
    warm_->setBody(prepared_.body);  // the long edges of the body have been split
  }
  BodyTopology own;
  if (warm_ == nullptr) own = buildTopology(prepared_.body.mesh);
  const BodyTopology& topology = warm_ != nullptr ? warm_->topology : own;
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
    result_.featureEdges = topology_.adjacency.across.size() > 0
                               ? findFeatureEdges(result_.mesh, topology_.adjacency.across)
                               : findFeatureEdges(result_.mesh);
  }
  stage("features");
}

void EnvelopeRun::refuseCombinations() const {
  if (options_.sources && (options_.offset > 0 || options_.conservative)) {
    throw Error(Status::InvalidInput, "BadOption",
                "sources cannot be recorded for an envelope that has an offset or is conservative; "
                "leave out the sources, or both the offset and conservative");
  }
  if (!(options_.positionFilter > 0) || !options_.conservative) return;
  throw Error(Status::InvalidInput, "BadOption",
              "a conservative envelope must contain every pose, so it cannot be combined with a "
              "position filter; leave out one of them");
}

void EnvelopeRun::describePlan() {
  report_.cellSize = prepared_.grid.cell;
  report_.gridOrigin = prepared_.grid.origin;
  report_.grid = prepared_.grid.cells();
  report_.placements = static_cast<std::int64_t>(prepared_.givenPoses);
  report_.positionFilterDistance = prepared_.positionFilterDistance;
  report_.refinedPlacements = static_cast<std::int64_t>(prepared_.motion.placements.size());
  report_.largestStepTravel = prepared_.motion.largestStepTravel;
  report_.chordError = prepared_.motion.chordError;
  report_.bodyDeviation = prepared_.bodyDeviation;
  if (!sketch_ && exceedsChord(prepared_, report_.cellSize, options_)) {
    report_.warnings.push_back(
        {"ChordCapped",
         1,
         {},
         "the computed motion deviates from the true one by up to " +
             numberText(report_.chordError, 3) + " mm (" +
             numberText(report_.chordError / report_.cellSize, 2) + " cells) instead of " +
             numberText(allowedChord(prepared_, options_, report_.cellSize), 3) +
             " mm, because more placements between the poses would need too much memory; raise the "
             "memory limit, use a part with fewer triangles, or set a larger chord tolerance"});
  }
}

void EnvelopeRun::adviseFilter() {
  if (warm_ != nullptr) return;
  const std::optional<double> distance = usefulFilterOf(prepared_, options_);
  if (!distance) return;
  report_.warnings.push_back({"FilterUseful",
                              1,
                              {},
                              "a position filter of " + numberText(*distance, 3) +
                                  " mm would skip most poses and save most of the time; it would "
                                  "change the envelope by no more than the chord error"});
}

SamplerInput EnvelopeRun::samplerInput(const BodyTopology& topology, bool cull) const {
  return {prepared_.body.mesh,
          topology,
          prepared_.motion,
          prepared_.grid,
          cull,
          prepared_.body.orientable,
          warm_ != nullptr ? &warm_->clusters : nullptr,
          warm_ != nullptr ? &warm_->cache : nullptr,
          nullptr,
          !options_.keepCavities};
}

void EnvelopeRun::envelope(const BodyTopology& topology) {
  const SamplerInput input = samplerInput(topology, options_.cull);
  HermiteGrid hermite = sample(topology, options_.cull);
  // A preview does without the probe, which finds the ends of thin walls but takes time.
  std::optional<ElementProbe> probe;
  if (warm_ == nullptr) probe.emplace(input, elements_, hermite.winner, hermite);
  Surface surface = contourUniform(hermite, options_, run_, probe ? &*probe : nullptr);
  if (options_.sources) {
    result_.sources.rows = std::make_shared<const std::vector<SurfaceSource>>(
        sourcesOfCrossings(input, elements_, hermite, prepared_.body.namedFaces,
                           prepared_.trajectory.trajectory, prepared_.trajectory.given));
    std::vector<double>().swap(hermite.exactSeconds);
  }
  std::vector<SweptElement>().swap(elements_);
  std::vector<std::uint32_t>().swap(hermite.winner);
  stage("contour");
  finish(std::move(surface), hermite);
}

void EnvelopeRun::finish(Surface surface, const HermiteGrid& hermite, SettlingMoves settlingMoves) {
  requireSurface(surface.mesh, prepared_, run_);
  if (sketch_) {
    report_.warnings.push_back({"NotChecked",
                                1,
                                {},
                                "this surface is a preview, which was neither repaired nor "
                                "checked; compute the envelope before you use it"});
  } else {
    const Finishing with{options_, prepared_, run_, [&](const char* name) { stage(name); },
                         std::move(settlingMoves)};
    topology_ = checkAndMend(surface, hermite, with, report_);
  }
  result_.mesh = std::move(surface.mesh);
  result_.contactTime = std::move(surface.contactTime);
  static_assert(Surface::kNoCrossing == Sources::kNone);
  if (options_.sources) result_.sources.of = std::move(surface.crossingOf);
}

void EnvelopeRun::grow(const BodyTopology& topology) {
  const SamplerInput input = samplerInput(topology, options_.cull);
  const double cell = prepared_.grid.cell, wanted = options_.offset / cell;
  const bool fromMesh = offset::triangleCopies(input) > kMaxCopies;
  if (fromMesh && options_.conservative) {
    throw Error(Status::ResourceLimit, "TooManyCopies",
                "a conservative envelope of a motion with interpolation none must look at every "
                "triangle of the part at every pose: there are " +
                    std::to_string(offset::triangleCopies(input)) +
                    " such pairs, but the limit is " + std::to_string(kMaxCopies) +
                    "; use fewer poses, a part with fewer triangles, or another interpolation");
  }
  if (fromMesh) envelope(topology);
  const GrownSweep sweep(
      fromMesh ? offset::coverOfMesh(result_.mesh, result_.contactTime, prepared_.grid)
               : offset::coverOfMotion(input, options_.conservative, run_),
      prepared_.grid);
  stage("cover");
  if (!options_.conservative) {
    report_.warnings.push_back(sweep.offsetFinding(options_.offset, fromMesh));
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
    report_.warnings.push_back(
        sweep.conservativeFinding(proof, options_.offset, *report_.conservativeBound));
    result_.kept.reset();  // dropped: with another tolerance, the envelope would need its own proof
    return;
  }
  throw Error(
      Status::InternalError, "NotProven",
      "it could not be proven that the envelope contains the swept volume: " +
          std::to_string(proof.tooNear) + " triangles are too close to the swept volume, and " +
          std::to_string(proof.outside) + " pieces of the swept volume lie outside the envelope" +
          faultText("the part, the motion and the options") +
          textOf(3, ". A smaller cell may avoid the fault: try ", 0.9 * cell, " mm instead of ",
                 cell, " mm"));
}

void EnvelopeRun::growTo(const GrownSweep& sweep, const SamplerInput& input, double distance) {
  HermiteGrid hermite = sweep.hermite(
      distance,
      [&](const MarkedEdges& marks, const SolidPoint& isSolid) {
        return findSigns(input, marks, isSolid, prepared_, options_.keepCavities, report_, run_);
      },
      run_);
  stage("offset");
  report_.crossings = static_cast<std::int64_t>(hermite.crossings.size());
  requireCrossings(hermite, prepared_, run_);
  Surface surface = contourUniform(hermite, options_, run_);
  stage("contour");
  SettlingMoves settlingMoves;
  if (!options_.conservative) {  // a conservative envelope has a margin instead
    settlingMoves = [&](const TriMesh& mesh, const std::vector<std::int32_t>& vertices) {
      return sweep.settlingMoves(mesh, vertices, distance, run_);
    };
  }
  finish(std::move(surface), hermite, std::move(settlingMoves));
  hermite = HermiteGrid{};
  simplify();
}

HermiteGrid EnvelopeRun::sample(const BodyTopology& topology, bool cull) {
  const SamplerInput input = samplerInput(topology, cull);
  SampledSurface sampled = sampleSurface(
      input, options_.backend, cpuSeconds_,
      [&](const MarkedEdges& marks) {
        stage("sampling");
        SignRuns found =
            findSigns(input, marks, {}, prepared_, options_.keepCavities, report_, run_);
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
    ++(element.isSidePatch() ? report_.sweptPatches : report_.sweptFaces);
  }
  HermiteGrid hermite = buildHermiteGrid(
      input, marked, signs, options_.sources ? ExactTimes::Kept : ExactTimes::Dropped, run_);
  elements_ = std::move(marked.elements);
  stage("crossings");
  report_.crossings = static_cast<std::int64_t>(hermite.crossings.size());
  requireEnclosed(hermite, prepared_, report_, run_);
  return hermite;
}

void EnvelopeRun::simplify() {
  if (options_.tolerance <= 0) return;
  topology_ = MeshTopology{};
  if (!report_.check.passes()) {
    report_.warnings.push_back({"NotSimplified",
                                1,
                                {},
                                "the surface is not a closed manifold and was not simplified; set "
                                "the option components to consistent to simplify it"});
    result_.featureEdges = findFeatureEdges(result_.mesh);
    return;
  }
  result_.kept =
      std::make_shared<const Simplifier>(std::move(result_.mesh), std::move(result_.contactTime),
                                         prepared_.grid.cell, std::move(result_.sources));
  cutKept(result_, options_.tolerance, run_);
  stage("simplify");
}

}  // namespace swept
