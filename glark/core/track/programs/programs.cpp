// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of shaders and programs. The sources that a program was linked from are kept, because an application may delete
// its shader objects right after linking.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "glark/core/objects/resource_name.h"
#include "glark/core/report/log.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// The program is one that transform feedback captures from. GL sees a program of ours there. Raises the error of GL.
bool refused_while_it_captures(Context& c, GLuint program) {
  const bool refuses = c.stages() != nullptr && c.stages()->feedback().refuses_link(program);
  if (refuses) {
    c.pending_error().raise(GL_INVALID_OPERATION);
  }
  return refuses;
}

GLint register_virtual_uniform(Context& c, Program& program, const GLchar* name) {
  const std::lock_guard lock(program.mutex);
  const std::shared_ptr<DerivedProgram> derived = c.stages()->planner().derive_for_status(program, &program);
  const std::string text(name);
  if (derived == nullptr || text.rfind("gl_", 0) == 0 || text.rfind("glark_", 0) == 0 ||
      c.gl().GetUniformLocation(derived->name, name) < 0) {
    return -1;
  }
  std::size_t index = 0;
  while (index < program.virtual_uniforms.size() && program.virtual_uniforms[index] != text) {
    ++index;
  }
  if (index == program.virtual_uniforms.size()) {
    program.virtual_uniforms.push_back(text);
    for (const auto& [key, variant] : program.derived) {
      if (variant != nullptr) {
        variant->virtual_location_of.push_back(c.gl().GetUniformLocation(variant->name, name));
      }
    }
  }
  return virtual_location_base + static_cast<GLint>(index);
}

}  // namespace

namespace hook {

void CompileShader(Context& c, GLuint shader) {
  c.gl().CompileShader(shader);
  c.state().programs().compiled(shader);
}

void CompileShaderIncludeARB(Context& c, GLuint shader, GLsizei count, const GLchar* const* path, const GLint* length) {
  std::vector<std::string> paths;
  for (GLsizei i = 0; i < count && path != nullptr && path[i] != nullptr; ++i) {
    const bool terminated = length == nullptr || length[i] < 0;
    paths.push_back(terminated ? std::string(path[i]) : std::string(path[i], static_cast<std::size_t>(length[i])));
  }
  c.gl().CompileShaderIncludeARB(shader, count, path, length);
  c.state().programs().compiled(shader, paths);
}

void SpecializeShader(Context& c, GLuint shader, const GLchar* entry_point, GLuint constants, const GLuint* indices,
                      const GLuint* values) {
  c.gl().SpecializeShader(shader, entry_point, constants, indices, values);
  c.state().programs().specialized(shader);
}

void LinkProgram(Context& c, GLuint program) {
  if (refused_while_it_captures(c, program)) {
    return;
  }
  c.gl().LinkProgram(program);
  c.state().programs().linked(program);
}

// A binary of a program that was linked here brings its sources with it. Any other binary has none. Transparent
// refinement refuses it, which OpenGL 4.6, 7.5 allows at any time: applications then compile their shaders again.
void ProgramBinary(Context& c, GLuint program, GLenum format, const void* binary, GLsizei length) {
  if (refused_while_it_captures(c, program)) {
    return;
  }
  std::vector<StageSource> stages = c.share().binaries.find(binary, length);
  if (stages.empty() && c.options().transparent && c.capabilities().refinable && length > 0) {
    constexpr std::array<unsigned char, 64> no_binary{};
    c.gl().ProgramBinary(program, format, no_binary.data(), std::min<GLsizei>(length, no_binary.size()));
    log(LogLevel::info, "refused the cached binary of program " + std::to_string(program) +
                            ": it has no sources to refine; the application compiles its shaders again");
  } else {
    c.gl().ProgramBinary(program, format, binary, length);
  }
  c.state().programs().linked(program, std::move(stages));
}

void GetProgramBinary(Context& c, GLuint program, GLsizei size, GLsizei* length, GLenum* format, void* binary) {
  GLsizei written = 0;
  c.gl().GetProgramBinary(program, size, &written, format, binary);
  if (length != nullptr) {
    *length = written;
  }
  const std::shared_ptr<Program> known = c.capabilities().refinable ? c.state().programs().find(program) : nullptr;
  if (known != nullptr && written > 0) {
    const std::lock_guard lock(known->mutex);
    c.share().binaries.remember(binary, written, known->stages);
  }
}

GLuint CreateShaderProgramv(Context& c, GLenum type, GLsizei count, const GLchar* const* strings) {
  const GLuint program = c.gl().CreateShaderProgramv(type, count, strings);
  if (program != 0 && c.capabilities().refinable) {  // GL has already deleted its shader object
    std::string source;
    for (GLsizei i = 0; i < count; ++i) {
      source += strings[i];
    }
    c.state().programs().linked(program, {{type, std::make_shared<const std::string>(std::move(source))}});
  }
  return program;
}

void DeleteShader(Context& c, GLuint shader) {
  c.gl().DeleteShader(shader);
  c.state().programs().shader_deleted(shader);
}

void DeleteProgram(Context& c, GLuint program) {
  c.gl().DeleteProgram(program);
  if (c.capabilities().refinable) {
    c.state().programs().deleted(program);
  }
}

void DeleteObjectARB(Context& c, GLhandleARB object) {
  c.gl().DeleteObjectARB(object);
  if (c.capabilities().refinable) {
    c.state().programs().deleted(static_cast<GLuint>(object));
  }
}

void UniformBlockBinding(Context& c, GLuint program, GLuint index, GLuint binding) {
  c.gl().UniformBlockBinding(program, index, binding);
  if (c.state().programs().mirroring()) {
    for (const UniformMirror& mirror : c.state().programs().mirrors(c.state().bindings(), program)) {
      const std::string name = resource_name(c.gl(), program, GL_UNIFORM_BLOCK, index);
      const GLuint own = c.gl().GetUniformBlockIndex(mirror.program, name.c_str());
      if (own != GL_INVALID_INDEX) {
        c.gl().UniformBlockBinding(mirror.program, own, binding);
      }
    }
  }
}

void ShaderStorageBlockBinding(Context& c, GLuint program, GLuint index, GLuint binding) {
  c.gl().ShaderStorageBlockBinding(program, index, binding);
  if (c.state().programs().mirroring()) {
    for (const UniformMirror& mirror : c.state().programs().mirrors(c.state().bindings(), program)) {
      const std::string name = resource_name(c.gl(), program, GL_SHADER_STORAGE_BLOCK, index);
      const GLuint own = c.gl().GetProgramResourceIndex(mirror.program, GL_SHADER_STORAGE_BLOCK, name.c_str());
      if (own != GL_INVALID_INDEX) {
        c.gl().ShaderStorageBlockBinding(mirror.program, own, binding);
      }
    }
  }
}

GLint GetUniformLocation(Context& c, GLuint program, const GLchar* name) {
  const GLint location = c.gl().GetUniformLocation(program, name);
  if (location >= 0 || name == nullptr) {
    return location;
  }
  const std::shared_ptr<Program> known = c.capabilities().refinable ? c.state().programs().find(program) : nullptr;
  return known != nullptr && !known->refinement_source.empty() ? register_virtual_uniform(c, *known, name) : location;
}

}  // namespace hook
}  // namespace glark::core
