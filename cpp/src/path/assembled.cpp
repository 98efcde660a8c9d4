// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/assembled.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <set>

#include "base/number_text.h"
#include "base/parallel.h"
#include "clearance/mechanism_input.h"
#include "clearance/pair_check.h"
#include "geometry/mesh_parts.h"
#include "path/ends.h"
#include "path/task_check.h"

namespace swept::path {
namespace {

using clearance::Part;

[[noreturn]] void refuse(const std::string& code, const std::string& text) {
  throw Error(Status::InvalidInput, code, text);
}

std::vector<std::string> namesOf(const std::vector<SequencePart>& parts,
                                 const std::vector<StillPart>& still) {
  if (parts.empty()) refuse("NoParts", "no part is given; give at least one");
  std::vector<std::string> names;
  for (const SequencePart& part : parts) names.push_back(part.name);
  for (const StillPart& part : still) names.push_back(part.name);
  std::set<std::string> seen;
  for (const std::string& name : names)
    if (!seen.insert(name).second)
      refuse("PartTwice", "part '" + name + "' is given twice; give each part its own name");
  return names;
}

// Checks everything that does not need the mesh. Throws Error(InvalidInput).
void checkPart(const SequencePart& part, const SequenceOptions& options) {
  try {
    PathTask task = part.task;
    PathOptions o = options.path;
    o.bodyChordError = part.chordError;
    if (part.motion) {
      const std::vector<Pose>& keys = part.motion->poses;
      if (keys.size() < 2)
        refuse("BadPose", "the motion has " + counted(std::ssize(keys), "pose") +
                              ", but needs at least 2; add poses, or leave out the motion");
      for (std::size_t i = 1; i < keys.size(); ++i)
        if (!(keys[i].timeSeconds > keys[i - 1].timeSeconds))
          refuse("EqualTimes", textOf(6, keyName(i), ", at ", keys[i].timeSeconds,
                                      " s, is not later than the key before it, at ",
                                      keys[i - 1].timeSeconds, " s; times must increase"));
      std::vector<Finding> findings;
      clearance::timedPoses({part.name, {}, *part.motion}, findings);
      task = {};
      task.start = Pose{};
    }
    checkPathOptions(task, {ClearanceNeighbour{}}, o);
    checkedPose(Assembled::goalOf(part), "the goal");
  } catch (const Error& error) {
    const std::string who = "part '" + part.name + "'";
    if (std::string(error.what()).find(who) != std::string::npos) throw;
    throw Error(error.status(), error.code(), who + ": " + error.what());
  }
}

TriMesh placedMesh(TriMesh mesh, const Pose& pose) {
  const Eigen::Matrix3d rotation = pose.rotation.normalized().toRotationMatrix();
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = rotation * vertex + pose.translation;
  return mesh;
}

clearance::PairRules rulesOf(const std::vector<std::string>& names, const SequenceOptions& o) {
  MechanismOptions options;
  options.required = o.path.clearance;
  options.rules = o.rules;
  return {names, options};
}

std::string pairText(const NearPair& pair, const ClearanceNeighbour& a,
                     const ClearanceNeighbour& b) {
  const std::string who = "'" + a.name + "' and '" + b.name + "'";
  if (!pair.intersect)
    return who + " are " + numberText(std::max(0.0, pair.row.distance - pair.row.chordError), 6) +
           " mm apart";
  return who + " overlap" +
         (pair.row.penetration.known ? ", " + numberText(pair.row.penetration.depth, 4) + " mm deep"
                                     : "");
}

}  // namespace

Assembled::Assembled(const std::vector<SequencePart>& parts, const std::vector<StillPart>& still,
                     const SequenceOptions& options, RunContext& run)
    : rules_(rulesOf(namesOf(parts, still), options)), parts_(parts.size()) {
  for (const SequencePart& part : parts) checkPart(part, options);
  if (parts.size() == 1 && still.empty())
    refuse("NoNeighbours",
           "only one part is given; give a second part, or a neighbour that stands still");
  for (const SequencePart& part : parts)
    placed_.push_back({part.name, placedMesh(part.mesh, goalOf(part)), part.chordError});
  for (const StillPart& part : still) placed_.push_back({part.name, part.mesh, part.chordError});
  for (const ClearanceNeighbour& part : placed_) box_.extend(boxOf(part.mesh));
  requireApart(parts.size(), options.path, run);
}

const Pose& Assembled::goalOf(const SequencePart& part) {
  return part.motion ? part.motion->poses.back() : part.task.goal;
}

std::vector<ClearanceNeighbour> Assembled::neighboursOf(std::size_t part,
                                                        const std::vector<char>& installed) const {
  std::vector<ClearanceNeighbour> list;
  for (std::size_t i = parts_; i < placed_.size() + parts_; ++i) {
    const std::size_t k = i < placed_.size() ? i : i - placed_.size();
    if (k == part || (k < parts_ && installed[k] == 0)) continue;
    list.push_back(placed_[k]);
    list.back().rule = rules_.of({static_cast<std::int32_t>(std::min(k, part)),
                                  static_cast<std::int32_t>(std::max(k, part))});
  }
  return list;
}

// Throws if two parts overlap at their goals, or are nearer than required and have no release
// distance: such parts cannot be assembled.
void Assembled::requireApart(std::size_t parts, const PathOptions& o, RunContext& run) const {
  std::vector<std::unique_ptr<const Part>> prepared(placed_.size());
  std::vector<char> mended(placed_.size(), 0);
  parallelFor(placed_.size(), [&](std::size_t i) {
    bool was = false;
    prepared[i] = std::make_unique<const Part>(
        clearance::closedPart(placed_[i].mesh, "part '" + placed_[i].name + "'", run, was));
    mended[i] = was ? 1 : 0;
  });
  std::vector<NearPair> pairs;
  for (std::size_t i = 0; i < parts; ++i)
    for (std::size_t j = i + 1; j < placed_.size(); ++j) {
      const PartPair pair{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
      if (!rules_.ignores(pair)) pairs.push_back({pair, {}, false});
    }
  const Trajectory still{{Pose{}}, Interpolation::None};
  std::vector<char> near(pairs.size(), 0);
  std::atomic<std::uint64_t> done{0};
  parallelFor(pairs.size(), [&](std::size_t p) {
    const auto [i, j] = pairs[p].parts;
    const clearance::Box box = prepared[i]->box(prepared[i]->tree().root());
    const NeighbourRule rule = rules_.of(pairs[p].parts);
    const double required = std::max(rule.required.value_or(0), o.tolerance);
    const double chords = placed_[i].chordError + placed_[j].chordError;
    const double apart = distanceToKeep(required, chords, o.tolerance);
    ClearanceOptions options;
    options.tolerance = o.tolerance;
    options.bodyChordError = placed_[i].chordError;
    options.curveSamples = 0;
    NeighbourClearance& row = pairs[p].row;
    row = clearance::checkPair(
        {*prepared[i], mended[i] != 0, *prepared[j], mended[j] != 0, apart + 3 * o.tolerance},
        {placed_[j].name, placed_[j].chordError, {required}},
        clearance::MotionTree(still, box.centre, box.half), options, run);
    run.checkpoint(Phase::Motion, ++done, pairs.size());
    if (row.verdict == ClearanceVerdict::Clear && row.distance >= apart) return;
    const double most = largestAllowedDepth(row, o.tolerance, o.release);
    pairs[p].intersect = row.verdict == ClearanceVerdict::Clash &&
                         (!row.penetration.known || row.penetration.depthBound > most);
    near[p] = pairs[p].intersect || o.release <= 0 ? 1 : 0;
  });
  for (std::size_t p = pairs.size(); p-- > 0;)
    if (near[p] == 0) pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(p));
  if (!pairs.empty()) refuseWorst(pairs, o);
}

// Throws an error with the deepest overlap, or without overlaps the nearest pair, and the number of
// other pairs.
void Assembled::refuseWorst(const std::vector<NearPair>& pairs, const PathOptions& o) const {
  const auto rank = [](const NearPair& pair) {
    return pair.intersect ? pair.row.penetration.depth : -1 - pair.row.distance;
  };
  const NearPair& worst =
      *std::max_element(pairs.begin(), pairs.end(),
                        [&](const NearPair& a, const NearPair& b) { return rank(a) < rank(b); });
  const ClearanceNeighbour &a = placed_[worst.parts.first], &b = placed_[worst.parts.second];
  std::string text = "in their installed positions, " + pairText(worst, a, b);
  const std::size_t others = pairs.size() - 1;
  if (others > 0) text += " (and " + counted(static_cast<std::int64_t>(others), "more pair") + ")";
  const std::string more = releaseAdvice(worst.row, o.release);
  if (worst.intersect)
    refuse("PartsIntersect",
           text +
               (o.release > 0
                    ? ", but at most " +
                          numberText(largestAllowedDepth(worst.row, o.tolerance, o.release), 4) +
                          " mm is allowed within the release distance of " +
                          numberText(o.release, 4) + " mm"
                    : "") +
               "; move one of the parts" + (more.empty() ? "" : ", or " + more));
  refuse("PartsTooNear",
         text + ", " + requiredText(rules_.of(worst.parts).required.value_or(0), o.tolerance) +
             "set a release distance, which allows contact near the installed positions");
}

}  // namespace swept::path
