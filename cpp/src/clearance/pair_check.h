// Computes the row of the report for one neighbour.
// In:      two parts, which are prepared once for many motions, and the tree of one motion
//          (motion_tree.h).
// Out:     the row that docs/clearance.md describes.
// Units:   mm.
// Cost:    some hundred distance queries, more if the parts overlap.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <string>

#include "clearance/motion_search.h"
#include "swept/clearance.h"

namespace swept::clearance {

/// Prepares the mesh as a part. If the mesh is open but a repaired copy (vertices merged,
/// orientation made consistent) is closed, uses the copy and sets `mended`. Throws the errors of
/// Part.
Part closedPart(const TriMesh& mesh, const std::string& who, RunContext& run, bool& mended);

struct CheckedPair {
  const Part& body;
  bool bodyMended;
  const Part& neighbour;
  bool neighbourMended;
  /// mm; a pair that is never nearer than this gets an infinite distance and no curve. Must exceed
  /// the sum of the required distance, the chord errors and two tolerances.
  double within = std::numeric_limits<double>::infinity();
};

/// Properties of a neighbour besides its mesh.
struct CheckedNeighbour {
  std::string name;
  double chordError = 0;  ///< mm; the chord error of the body is in the options
  NeighbourRule rule;     ///< the result of ruleFor()
};

/// Returns the rule for a neighbour: its own, or without one the common required distance.
NeighbourRule ruleFor(const NeighbourRule& own, double commonRequired);

/// Computes the row of one neighbour. Throws Error(Cancelled).
NeighbourClearance checkPair(const CheckedPair& parts, const CheckedNeighbour& neighbour,
                             const MotionTree& motion, const ClearanceOptions& options,
                             RunContext& run);

/// Returns warnings about open meshes, for which "inside" is not defined. `one` and `many` are the
/// words for the parts in the texts.
std::vector<Finding> openFindings(const std::vector<std::string>& names,
                                  const std::vector<char>& closed, bool bodyClosed,
                                  const std::string& one = "neighbour",
                                  const std::string& many = "neighbours");

}  // namespace swept::clearance
