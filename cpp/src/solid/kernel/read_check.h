// Finds curved faces that the kernel does not read back as they were written.
// In:      Model. The caller must hold a KernelSession.
// Out:     indices into Model::faces.
// Cost:    the curved faces are written as text and read back in memory. They are few and take
//        little time compared with the facets.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solid/kernel/kernel.h"
#include "solid/model/model.h"
#include "solid/text/curved_text.h"
#include "swept/run_context.h"
#include "swept/solid.h"

namespace swept::step {

class ReadCheck {
 public:
  explicit ReadCheck(KernelSession& kernel) : kernel_(kernel) {}
  std::vector<std::int32_t> findUnreadable(const Model& model, const SolidOptions& options,
                                           RunContext& run);

 private:
  std::vector<std::int32_t> read(const std::string& text, std::size_t faces, RunContext& run);

  KernelSession& kernel_;
  CurvedText curved_;
};

}  // namespace swept::step
