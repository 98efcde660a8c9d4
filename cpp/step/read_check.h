// Which curved faces does the kernel not read back as it was told them?
// In: Model; the caller holds the KernelSession. Out: indices into Model::faces. The curved faces
// are written as text and read again, in memory; they are few and cheap next to the facets.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "kernel.h"
#include "model.h"
#include "swept/run_context.h"
#include "swept/step_export.h"

namespace swept::step {

std::vector<std::int32_t> findUnreadable(const Model& model, const StepOptions& options,
                                         KernelSession& kernel, RunContext& run);

}  // namespace swept::step
