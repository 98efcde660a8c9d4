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

/// Computes signs from marks. Samplers call it between their passes; a fallback calls it again.
using FindSigns = std::function<SignRuns(const MarkedEdges&)>;

}  // namespace swept
