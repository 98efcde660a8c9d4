// Finds curved faces that the kernel does not read back as they were written.
// In: Model; the caller holds the KernelSession. Out: indices into Model::faces. Cost: writes the
// curved faces as text in memory and reads them again. They are few compared with the facets.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solid/kernel/kernel.h"
#include "solid/model/model.h"
#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

class ReadCheck {
 public:
  ReadCheck(const StepOptions& options, KernelSession& kernel, RunContext& run)
      : options_(options), kernel_(kernel), run_(run) {}
  std::vector<std::int32_t> findUnreadable(const Model& model);

 private:
  std::vector<std::int32_t> read(const std::string& text, std::size_t faces);

  const StepOptions& options_;
  KernelSession& kernel_;
  RunContext& run_;
  // The last text and its result. If only facets have changed, the text of the curved faces is the
  // same, and no second check is needed.
  std::string lastText_;
  std::vector<std::int32_t> answer_;
};

}  // namespace swept::step
