// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sampling/gl/gl_program.h"

#include <algorithm>
#include <vector>

#include "sampling/gl/shader_sources.h"
#include "swept/types.h"

namespace swept::gl {
namespace {

[[noreturn]] void failed(const GlContext& context, const std::string& what,
                         const std::string& log) {
  throw Error(Status::DeviceUnavailable, "ShaderFailed",
              what + " on " + context.device() +
                  "; the driver says: " + (log.empty() ? "(nothing)" : log) + kDeviceAdvice);
}

/// Returns the driver's log of a shader or a program. `getNumber` and `getLog`: the matching GL
/// functions.
template <class GetNumber, class GetLog>
std::string logOf(GetNumber getNumber, GetLog getLog, unsigned id) {
  GLint length = 0;
  getNumber(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 0)), '\0');
  if (length > 0) getLog(id, length, nullptr, log.data());
  return log.c_str();  // drops the zero bytes at the end
}

/// Compiles the compute shader made of these files.
unsigned compile(const GlContext& context, const std::vector<std::string>& files) {
  const GlApi& gl = context.gl();
  std::vector<const char*> parts{"#version 450 core\n"};
  for (const std::string& file : files) {
    const char* text = shaderSource(file);
    if (!text) throw Error(Status::InternalError, "InternalError", "no shader " + file);
    parts.push_back(text);
  }
  const unsigned shader = gl.CreateShader(GL_COMPUTE_SHADER);
  gl.ShaderSource(shader, static_cast<GLsizei>(parts.size()), parts.data(), nullptr);
  gl.CompileShader(shader);
  GLint done = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done) return shader;
  const std::string log = logOf(gl.GetShaderiv, gl.GetShaderInfoLog, shader);
  gl.DeleteShader(shader);
  std::string names;
  for (const std::string& file : files) names += (names.empty() ? "" : " + ") + file;
  failed(context, "shader " + names + " does not compile", log);
}

}  // namespace

Program::Program(const GlContext& context, const std::string& keep) : context_(context) {
  const GlApi& gl = context.gl();
  id_ = gl.CreateProgram();
  try {
    const unsigned shader =
        compile(context, {"common.glsl", "element.glsl", "exact.glsl", keep, "sample.comp"});
    gl.AttachShader(id_, shader);
    gl.DeleteShader(shader);  // the program keeps it alive
    gl.LinkProgram(id_);
    GLint done = 0;
    gl.GetProgramiv(id_, GL_LINK_STATUS, &done);
    if (done) return;
    failed(context, "the program of " + keep + " does not link",
           logOf(gl.GetProgramiv, gl.GetProgramInfoLog, id_));
  } catch (...) {
    gl.DeleteProgram(id_);
    throw;
  }
}

Program::~Program() { context_.gl().DeleteProgram(id_); }

}  // namespace swept::gl
