// A headless OpenGL 4.5 context: chooses the device, reads its limits, and detects its loss.
//
// EGL lists the devices; hardware is tried before software rasterisers. From construction to
// destruction the context is current on the thread that created it. The destructor restores the
// previous context. The display is never terminated, because others in the process may use it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sampling/gl/gl_api.h"

namespace swept::gl {

struct DeviceWish {
  /// Text that vendor, renderer or version must contain (case ignored). Empty: any device.
  std::string name;
  bool hardwareOnly = false;  ///< true: does not even open software rasterisers
};

struct Limits {
  std::int64_t storageBytes = 0;  ///< largest size of one shader storage block
  int storageBlocks = 0;          ///< largest number of storage blocks in a compute shader
};

/// Advice for the user: the last part of all messages about a device that cannot be used.
inline constexpr const char* kDeviceAdvice = "; set the backend to cpu or auto";

/// Throws Error(DeviceLost, "DeviceGarbage"), which says that the device gave a wrong answer.
[[noreturn]] void reportGarbage(const std::string& device, const std::string& what);

class GlContext {
 public:
  /// Throws Error(DeviceUnavailable) that says for each device which step failed.
  static std::unique_ptr<GlContext> open(std::shared_ptr<GlLoader> loader, const DeviceWish& wish);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  const GlApi& gl() const { return gl_; }
  const Limits& limits() const { return limits_; }
  const std::string& device() const { return device_; }  ///< vendor, renderer, version

  /// Waits until all work so far is done. Returns the seconds waited. Throws Error(DeviceLost) if
  /// the context was reset, if GL reports an error, or after `timeoutSeconds`.
  double finish(double timeoutSeconds) const;
  [[noreturn]] void lost(const std::string& what) const;

 private:
  struct Candidate;
  GlContext() = default;
  /// Both functions return an empty text, or the reason why the candidate cannot be used.
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
