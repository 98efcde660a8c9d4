// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_context.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>

#include "base/number_text.h"
#include "base/timer.h"
#include "swept/types.h"

namespace swept::gl {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}
bool contains(const char* list, const char* word) {
  return list && std::string(list).find(word) != std::string::npos;
}
std::string hex(unsigned value) {
  char digits[16];
  return "0x" + std::string(digits, std::to_chars(digits, std::end(digits), value, 16).ptr);
}
bool isSoftwareName(const std::string& device) {
  const std::string text = lower(device);
  for (const char* name :
       {"llvmpipe", "softpipe", "swrast", "swiftshader", "software rasterizer"}) {
    if (text.find(name) != std::string::npos) return true;
  }
  return false;
}
[[noreturn]] void unavailable(const std::string& why) {
  throw Error(Status::DeviceUnavailable, "DeviceUnavailable",
              "no GPU can be used: " + why + kDeviceAdvice);
}

}  // namespace

struct GlContext::Candidate {
  std::string label;
  EGLDisplay display;
  bool software;
};

/// Returns the devices that EGL lists, hardware first. If EGL lists none, returns the surfaceless
/// platform or, without it, the default display.
std::vector<GlContext::Candidate> GlContext::candidates() const {
  const char* client = egl_.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Candidate> all;
  const bool devices =
      egl_.QueryDevicesEXT && egl_.GetPlatformDisplayEXT &&
      (contains(client, "EGL_EXT_device_enumeration") || contains(client, "EGL_EXT_device_base")) &&
      contains(client, "EGL_EXT_platform_device");
  EGLDeviceEXT list[16];
  EGLint count = 0;
  if (devices && egl_.QueryDevicesEXT(16, list, &count)) {
    for (EGLint i = 0; i < count; ++i) {
      const char* traits =
          egl_.QueryDeviceStringEXT ? egl_.QueryDeviceStringEXT(list[i], EGL_EXTENSIONS) : nullptr;
      all.push_back({"EGL device " + std::to_string(i),
                     egl_.GetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, list[i], nullptr),
                     contains(traits, "EGL_MESA_device_software")});
    }
  }
  std::stable_partition(all.begin(), all.end(), [](const Candidate& c) { return !c.software; });
  if (all.empty() && egl_.GetPlatformDisplayEXT &&
      contains(client, "EGL_MESA_platform_surfaceless")) {
    all.push_back(
        {"surfaceless EGL platform",
         egl_.GetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                    reinterpret_cast<void*>(EGL_DEFAULT_DISPLAY), nullptr),
         false});
  }
  if (all.empty()) {
    all.push_back({"default EGL display", egl_.GetDisplay(EGL_DEFAULT_DISPLAY), false});
  }
  return all;
}

std::unique_ptr<GlContext> GlContext::open(std::shared_ptr<GlLoader> loader,
                                           const DeviceWish& wish) {
  std::unique_ptr<GlContext> context(new GlContext);
  context->loader_ = std::move(loader);
  std::string why;
  if (!context->loader_->open(why)) unavailable(why);
  std::string missing;
  if (!context->egl_.load(*context->loader_, missing)) {
    unavailable("the EGL library has no " + missing);
  }
  const EglApi& egl = context->egl_;
  context->previousApi_ = egl.QueryAPI();
  context->previousContext_ = egl.GetCurrentContext();
  context->previousDisplay_ = egl.GetCurrentDisplay();
  context->previousDraw_ = egl.GetCurrentSurface(EGL_DRAW);
  context->previousRead_ = egl.GetCurrentSurface(EGL_READ);
  std::string reasons;
  for (const Candidate& candidate : context->candidates()) {
    std::string reason;
    if (wish.hardwareOnly && candidate.software) {
      reason = "is a software rasteriser";
    } else {
      reason = context->tryOpen(candidate, wish);
      if (reason.empty()) return context;
      context->release();
    }
    reasons += (reasons.empty() ? "" : "; ") + candidate.label + " " + reason;
  }
  unavailable(reasons);
}

std::string GlContext::tryOpen(const Candidate& candidate, const DeviceWish& wish) {
  const auto error = [&] {
    return " (EGL error " + hex(static_cast<unsigned>(egl_.GetError())) + ")";
  };
  if (candidate.display == EGL_NO_DISPLAY) return "has no display" + error();
  EGLint major = 0, minor = 0;
  if (!egl_.Initialize(candidate.display, &major, &minor)) return "cannot be initialised" + error();
  display_ = candidate.display;
  const char* traits = egl_.QueryString(display_, EGL_EXTENSIONS);
  if (!contains(traits, "EGL_KHR_surfaceless_context")) return "cannot render without a surface";
  if (!egl_.BindAPI(EGL_OPENGL_API)) return "has no desktop OpenGL";
  EGLConfig config = EGL_NO_CONFIG_KHR;
  if (!contains(traits, "EGL_KHR_no_config_context") &&
      !contains(traits, "EGL_MESA_configless_context")) {
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLint found = 0;
    if (!egl_.ChooseConfig(display_, wanted, &config, 1, &found) || found == 0)
      return "has no configuration for desktop OpenGL";
  }
  // A robust context reports a reset. Without one, fences still detect a lost device.
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,       4,
                            EGL_CONTEXT_MINOR_VERSION,       5,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
  std::vector<EGLint> plain(std::begin(version), std::end(version));
  std::vector<EGLint> robust = plain;
  robust.insert(robust.end(),
                {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE,
                 EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
  for (auto* attributes : {&robust, &plain}) {
    attributes->push_back(EGL_NONE);
    context_ = egl_.CreateContext(display_, config, EGL_NO_CONTEXT, attributes->data());
    if (context_ != EGL_NO_CONTEXT) break;
  }
  if (context_ == EGL_NO_CONTEXT) return "gives no OpenGL 4.5 core context" + error();
  if (!egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    return "cannot make its context current" + error();
  std::string missing;
  if (!gl_.load(*loader_, missing)) return "has no " + missing;
  software_ = candidate.software;
  return describe(wish);
}

std::string GlContext::describe(const DeviceWish& wish) {
  const auto text = [&](GLenum what) {
    const GLubyte* s = gl_.GetString(what);
    return s ? std::string(reinterpret_cast<const char*>(s)) : std::string("?");
  };
  device_ = text(GL_VENDOR) + ", " + text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
  software_ = software_ || isSoftwareName(device_);
  const auto integer = [&](GLenum what) {
    GLint value = 0;
    gl_.GetIntegerv(what, &value);
    return static_cast<int>(value);
  };
  const int version = 10 * integer(GL_MAJOR_VERSION) + integer(GL_MINOR_VERSION);
  if (version < 45) return "(" + device_ + ") is older than OpenGL 4.5";
  if (!wish.name.empty() && lower(device_).find(lower(wish.name)) == std::string::npos)
    return "(" + device_ + ") is not the device asked for, \"" + wish.name + "\"";
  if (wish.hardwareOnly && software_) return "(" + device_ + ") is a software rasteriser";
  GLint64 storage = 0;
  gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
  limits_.storageBytes = storage;
  limits_.storageBlocks = integer(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
  return {};
}

void GlContext::release() {
  if (context_ == EGL_NO_CONTEXT) return;
  egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  egl_.DestroyContext(display_, context_);
  context_ = EGL_NO_CONTEXT;
}

GlContext::~GlContext() {
  release();
  if (egl_.BindAPI && previousApi_ != EGL_NONE) egl_.BindAPI(previousApi_);
  if (previousContext_ != EGL_NO_CONTEXT) {
    egl_.MakeCurrent(previousDisplay_, previousDraw_, previousRead_, previousContext_);
  }
}

void reportGarbage(const std::string& device, const std::string& what) {
  throw Error(Status::DeviceLost, "DeviceGarbage",
              "the GPU returned a wrong result (" + what + ") on " + device + kDeviceAdvice +
                  ", or update the driver");
}

void GlContext::lost(const std::string& what) const {
  throw Error(
      Status::DeviceLost, "DeviceLost",
      "the GPU stopped responding or was reset (" + what + ") on " + device_ + kDeviceAdvice);
}

double GlContext::finish(double timeoutSeconds) const {
  const Timer timer;
  GLsync fence = gl_.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!fence) lost("glFenceSync failed");
  GLenum state = GL_TIMEOUT_EXPIRED;
  while (state == GL_TIMEOUT_EXPIRED && timer.seconds() < timeoutSeconds) {
    const double rest = std::min(0.1, timeoutSeconds - timer.seconds());
    state = gl_.ClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT,
                               static_cast<GLuint64>(std::max(rest, 0.0) * 1e9));
  }
  gl_.DeleteSync(fence);
  if (const GLenum reset = gl_.GetGraphicsResetStatus(); reset != GL_NO_ERROR) {
    lost("reset status " + hex(reset));
  }
  if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) {
    lost(textOf(6, "no answer within ", timeoutSeconds, " s"));
  }
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR) lost("GL error " + hex(error));
  return timer.seconds();
}

}  // namespace swept::gl
