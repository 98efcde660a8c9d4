// What a run takes, after a look: parts of it are sampled on its own grid (sampling_trial.h), and
// its surface is seen on a rough one (rough_surface.h). In:    checked body and what its check
// took, planned run. Out: the estimate with seconds and
//        memory as these parts take them.
// Cost:  that of the parts, on one thread. It is bounded by what is sampled, not by time, and so is
//        what is said of memory and triangles.
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
