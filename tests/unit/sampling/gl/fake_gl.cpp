// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unit/sampling/gl/fake_gl.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "sampling/exact_element.h"

namespace swept::test {
namespace {

/// Bindings of the buffers in shaders/*.
enum Binding { kVertices, kTopology, kPlacements, kSteps, kExactSteps, kBalls, kMarks, kWinners };

struct State {
  FakeFaults faults;
  FakeCounts counts;
  int contextFences = 0;
  unsigned nextName = 1, program = 0;
  std::map<unsigned, std::string> sources;  // shader -> text
  std::map<unsigned, bool> findsWinners;    // program -> finds winners
  std::map<unsigned, std::vector<std::byte>> buffers;
  std::map<unsigned, unsigned> bound;  // binding -> buffer
  std::uint32_t uniforms[16] = {};
  int low[3] = {0, 0, 0}, size[3] = {0, 0, 0};
} state;

bool faulty() { return state.counts.contexts <= state.faults.faultyContexts; }
/// Returns the number of fences of this context, or of all contexts if every context is faulty.
int fencesSoFar() {
  return state.faults.faultyContexts < 1000 ? state.contextFences : state.counts.fences;
}
bool from(int nth, int count) { return nth > 0 && count >= nth; }
template <class T>
T* bufferAs(unsigned binding) {
  return reinterpret_cast<T*>(state.buffers[state.bound[binding]].data());
}

// --- EGL
EGLDisplay getDisplay(EGLNativeDisplayType) { return &state; }
EGLBoolean initialize(EGLDisplay, EGLint*, EGLint*) { return EGL_TRUE; }
const char* queryString(EGLDisplay display, EGLint) {
  return display ? "EGL_KHR_surfaceless_context EGL_KHR_no_config_context" : "";
}
EGLBoolean bindApi(EGLenum) { return EGL_TRUE; }
EGLenum queryApi() { return EGL_OPENGL_ES_API; }
EGLBoolean chooseConfig(EGLDisplay, const EGLint*, EGLConfig*, EGLint, EGLint* n) {
  *n = 1;
  return EGL_TRUE;
}
EGLContext createContext(EGLDisplay, EGLConfig, EGLContext, const EGLint*) {
  if (state.faults.noContext) return EGL_NO_CONTEXT;
  ++state.counts.contexts;
  ++state.counts.alive;
  state.contextFences = 0;
  return &state.counts;
}
EGLBoolean destroyContext(EGLDisplay, EGLContext) {
  --state.counts.alive;
  return EGL_TRUE;
}
EGLBoolean makeCurrent(EGLDisplay, EGLSurface, EGLSurface, EGLContext) { return EGL_TRUE; }
EGLContext currentContext() { return EGL_NO_CONTEXT; }
EGLDisplay currentDisplay() { return EGL_NO_DISPLAY; }
EGLSurface currentSurface(EGLint) { return EGL_NO_SURFACE; }
EGLint eglError() { return EGL_BAD_MATCH; }

// --- properties of the device
const GLubyte* getString(GLenum what) {
  static std::string text;
  text = what == GL_VENDOR ? "Nobody"
         : what == GL_RENDERER
             ? state.faults.renderer
             : std::to_string(state.faults.major) + "." + std::to_string(state.faults.minor);
  return reinterpret_cast<const GLubyte*>(text.c_str());
}
void getIntegerv(GLenum what, GLint* value) {
  switch (what) {
    case GL_MAJOR_VERSION:
      *value = state.faults.major;
      break;
    case GL_MINOR_VERSION:
      *value = state.faults.minor;
      break;
    case GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS:
      *value = state.faults.storageBlocks;
      break;
    default:
      *value = 32;
  }
}
void getInteger64v(GLenum, GLint64* value) { *value = state.faults.storageBytes; }
GLenum noError() { return GL_NO_ERROR; }
GLenum resetStatus() {
  const bool reset = faulty() && from(state.faults.resetFromFence, fencesSoFar());
  return reset ? GL_GUILTY_CONTEXT_RESET : GL_NO_ERROR;
}

// --- programs
GLuint createShader(GLenum) { return state.nextName++; }
void shaderSource(GLuint shader, GLsizei n, const GLchar* const* parts, const GLint*) {
  for (GLsizei i = 0; i < n; ++i) state.sources[shader] += parts[i];
}
void getShaderiv(GLuint shader, GLenum what, GLint* value) {
  const std::string& word = state.faults.brokenShader;
  const bool broken = !word.empty() && state.sources[shader].find(word) != std::string::npos;
  *value = what == GL_COMPILE_STATUS ? !broken : 64;
}
void infoLog(GLuint, GLsizei size, GLsizei*, GLchar* log) {
  std::strncpy(log, "0:7: unexpected identifier", static_cast<std::size_t>(size));
}
GLuint createProgram() {
  ++state.counts.programs;
  return state.nextName++;
}
void attachShader(GLuint program, GLuint shader) {
  if (state.sources[shader].find("secondRound") != std::string::npos) {
    state.findsWinners[program] = true;
  }
}
void getProgramiv(GLuint, GLenum what, GLint* value) {
  *value = what == GL_LINK_STATUS ? !state.faults.linkFails : 64;
}
void deleteProgram(GLuint) { --state.counts.programs; }
void useProgram(GLuint program) { state.program = program; }
void uniform1ui(GLint location, GLuint value) { state.uniforms[location] = value; }
void uniform3i(GLint location, GLint x, GLint y, GLint z) {
  int* target = location == 0 ? state.low : state.size;
  target[0] = x;
  target[1] = y;
  target[2] = z;
}

// --- memory
template <int FakeCounts::*Counter>
void create(GLsizei n, GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) names[i] = state.nextName++;
  state.counts.*Counter += n;
}
template <int FakeCounts::*Counter>
void destroy(GLsizei n, const GLuint* names) {
  for (GLsizei i = 0; i < n; ++i) state.counts.*Counter -= names[i] != 0;
}
void bufferData(GLuint name, GLsizeiptr bytes, const void* data, GLenum) {
  auto& buffer = state.buffers[name];
  buffer.assign(static_cast<std::size_t>(bytes), std::byte{0});
  if (data) std::memcpy(buffer.data(), data, buffer.size());
}
void clearBuffer(GLuint name, GLenum, GLenum, GLenum, const void*) {
  auto& buffer = state.buffers[name];
  std::fill(buffer.begin(), buffer.end(), std::byte{0});
}
/// Applies the faults to marks that are read back.
void spoilMarks(std::uint32_t* marks, std::size_t count) {
  const int nth = ++state.counts.markReadbacks;
  if (nth == state.faults.setOneBitAtReadback) {
    const auto words = static_cast<std::size_t>(state.size[2] + 31) / 32;
    marks[(static_cast<std::size_t>(state.size[1]) + 1) * words] |= 2u;
  }
  for (std::size_t n = 0; n < count; ++n) {
    if (from(state.faults.setBitsFromReadback, nth) && n % 97 == 0) marks[n] |= 2u;
    if (from(state.faults.clearBitsFromReadback, nth) && n % 7 == 0) marks[n] = 0;
  }
}
void readBuffer(GLuint name, GLintptr, GLsizeiptr bytes, void* data) {
  std::memcpy(data, state.buffers[name].data(), static_cast<std::size_t>(bytes));
  auto* words = static_cast<std::uint32_t*>(data);
  const auto count = static_cast<std::size_t>(bytes) / 4;
  if (name == state.bound[kMarks]) spoilMarks(words, count);
  if (name != state.bound[kWinners]) return;
  if (from(state.faults.wrongWinnerFromReadback, ++state.counts.winnerReadbacks)) {
    for (std::size_t n = 0; n < count; ++n) {
      if (n % 4 >= 2) words[n] ^= 1u;  // elements, not fractions
    }
  }
}
void bindBase(GLenum, GLuint binding, GLuint name) { state.bound[binding] = name; }
void ignoreName(GLuint) {}
void ignoreBits(GLbitfield) {}

// --- fences
GLsync fenceSync(GLenum, GLbitfield) {
  ++state.counts.fences;
  ++state.contextFences;
  return reinterpret_cast<GLsync>(&state);
}
GLenum waitSync(GLsync, GLbitfield, GLuint64) {
  const bool silent = faulty() && from(state.faults.silentFromFence, fencesSoFar());
  return silent ? GL_TIMEOUT_EXPIRED : GL_ALREADY_SIGNALED;
}
void deleteSync(GLsync) {}

// --- the work of shaders/, without culling
SnappedPoint corner(std::uint32_t placement, std::int32_t vertex) {
  const double* rows =
      bufferAs<double>(kPlacements) + 12 * std::size_t{placement - state.uniforms[2]};
  const double* v = bufferAs<double>(kVertices) + 3 * vertex;
  SnappedPoint p;
  for (int axis = 0; axis < 3; ++axis, rows += 4) {
    p[axis] = snapCoordinate(((rows[0] * v[0] + rows[1] * v[1]) + rows[2] * v[2]) + rows[3]);
  }
  return p;
}
void keepWinner(std::uint32_t row, std::uint32_t k, std::uint32_t fraction, std::uint32_t id) {
  const auto* starts = bufferAs<std::uint32_t>(kMarks);
  const std::uint32_t* targets = starts + 3 * state.size[0] * state.size[1] + 1;
  const auto* end = targets + starts[row + 1];
  const auto* at = std::lower_bound(targets + starts[row], end, k);
  if (at == end || *at != k) return;
  std::uint32_t* winner = bufferAs<std::uint32_t>(kWinners) + 4 * (at - targets);
  if (state.uniforms[10] == 0) {
    winner[0] = std::min(winner[0], fraction);
    winner[1] = std::max(winner[1], fraction);
  } else {
    if (fraction == winner[0]) winner[2] = std::min(winner[2], id);
    if (fraction == winner[1]) winner[3] = std::min(winner[3], id);
  }
}
void sampleElement(std::uint32_t number) {
  const std::uint32_t* u = state.uniforms;
  const std::uint32_t placement = u[2] + number / u[5], local = number % u[5], id = u[9] + number;
  const auto emit = [&](int axis, std::int32_t i, std::int32_t j, std::int32_t k, double f) {
    const std::int32_t p[3] = {i - state.low[0], j - state.low[1], k - state.low[2]};
    for (int x = 0; x < 3; ++x) {
      if (p[x] < 0 || p[x] >= state.size[x]) return;
    }
    const auto words = static_cast<std::uint32_t>(state.size[2] + 31) / 32;
    const auto row =
        static_cast<std::uint32_t>((axis * state.size[0] + p[0]) * state.size[1] + p[1]);
    if (state.findsWinners[state.program]) {
      keepWinner(row, static_cast<std::uint32_t>(p[2]), static_cast<std::uint32_t>(f * 8388607.0),
                 id);
    } else {
      bufferAs<std::uint32_t>(kMarks)[row * words + static_cast<std::uint32_t>(p[2]) / 32] |=
          1u << (p[2] & 31);
    }
  };
  const auto* topology = bufferAs<std::int32_t>(kTopology);
  if (local >= u[4]) {
    if (placement + 1 >= u[3]) return;
    const std::int32_t* edge = topology + 3 * u[4] + 4 * (local - u[4]);
    const SnappedPoint a = corner(placement, edge[0]), b = corner(placement, edge[1]),
                       c = corner(placement + 1, edge[1]), d = corner(placement + 1, edge[0]);
    rasteriseAllAxes(a, b, c, emit);
    rasteriseAllAxes(a, c, d, emit);
  } else {
    const std::int32_t* t = topology + 3 * local;
    rasteriseAllAxes(corner(placement, t[0]), corner(placement, t[1]), corner(placement, t[2]),
                     emit);
  }
}
void dispatch(GLuint, GLuint, GLuint) {
  ++state.counts.dispatches;
  for (std::uint32_t n = 0; n < state.uniforms[8]; ++n) sampleElement(state.uniforms[7] + n);
}

template <class F>
void* address(F* function) {
  return reinterpret_cast<void*>(function);
}

const std::map<std::string, void*>& functions() {
  static const std::map<std::string, void*> all = {
      {"eglGetDisplay", address(getDisplay)},
      {"eglInitialize", address(initialize)},
      {"eglQueryString", address(queryString)},
      {"eglBindAPI", address(bindApi)},
      {"eglQueryAPI", address(queryApi)},
      {"eglChooseConfig", address(chooseConfig)},
      {"eglCreateContext", address(createContext)},
      {"eglDestroyContext", address(destroyContext)},
      {"eglMakeCurrent", address(makeCurrent)},
      {"eglGetCurrentContext", address(currentContext)},
      {"eglGetCurrentDisplay", address(currentDisplay)},
      {"eglGetCurrentSurface", address(currentSurface)},
      {"eglGetError", address(eglError)},
      {"glGetString", address(getString)},
      {"glGetIntegerv", address(getIntegerv)},
      {"glGetInteger64v", address(getInteger64v)},
      {"glGetError", address(noError)},
      {"glGetGraphicsResetStatus", address(resetStatus)},
      {"glCreateShader", address(createShader)},
      {"glShaderSource", address(shaderSource)},
      {"glCompileShader", address(ignoreName)},
      {"glGetShaderiv", address(getShaderiv)},
      {"glGetShaderInfoLog", address(infoLog)},
      {"glDeleteShader", address(ignoreName)},
      {"glCreateProgram", address(createProgram)},
      {"glAttachShader", address(attachShader)},
      {"glLinkProgram", address(ignoreName)},
      {"glGetProgramiv", address(getProgramiv)},
      {"glGetProgramInfoLog", address(infoLog)},
      {"glDeleteProgram", address(deleteProgram)},
      {"glUseProgram", address(useProgram)},
      {"glUniform1ui", address(uniform1ui)},
      {"glUniform3i", address(uniform3i)},
      {"glCreateBuffers", address(create<&FakeCounts::buffers>)},
      {"glDeleteBuffers", address(destroy<&FakeCounts::buffers>)},
      {"glNamedBufferData", address(bufferData)},
      {"glClearNamedBufferData", address(clearBuffer)},
      {"glGetNamedBufferSubData", address(readBuffer)},
      {"glBindBufferBase", address(bindBase)},
      {"glDispatchCompute", address(dispatch)},
      {"glMemoryBarrier", address(ignoreBits)},
      {"glFenceSync", address(fenceSync)},
      {"glClientWaitSync", address(waitSync)},
      {"glDeleteSync", address(deleteSync)},
  };
  return all;
}

class FakeLoader : public gl::GlLoader {
 public:
  bool open(std::string& why) override {
    if (state.faults.noLibrary) why = "the EGL library cannot be loaded (libEGL.so.1: none here)";
    return !state.faults.noLibrary;
  }
  void* find(const char* name) override {
    const auto found = functions().find(name);
    if (found == functions().end() || state.faults.missingFunction == name) return nullptr;
    return found->second;
  }
};

}  // namespace

std::shared_ptr<gl::GlLoader> makeFakeGl(const FakeFaults& faults) {
  state = State{};
  state.faults = faults;
  return std::make_shared<FakeLoader>();
}

const FakeCounts& fakeCounts() { return state.counts; }

}  // namespace swept::test
