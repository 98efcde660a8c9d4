// The two shader programs of the sampler, compiled from the embedded shaders.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "sampling/gl/gl_context.h"

namespace swept::gl {

/// A linked program. Throws Error(DeviceUnavailable, "ShaderFailed") with the driver's log.
class Program {
 public:
  /// Compiles and links the program. `keep`: the shader file that defines keep(), "mark.glsl" or
  /// "winner.glsl".
  Program(const GlContext& context, const std::string& keep);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  unsigned id() const { return id_; }

 private:
  const GlContext& context_;
  unsigned id_ = 0;
};

/// A context with the programs of the sampler. It must be tested before a run relies on it.
struct GlDevice {
  std::unique_ptr<GlContext> context;
  Program mark, winner;

  explicit GlDevice(std::unique_ptr<GlContext> opened)
      : context(std::move(opened)), mark(*context, "mark.glsl"), winner(*context, "winner.glsl") {}
};

}  // namespace swept::gl
