// A headless OpenGL 4.5 context: which device, what it can do, and whether it still works.
//
// Devices are listed through EGL; hardware is tried before software rasterisers. A context is
// current on the thread that made it from construction to destruction; whatever was current before
// is restored. The display is never terminated, because others in this process may use it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sampling/gl/gl_api.h"

namespace swept::gl {

struct DeviceWish {
  std::string name;           ///< part of vendor, renderer or version, any case; empty: any device
  bool hardwareOnly = false;  ///< do not even open software rasterisers
};

struct Limits {
  std::int64_t storageBytes = 0;  ///< one shader storage block
  int texture3d = 0, viewport = 0, framebuffer = 0;
  int vertexStorageBlocks = 0, fragmentStorageBlocks = 0, fragmentImages = 0;
  int geometryInvocations = 0, viewports = 0;
};

/// Throws Error(DeviceLost, "DeviceGarbage"): the device answered, but wrongly.
[[noreturn]] void reportGarbage(const std::string& device, const std::string& what);

class GlContext {
 public:
  /// Throws Error(DeviceUnavailable) that names the step that failed for each device tried.
  static std::unique_ptr<GlContext> open(std::shared_ptr<GlLoader> loader, const DeviceWish& wish);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  const GlApi& gl() const { return gl_; }
  const Limits& limits() const { return limits_; }
  const std::string& device() const { return device_; }  ///< vendor, renderer, version

  /// Waits until all work so far is done. Throws Error(DeviceLost) if the context was reset, an
  /// error was raised, or nothing came back within `timeoutSeconds`. Returns the seconds waited.
  double finish(double timeoutSeconds) const;
  [[noreturn]] void lost(const std::string& what) const;

 private:
  struct Candidate;
  GlContext() = default;
  /// Both say why the candidate cannot be used; nothing if it can.
  std::string tryOpen(const Candidate& candidate, const DeviceWish& wish);
  std::string describe(const DeviceWish& wish);
  std::vector<Candidate> candidates() const;
  void release();

  std::shared_ptr<GlLoader> loader_;
  EglApi egl_;
  GlApi gl_;
  EGLDisplay display_ = EGL_NO_DISPLAY, previousDisplay_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT, previousContext_ = EGL_NO_CONTEXT;
  EGLSurface previousDraw_ = EGL_NO_SURFACE, previousRead_ = EGL_NO_SURFACE;
  EGLenum previousApi_ = EGL_OPENGL_ES_API;
  std::string device_;
  Limits limits_;
  bool software_ = false;
};

}  // namespace swept::gl
