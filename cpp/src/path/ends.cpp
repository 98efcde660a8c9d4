// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/ends.h"

#include <algorithm>

#include "base/number_text.h"
#include "clearance/pair_check.h"
#include "clearance/penetration.h"

namespace swept::path {
namespace {

constexpr std::size_t kMaxExits = 6;
constexpr double kDepthShare = 0.1;  // largest allowed depth, as a share of the release distance

bool isVia(const std::string& what) { return what != "the goal" && what != "the start"; }

[[noreturn]] void refuse(const std::string& what, const NeighbourClearance& row, double required,
                         double tolerance, double release, double most) {
  const bool via = isVia(what);
  const char* code = via ? "ViaBlocked" : what == "the goal" ? "GoalBlocked" : "StartBlocked";
  const std::string where = "at " + what;
  const std::string who = "'" + row.name + "'";
  if (row.verdict == ClearanceVerdict::Clash) {
    const std::string depth = row.penetration.known
                                  ? numberText(row.penetration.depth, 4) + " mm deep"
                                  : "by an unknown depth, because the meshes are open";
    const std::string more = via ? "" : releaseAdvice(row, release);
    throw Error(
        Status::InvalidInput, code,
        where + " the part overlaps neighbour " + who + ", " + depth +
            (release > 0 ? ", but within the release distance of " + numberText(release, 4) +
                               " mm, at most " + numberText(most, 4) + " mm is allowed"
                         : "") +
            "; move " + (via ? "or remove this pose" : "the part") +
            (more.empty() ? "" : ", " + more) + ", or ignore this neighbour");
  }
  throw Error(Status::InvalidInput, code,
              where + " the part is " +
                  numberText(std::max(0.0, row.distance - row.chordError), 6) +
                  " mm from neighbour " + who + ", " + requiredText(required, tolerance) +
                  (via ? "move or remove this pose"
                       : "set a release distance, which allows contact near the start and the "
                         "goal"));
}

// Returns the keys of a move: one straight piece, or a screw in pieces of at most 30 degrees each.
std::vector<State> keysOf(const Scene& scene, const State& from, const Twist& twist) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(twist.turn.norm() / 0.52)));
  std::vector<State> keys;
  for (int k = 0; k <= pieces; ++k)
    keys.push_back(k == 0 ? from : scene.moved(from, twist * (double(k) / pieces)));
  return keys;
}

Trajectory motionOf(const std::vector<State>& keys, Interpolation interpolation) {
  Trajectory motion{{}, interpolation};
  for (const State& state : keys) {
    motion.poses.push_back(state.pose);
    motion.poses.back().timeSeconds = static_cast<double>(motion.poses.size() - 1);
  }
  return motion;
}

void findExits(const Scene& scene, const Demand& demand, End& end, RunContext& run) {
  Rule near(scene.count(), -1);
  for (std::size_t i = 0; i < scene.count(); ++i)
    if (end.allowedDepth[i] >= 0) near[i] = demand.apart[i];
  const std::vector<Contact> contacts = contactsOf(scene, end.state, near);
  const Rule inside = end.ruleInside(demand);
  Memory memory = scene.memory();
  for (const Twist& move : freeMoves(scene, end.state, contacts, demand.turns)) {
    run.checkpoint(Phase::Motion);
    for (const double part : {0.125, 0.25, 0.5, 1.0}) {
      const std::vector<State> keys =
          keysOf(scene, end.state, move * (0.999 * part * demand.release));
      if (!scene.isFree(keys.back(), demand.apart, memory)) continue;
      bool free = true;
      for (std::size_t k = 1; k < keys.size() && free; ++k)
        free = scene.follow(keys[k - 1], keys[k], inside, memory).fraction >= 1;
      if (free && staysWithinDepth(scene, demand, end, motionOf(keys, scene.interpolation()), run))
        end.exits.push_back(keys);
      break;
    }
    if (end.exits.size() >= kMaxExits) return;
  }
}

}  // namespace

double distanceToKeep(double required, double chordErrors, double tolerance) {
  return std::max(required, tolerance) + chordErrors + 1e-7;
}

Demand demandOf(const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options) {
  Demand demand;
  for (const ClearanceNeighbour& n : neighbours) {
    const double required = n.rule.required.value_or(options.clearance);
    demand.required.push_back(required);
    demand.chordError.push_back(n.chordError);
    demand.names.push_back(n.name);
    demand.apart.push_back(
        distanceToKeep(required, options.bodyChordError + n.chordError, options.tolerance));
  }
  demand.bodyChordError = options.bodyChordError;
  demand.tolerance = options.tolerance;
  demand.release = options.release;
  demand.turns = !options.translationOnly;
  return demand;
}

NeighbourClearance checkNeighbour(const Scene& scene, const Demand& demand, std::size_t neighbour,
                                  const clearance::MotionTree& motion, double required,
                                  RunContext& run) {
  ClearanceOptions options;
  options.tolerance = demand.tolerance;
  options.bodyChordError = demand.bodyChordError;
  options.curveSamples = 0;
  return clearance::checkPair({scene.part(), scene.partMended(), scene.neighbour(neighbour),
                               scene.neighbourMended(neighbour)},
                              {demand.names[neighbour], demand.chordError[neighbour], {required}},
                              motion, options, run);
}

Rule End::ruleInside(const Demand& demand) const {
  Rule rule = demand.apart;
  for (std::size_t i = 0; i < rule.size(); ++i)
    if (allowedDepth[i] >= 0) rule[i] = -1;
  return rule;
}

bool staysWithinDepth(const Scene& scene, const Demand& demand, const End& end,
                      const Trajectory& motion, RunContext& run) {
  const clearance::MotionTree tree = scene.motionTree(motion);
  for (std::size_t i = 0; i < scene.count(); ++i) {
    if (end.allowedDepth[i] < 0) continue;
    const clearance::PairSearch pair(scene.part(), scene.neighbour(i));
    for (const Pose& pose : motion.poses)
      if (clearance::overlapsAtLeast(pair, pose.rotation.toRotationMatrix(), pose.translation,
                                     1.01 * end.allowedDepth[i]))
        return false;
    const NeighbourClearance row = checkNeighbour(scene, demand, i, tree, 0, run);
    if (row.verdict != ClearanceVerdict::Clash) continue;
    // If the surfaces of two open meshes intersect, the depth is unknown and nothing is proven.
    if (!row.penetration.known || row.penetration.depthBound > end.allowedDepth[i]) return false;
  }
  return true;
}

double largestAllowedDepth(const NeighbourClearance& row, double tolerance, double release) {
  return std::max(tolerance + row.chordError, kDepthShare * release);
}

std::string releaseAdvice(const NeighbourClearance& row, double release) {
  if (!row.penetration.known) return "";
  // The text has three digits. One per cent more makes up for rounding.
  const double enough = 1.01 * row.penetration.depthBound / kDepthShare;
  return std::string(release > 0 ? "increase the release distance to"
                                 : "set a release distance of") +
         " at least " + numberText(enough, 3) + " mm";
}

std::string requiredText(double required, double tolerance) {
  if (required <= tolerance)
    return "but " + numberText(tolerance, 6) + " mm (the accuracy) are needed; ";
  return "but " + numberText(required, 6) + " mm are required; reduce the required distance, or ";
}

std::string viaName(std::size_t number) {
  return "pose " + std::to_string(number) + " on the way (via, counted from 1)";
}

End examineContacts(const Scene& scene, const Demand& demand, const State& state,
                    const std::string& what, RunContext& run) {
  End end{state, std::vector<double>(scene.count(), -1), {}};
  const clearance::MotionTree still = scene.motionTree({{state.pose}, Interpolation::None});
  const double release = isVia(what) ? 0 : demand.release;
  for (std::size_t i = 0; i < scene.count(); ++i) {
    run.checkpoint(Phase::Motion, i, scene.count());
    const NeighbourClearance row = checkNeighbour(
        scene, demand, i, still, std::max(demand.required[i], demand.tolerance), run);
    if (row.verdict == ClearanceVerdict::Clear && row.distance >= demand.apart[i]) continue;
    const double touch = demand.tolerance + row.chordError;
    const double most = largestAllowedDepth(row, demand.tolerance, release);
    const bool clash = row.verdict == ClearanceVerdict::Clash;
    const bool deep = clash && (!row.penetration.known || row.penetration.depthBound > most);
    if (release <= 0 || deep)
      refuse(what, row, demand.required[i], demand.tolerance, release, most);
    end.allowedDepth[i] = clash ? std::min(most, 1.05 * row.penetration.depthBound) : touch;
  }
  return end;
}

End examineEnd(const Scene& scene, const Demand& demand, const State& state,
               const std::string& what, RunContext& run) {
  End end = examineContacts(scene, demand, state, what, run);
  const bool touches = std::any_of(end.allowedDepth.begin(), end.allowedDepth.end(),
                                   [](double depth) { return depth >= 0; });
  if (touches)
    findExits(scene, demand, end, run);
  else
    end.exits.push_back({state});
  return end;
}

}  // namespace swept::path
