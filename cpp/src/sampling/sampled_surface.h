// The result of a sampling run, in the same form for every sampler.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sampling/sampler.h"
#include "signs/signs.h"
#include "swept/report.h"

namespace swept {

struct SampledSurface {
  MarkedEdges marked;
  SignRuns signs;
  std::string backend = "cpu", device;
  std::vector<Finding> notes;
};

/// Computes signs from marked edges. A sampler with two passes calls this function between them. If
/// the CPU then takes over, it calls the function again.
using FindSigns = std::function<SignRuns(const MarkedEdges&)>;

}  // namespace swept
