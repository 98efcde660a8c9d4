// What a run takes, after a look: a few of its steps are sampled on its own grid, and counted.
// In:    checked body and what its check took, planned run. Out: the estimate with seconds and
//        memory of sampling as these steps take them. What the surface takes is seen on a rough
//        one.
// Cost:  sampling of 8 to 192 placements, as far as they have 6 million triangles together, or of
//        up to 1,536 with 400,000, twice as many where these are all; on one thread.
// Promise: within a factor of 2 for memory and 3 for seconds over most of the inputs of
//        tests/tools/unseen_inputs.py (tests/tools/estimate_suite.py measures it).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/body_topology.h"
#include "pipeline/plan.h"

namespace swept {

/// What checking the body took: a run checks it again.
struct BodyCost {
  double seconds = 0;       ///< of all processors together
  std::uint64_t bytes = 0;  ///< by which the process grew meanwhile
};

/// Unchanged for offsets and conservative envelopes.
Estimate estimateByTrial(const Estimate& estimate, const Prepared& prepared,
                         const BodyTopology& topology, const BodyCost& body, const Options& options,
                         RunContext& run);

}  // namespace swept
