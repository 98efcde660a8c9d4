// Examines the start, the goal or another required placement of a path. Checks whether the part is
// free there. If the part touches a neighbour, finds moves away from the contact ("exits").
// In:      a placement through which a path must pass.
// Out:     exits from this placement to placements that keep the required distance from each
//        neighbour; or an Error that names the blocking neighbour and the distance or depth.
// Units:   mm.
// Cost:    one exact check per neighbour; if parts touch, also one for each direction that is
//        tried.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "path/contacts.h"
#include "path/scene.h"

namespace swept::path {

/// What the search requires of each neighbour.
struct Demand {
  Rule apart;  ///< mm, distance to keep between the triangles, including chord errors and tolerance
  std::vector<double> required;    ///< mm, the required distance as given by the caller
  std::vector<double> chordError;  ///< mm, chord error of the neighbour's mesh
  std::vector<std::string> names;
  double bodyChordError = 0;
  double tolerance = 0;
  double release = 0;  ///< mm, release distance of the start and the goal
  bool turns = true;
};

/// Returns the distance (mm) that the triangles must keep. It is slightly larger than the distance
/// that the check accepts as clear, so that rounding does not matter. `chordErrors`: sum for both
/// parts.
double distanceToKeep(double required, double chordErrors, double tolerance);

/// Returns what the rules of the neighbours and the options require together.
Demand demandOf(const std::vector<ClearanceNeighbour>& neighbours, const PathOptions& options);

struct End {
  State state;
  /// mm, one entry per neighbour: how deep the part may lie inside the neighbour within the release
  /// distance of this end. Negative: the part must keep the required distance from the neighbour.
  std::vector<double> allowedDepth;
  /// Exits from contact. Each is a list of keys from this state to a state that keeps all required
  /// distances. A list with one key means that this state already keeps them.
  std::vector<std::vector<State>> exits;

  bool touches() const { return exits.empty() || exits.front().size() > 1; }
  /// Returns the distances to keep within the release distance. Neighbours that the part touches at
  /// this end get -1 (ignored).
  Rule ruleInside(const Demand& demand) const;
};

/// Returns how deep (mm) the part may lie in a neighbour that it touches at an end. `row`: result
/// of the check of this neighbour at that end.
double largestAllowedDepth(const NeighbourClearance& row, double tolerance, double release);

/// Returns advice about the release distance that would allow the overlap in `row`, such as "set a
/// release distance of at least 5 mm". Empty if the depth of the overlap is not known. `release`:
/// mm, the present release distance.
std::string releaseAdvice(const NeighbourClearance& row, double release);

/// Returns the end of a message about parts that are too near, for example "but 5 mm are required;
/// reduce the required distance, or ", which other advice must follow. Units: mm.
std::string requiredText(double required, double tolerance);

/// Returns the name in messages of a pose that the path must pass. `number`: counts from 1.
std::string viaName(std::size_t number);

/// Checks one neighbour with checkPair() (clearance/pair_check.h). `required`: mm.
NeighbourClearance checkNeighbour(const Scene& scene, const Demand& demand, std::size_t neighbour,
                                  const clearance::MotionTree& motion, double required,
                                  RunContext& run);

/// Does the same as examineEnd() but does not search for exits, so the result has none.
End examineContacts(const Scene& scene, const Demand& demand, const State& state,
                    const std::string& what, RunContext& run);

/// Examines an end of the path. `what`: "the goal", "the start" or a text from viaName(). Throws
/// Error(InvalidInput) with GoalBlocked, StartBlocked or ViaBlocked, and Error(Cancelled).
End examineEnd(const Scene& scene, const Demand& demand, const State& state,
               const std::string& what, RunContext& run);

/// Returns true only if it is proven that the motion stays within `end.allowedDepth`: the part
/// never lies deeper than allowed in a neighbour that it touches at this end.
bool staysWithinDepth(const Scene& scene, const Demand& demand, const End& end,
                      const Trajectory& motion, RunContext& run);

}  // namespace swept::path
