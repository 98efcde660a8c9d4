// Estimates time and memory of a run: samples parts of the run on its grid (sampling_trial.h) and a
// rough surface (rough_surface.h).
// In:    checked body, cost of its check, planned run.
// Out:   the estimate with better values for seconds and memory.
// Cost:  that of the samples, on one thread. The samples are limited by counts, not by time, so the
//        figures for memory and triangles are reproducible.
// Promise: the estimate is within a factor of 2 for memory and 3 for seconds over most of the
//        inputs of tests/tools/unseen_inputs.py (tests/tools/estimate_suite.py measures it).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "geometry/body_topology.h"
#include "pipeline/plan.h"

namespace swept {

/// Cost of the check of the body. A run repeats this check.
struct BodyCost {
  double seconds = 0;       ///< CPU seconds, summed over all threads
  std::uint64_t bytes = 0;  ///< growth of the memory of the process during the check
};

/// Returns the estimate unchanged for offsets and conservative envelopes.
Estimate estimateByTrial(const Estimate& estimate, const Prepared& prepared,
                         const BodyTopology& topology, const BodyCost& body, const Options& options,
                         RunContext& run);

}  // namespace swept
