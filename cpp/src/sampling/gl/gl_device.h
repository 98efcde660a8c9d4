// A context with the sampler's programs, opened and tested before any run relies on it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>

#include "sampling/gl/gl_program.h"

namespace swept::gl {

struct GlDevice {
  std::unique_ptr<GlContext> context;
  Program mark, winner;

  explicit GlDevice(std::unique_ptr<GlContext> opened)
      : context(std::move(opened)), mark(*context, "mark.frag"), winner(*context, "winner.frag") {}
};

}  // namespace swept::gl
