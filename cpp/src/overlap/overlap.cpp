// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/overlap.h"

#include <atomic>
#include <memory>
#include <set>

#include "base/number_text.h"
#include "base/parallel.h"
#include "base/timer.h"
#include "clearance/guarded_report.h"
#include "clearance/options_check.h"
#include "clearance/pair_check.h"
#include "clearance/summary.h"
#include "overlap/combine.h"
#include "overlap/solid_of.h"

namespace swept {
namespace {

using namespace clearance;

void checkInput(const std::vector<OverlapPart>& parts, const ClearanceOptions& options) {
  checkSettings(options);
  if (parts.size() < 2)
    throw Error(Status::InvalidInput, "NoParts",
                std::string(parts.empty() ? "no part is given" : "only one part is given") +
                    "; give at least two to be compared");
  std::set<std::string> names;
  for (const OverlapPart& part : parts) {
    requireLength("part '" + part.name + "': mesh deflection (chord error)", part.chordError, true);
    if (!names.insert(part.name).second)
      throw Error(Status::InvalidInput, "PartTwice",
                  "two parts have the name '" + part.name + "'; give each a name of its own");
  }
}

std::string quotedName(const OverlapPart& part) { return "part '" + part.name + "'"; }

class OverlapCheck {
 public:
  OverlapCheck(OverlapReport& report, const std::vector<OverlapPart>& parts,
               const OverlapOptions& options, RunContext& run)
      : report_(report), parts_(parts), sharesVolumes_(options.shared), run_(run) {
    options_.required = options.required;
    options_.tolerance = options.tolerance;
    options_.curveSamples = 0;
    options_.penetration = false;  // saves time; the shared volume gives more information
  }

  void operator()() {
    Timer timer;
    run_.checkpoint(Phase::Input);
    checkInput(parts_, options_);
    prepare();
    report_.seconds.push_back({"prepare", timer.lap()});
    measure();
    report_.seconds.push_back({"search", timer.lap()});
    if (sharesVolumes_) computeSharedVolumes();
    report_.seconds.push_back({"share", timer.lap()});
    summarise();
    report_.seconds.push_back({"total", timer.seconds()});
    run_.checkpoint(Phase::Done);
  }

 private:
  void prepare() {
    prepared_.resize(parts_.size());
    mended_.assign(parts_.size(), 0);
    parallelFor(parts_.size(), [&](std::size_t i) {
      bool mended = false;
      prepared_[i] = std::make_unique<const Part>(
          closedPart(parts_[i].mesh, quotedName(parts_[i]), run_, mended));
      mended_[i] = mended ? 1 : 0;
    });
    std::vector<char> closed;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      report_.names.push_back(parts_[i].name);
      report_.triangles += std::ssize(parts_[i].mesh.triangles);
      closed.push_back(prepared_[i]->closed() ? 1 : 0);
    }
    for (const Finding& finding : openFindings(report_.names, closed, true, "part", "parts"))
      report_.warnings.push_back(finding);
    for (std::int32_t i = 0; i < std::ssize(parts_); ++i)
      for (std::int32_t j = i + 1; j < std::ssize(parts_); ++j)
        report_.pairs.push_back({{i, j}, {}, {}, {}});
  }

  void measure() {
    const Trajectory still{{Pose{}}, Interpolation::None};
    std::atomic<std::uint64_t> done{0};
    parallelFor(report_.pairs.size(), [&](std::size_t p) {
      const auto [i, j] = report_.pairs[p].parts;
      const Part &first = *prepared_[i], &second = *prepared_[j];
      const Box box = first.box(first.tree().root());
      const MotionTree motion(still, box.centre, box.half);
      ClearanceOptions options = options_;
      options.bodyChordError = parts_[i].chordError;
      report_.pairs[p].clearance = checkPair({first, mended_[i] != 0, second, mended_[j] != 0},
                                             {parts_[i].name + " - " + parts_[j].name,
                                              parts_[j].chordError, ruleFor({}, options.required)},
                                             motion, options, run_);
      run_.checkpoint(Phase::Motion, ++done, report_.pairs.size());
    });
  }

  /// Returns whether the surfaces of the two parts meet, or one part contains the other.
  static bool meets(const PairOverlap& pair) {
    return pair.clearance.distance <= 0 || pair.clearance.inside;
  }

  void computeSharedVolumes() {
    std::vector<std::unique_ptr<const TriMesh>> solids(parts_.size());
    std::vector<std::string> refused(parts_.size());
    std::vector<char> needed(parts_.size(), 0);
    for (const PairOverlap& pair : report_.pairs)
      if (meets(pair)) needed[pair.parts.first] = needed[pair.parts.second] = 1;
    parallelFor(parts_.size(), [&](std::size_t i) {
      if (needed[i] == 0) return;
      unlessInvalid(refused[i], [&] {
        solids[i] = std::make_unique<const TriMesh>(
            overlap::solidOf(parts_[i].mesh, quotedName(parts_[i]), run_));
      });
    });
    std::vector<std::string> why(report_.pairs.size());
    std::atomic<std::uint64_t> done{0};
    parallelFor(report_.pairs.size(), [&](std::size_t p) {
      PairOverlap& pair = report_.pairs[p];
      const std::int32_t i = pair.parts.first, j = pair.parts.second;
      if (!meets(pair)) {
        pair.volume = 0;
      } else if (solids[i] == nullptr || solids[j] == nullptr) {
        why[p] = solids[i] == nullptr ? refused[i] : refused[j];
      } else {
        unlessInvalid(why[p], [&] {
          overlap::Combined found =
              overlap::combine(overlap::Keep::Inside, *solids[i], quotedName(parts_[i]), *solids[j],
                               quotedName(parts_[j]), run_);
          judge(pair, found);
          pair.volume = found.volume;
          pair.shared = std::move(found.mesh);
        });
      }
      run_.checkpoint(Phase::Contour, ++done, report_.pairs.size());
    });
    for (std::size_t p = 0; p < why.size(); ++p)
      if (!why[p].empty())
        report_.warnings.push_back({"NoSharedVolume",
                                    1,
                                    {static_cast<std::int64_t>(p)},
                                    report_.pairs[p].clearance.name + ": " + why[p]});
  }

  /// Changes the verdict Contact to Clash if the shared volume is thick enough. If faces of two
  /// solids coincide, the solids can penetrate each other deeply although no point of one surface
  /// lies inside the other solid. The distance search then only finds a contact.
  void judge(PairOverlap& pair, const overlap::Combined& found) const {
    const double touch = options_.tolerance + pair.clearance.chordError;
    if (pair.clearance.verdict == ClearanceVerdict::Contact && found.volume > touch * found.area)
      pair.clearance.verdict = ClearanceVerdict::Clash;
  }

  /// Runs work(). If the input is invalid, stores the message in `why` instead of throwing. So one
  /// invalid part does not hide the results of the others.
  template <class Work>
  static void unlessInvalid(std::string& why, const Work& work) {
    try {
      work();
    } catch (const Error& e) {
      if (e.status() != Status::InvalidInput) throw;
      why = e.what();
    }
  }

  void summarise() {
    std::vector<const NeighbourClearance*> rows;
    double volume = 0;
    for (const PairOverlap& pair : report_.pairs) {
      rows.push_back(&pair.clearance);
      volume += pair.volume.value_or(0);
    }
    const Summary summary =
        summaryOf(rows, counted(std::ssize(rows), "pair") + " checked", 0, Timed::No);
    report_.smallest = summary.smallest;
    report_.summary = summary.text;
    if (volume > 0) report_.summary += ", " + numberText(volume, 6) + " mm^3 shared";
  }

  OverlapReport& report_;
  const std::vector<OverlapPart>& parts_;
  const bool sharesVolumes_;
  ClearanceOptions options_;
  RunContext& run_;
  std::vector<std::unique_ptr<const Part>> prepared_;
  std::vector<char> mended_;
};

void clearResults(OverlapReport& report) {
  report.pairs.clear();
  report.smallest.reset();
  report.summary.clear();
}

}  // namespace

OverlapReport checkOverlaps(const std::vector<OverlapPart>& parts, const OverlapOptions& options,
                            RunContext& run) {
  OverlapReport report;
  report.required = options.required;
  report.tolerance = options.tolerance;
  fillGuarded(report, run, "comparison", "the parts", clearResults,
              [&] { OverlapCheck(report, parts, options, run)(); });
  return report;
}

SharedVolume sharedVolume(const OverlapPart& first, const OverlapPart& second, RunContext& run) {
  SharedVolume shared;
  tbb::task_arena arena(threadsOf(run));
  arena.execute([&] {
    const TriMesh a = overlap::solidOf(first.mesh, quotedName(first), run);
    const TriMesh b = overlap::solidOf(second.mesh, quotedName(second), run);
    overlap::Combined found =
        overlap::combine(overlap::Keep::Inside, a, quotedName(first), b, quotedName(second), run);
    shared = {std::move(found.mesh), found.volume};
  });
  run.checkpoint(Phase::Done);
  return shared;
}

}  // namespace swept
