// Where a path begins and ends: is the part free there, and if it touches, how it comes free.
// In:    a placement that a path has to reach. Out: the ways from there to placements that keep the
//        clearance of every neighbour; or an Error that names who is in the way, and how much.
// Units: mm. Cost: one exact check a neighbour; where parts touch, one a direction that is tried.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "path/contacts.h"
#include "path/scene.h"

namespace swept::path {

/// What the search asks of every neighbour: the clearance with chord errors and tolerance.
struct Demand {
  Rule apart;                      ///< mm between the triangles
  std::vector<double> required;    ///< mm, as asked for
  std::vector<double> chordError;  ///< mm, of the neighbour's mesh
  std::vector<std::string> names;
  double bodyChordError = 0;
  double tolerance = 0;
  double release = 0;
  bool turns = true;
};

/// mm between the triangles, a hair more than what counts as clear, so that rounding does not
/// decide. `chordErrors`: of both parts together.
double apartBy(double required, double chordErrors, double tolerance);

/// What neighbours and options ask for together.
Demand demandOf(const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options);

struct End {
  State state;
  /// mm that the part may lie inside a neighbour while it is released from this end; negative: the
  /// common clearance holds for this neighbour.
  std::vector<double> allowedDepth;
  /// Ways out of contact: each is a list of keys, from this state to one that keeps all required
  /// distances. A list with one key means that this state keeps them already.
  std::vector<std::vector<State>> exits;

  bool touches() const { return exits.empty() || exits.front().size() > 1; }
  /// The neighbours that do not count while the part is released.
  Rule ruleInside(const Demand& demand) const;
};

/// mm that the part may lie in a neighbour that it touches at an end, by the row of that end.
double mostDepth(const NeighbourClearance& row, double tolerance, double release);

/// What the clearance check finds about one neighbour; `required`: mm asked for.
NeighbourClearance checkNeighbour(const Scene& scene, const Demand& demand, std::size_t neighbour,
                                  const clearance::MotionTree& motion, double required,
                                  RunContext& run);

/// The end without ways out, which are not looked for. Throws as examineEnd().
End touchedAt(const Scene& scene, const Demand& demand, const State& state, const std::string& what,
              RunContext& run);

/// `what`: "goal", "start" or "via". Throws Error(InvalidInput) GoalBlocked, StartBlocked,
/// ViaBlocked; Error(Cancelled).
End examineEnd(const Scene& scene, const Demand& demand, const State& state,
               const std::string& what, RunContext& run);

/// Whether the part stays no deeper in the neighbours it touches at this end than allowed.
bool releasedClean(const Scene& scene, const Demand& demand, const End& end,
                   const Trajectory& motion, RunContext& run);

}  // namespace swept::path
