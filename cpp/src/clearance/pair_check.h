// The whole answer about one neighbour: from two parts and a motion to its row of the report.
// In:    parts that are prepared once and serve many motions; a motion's hierarchy. Units: mm.
// Out:   as docs/clearance.md says. Cost: some hundred distance queries, more where parts clash.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <string>

#include "clearance/motion_search.h"
#include "swept/clearance.h"

namespace swept::clearance {

/// The mesh as a part; of a welded and turned copy (`mended`) if the mesh itself is not closed but
/// that is. Throws as Part does.
Part closedPart(const TriMesh& mesh, const std::string& who, RunContext& run, bool& mended);

struct CheckedPair {
  const Part& body;
  bool bodyMended;
  const Part& neighbour;
  bool neighbourMended;
  /// mm, a pair that never comes nearer gets the distance infinity and no curve. More than the
  /// required distance, the chord errors and two tolerances together.
  double within = std::numeric_limits<double>::infinity();
};

/// What is known of a neighbour besides its mesh.
struct CheckedNeighbour {
  std::string name;
  double chordError = 0;  ///< mm; that of the body stands in the options
  NeighbourRule rule;     ///< as askedOf() gives it
};

/// The rule that holds for a neighbour with this rule of its own: a distance or contact.
NeighbourRule askedOf(const NeighbourRule& own, double commonRequired);

/// Throws Error(Cancelled).
NeighbourClearance checkPair(const CheckedPair& parts, const CheckedNeighbour& neighbour,
                             const MotionTree& motion, const ClearanceOptions& options,
                             RunContext& run);

/// What is said of neighbours (and of the body) where "inside" has no meaning. `one`, `many`: what
/// a report calls them.
std::vector<Finding> openFindings(const std::vector<std::string>& names,
                                  const std::vector<char>& closed, bool bodyClosed,
                                  const std::string& one = "neighbour",
                                  const std::string& many = "neighbours");

}  // namespace swept::clearance
