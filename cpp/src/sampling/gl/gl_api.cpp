// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_api.h"

#include "base/system.h"

namespace swept::gl {
namespace {

class SystemLoader : public GlLoader {
 public:
  explicit SystemLoader(const std::string& name) : name_(name) {}
  bool open(std::string& why) override {
    if (library_) return true;
    // The library is never closed, because drivers leave threads and exit handlers behind.
    library_ = os::openLibrary(name_, why);
    if (!library_) {
      why = "the EGL library cannot be loaded (" + why + ")";
      return false;
    }
    getProc_ = reinterpret_cast<Getter>(os::symbolOf(library_, "eglGetProcAddress"));
    if (!getProc_) {
      why = name_ + " has no eglGetProcAddress";
      library_ = nullptr;
      return false;
    }
    return true;
  }
  void* find(const char* name) override {
    if (!library_) return nullptr;
    if (name[0] == 'e') {
      if (void* address = os::symbolOf(library_, name)) return address;
    }
    return reinterpret_cast<void*>(getProc_(name));
  }

 private:
  using Getter = void (*(*)(const char*))();
  std::string name_;
  void* library_ = nullptr;
  Getter getProc_ = nullptr;
};

}  // namespace

std::shared_ptr<GlLoader> systemLoader(const std::string& library) {
  return std::make_shared<SystemLoader>(library);
}

bool EglApi::load(GlLoader& loader, std::string& missing) {
#define SWEPT_LOAD(type, name)                             \
  name = reinterpret_cast<type>(loader.find("egl" #name)); \
  if (!name && missing.empty()) missing = "egl" #name;
  SWEPT_EGL_FUNCTIONS(SWEPT_LOAD)
#undef SWEPT_LOAD
#define SWEPT_LOAD(type, name) name = reinterpret_cast<type>(loader.find("egl" #name));
  SWEPT_EGL_EXTENSIONS(SWEPT_LOAD)
#undef SWEPT_LOAD
  return missing.empty();
}

bool GlApi::load(GlLoader& loader, std::string& missing) {
#define SWEPT_LOAD(type, name)                            \
  name = reinterpret_cast<type>(loader.find("gl" #name)); \
  if (!name && missing.empty()) missing = "gl" #name;
  SWEPT_GL_FUNCTIONS(SWEPT_LOAD)
#undef SWEPT_LOAD
  return missing.empty();
}

}  // namespace swept::gl
