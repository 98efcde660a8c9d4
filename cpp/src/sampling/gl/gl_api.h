// Entry points of EGL 1.5 and OpenGL 4.5, found at run time. The program is not linked against GL.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <memory>
#include <string>

namespace swept::gl {

/// Finds entry points. Tests replace it with their own loader.
class GlLoader {
 public:
  virtual ~GlLoader() = default;
  /// Returns false and a reason if the library cannot be opened. May be called again.
  virtual bool open(std::string& why) = 0;
  /// Address of an egl* or gl* function, or null.
  virtual void* find(const char* name) = 0;
};

/// Returns a loader for the EGL library with this name or file path.
std::shared_ptr<GlLoader> systemLoader(const std::string& library = "libEGL.so.1");

#define SWEPT_EGL_FUNCTIONS(X)                      \
  X(PFNEGLGETDISPLAYPROC, GetDisplay)               \
  X(PFNEGLINITIALIZEPROC, Initialize)               \
  X(PFNEGLQUERYSTRINGPROC, QueryString)             \
  X(PFNEGLBINDAPIPROC, BindAPI)                     \
  X(PFNEGLQUERYAPIPROC, QueryAPI)                   \
  X(PFNEGLCHOOSECONFIGPROC, ChooseConfig)           \
  X(PFNEGLCREATECONTEXTPROC, CreateContext)         \
  X(PFNEGLDESTROYCONTEXTPROC, DestroyContext)       \
  X(PFNEGLMAKECURRENTPROC, MakeCurrent)             \
  X(PFNEGLGETCURRENTCONTEXTPROC, GetCurrentContext) \
  X(PFNEGLGETCURRENTDISPLAYPROC, GetCurrentDisplay) \
  X(PFNEGLGETCURRENTSURFACEPROC, GetCurrentSurface) \
  X(PFNEGLGETERRORPROC, GetError)

/// These entry points may be missing; they are then null.
#define SWEPT_EGL_EXTENSIONS(X)                           \
  X(PFNEGLQUERYDEVICESEXTPROC, QueryDevicesEXT)           \
  X(PFNEGLQUERYDEVICESTRINGEXTPROC, QueryDeviceStringEXT) \
  X(PFNEGLGETPLATFORMDISPLAYEXTPROC, GetPlatformDisplayEXT)

#define SWEPT_GL_FUNCTIONS(X)                                \
  X(PFNGLGETSTRINGPROC, GetString)                           \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                       \
  X(PFNGLGETINTEGER64VPROC, GetInteger64v)                   \
  X(PFNGLGETERRORPROC, GetError)                             \
  X(PFNGLGETGRAPHICSRESETSTATUSPROC, GetGraphicsResetStatus) \
  X(PFNGLCREATESHADERPROC, CreateShader)                     \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                     \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                   \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                       \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)             \
  X(PFNGLDELETESHADERPROC, DeleteShader)                     \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                   \
  X(PFNGLATTACHSHADERPROC, AttachShader)                     \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                       \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                     \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)           \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                   \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                         \
  X(PFNGLUNIFORM1UIPROC, Uniform1ui)                         \
  X(PFNGLUNIFORM3IPROC, Uniform3i)                           \
  X(PFNGLCREATEBUFFERSPROC, CreateBuffers)                   \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                   \
  X(PFNGLNAMEDBUFFERDATAPROC, NamedBufferData)               \
  X(PFNGLCLEARNAMEDBUFFERDATAPROC, ClearNamedBufferData)     \
  X(PFNGLGETNAMEDBUFFERSUBDATAPROC, GetNamedBufferSubData)   \
  X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                 \
  X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute)               \
  X(PFNGLMEMORYBARRIERPROC, MemoryBarrier)                   \
  X(PFNGLFENCESYNCPROC, FenceSync)                           \
  X(PFNGLCLIENTWAITSYNCPROC, ClientWaitSync)                 \
  X(PFNGLDELETESYNCPROC, DeleteSync)

struct EglApi {
#define SWEPT_MEMBER(type, name) type name = nullptr;
  SWEPT_EGL_FUNCTIONS(SWEPT_MEMBER)
  SWEPT_EGL_EXTENSIONS(SWEPT_MEMBER)
#undef SWEPT_MEMBER
  /// Returns false and the first missing name if a required entry point is missing.
  bool load(GlLoader& loader, std::string& missing);
};

struct GlApi {
#define SWEPT_MEMBER(type, name) type name = nullptr;
  SWEPT_GL_FUNCTIONS(SWEPT_MEMBER)
#undef SWEPT_MEMBER
  bool load(GlLoader& loader, std::string& missing);
};

}  // namespace swept::gl
