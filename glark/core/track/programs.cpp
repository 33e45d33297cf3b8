// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of shaders and programs: the sources a program was linked from are kept, since an application may delete its
// shader objects right after linking.
#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

std::shared_ptr<const std::string> read_source(const gl::Dispatch& gl, GLuint shader) {
  GLint length = 0;
  gl.GetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
  if (length <= 1) {
    return nullptr;
  }
  std::string source(static_cast<std::size_t>(length), '\0');
  GLsizei written = 0;
  gl.GetShaderSource(shader, length, &written, source.data());
  source.resize(static_cast<std::size_t>(written));
  return std::make_shared<const std::string>(std::move(source));
}

std::vector<StageSource> read_stages(Context& c, GLuint program) {
  GLint count = 0;
  c.gl.GetProgramiv(program, GL_ATTACHED_SHADERS, &count);
  std::vector<GLuint> shaders(static_cast<std::size_t>(count));
  if (count > 0) {
    c.gl.GetAttachedShaders(program, count, nullptr, shaders.data());
  }
  std::vector<StageSource> stages;
  for (const GLuint shader : shaders) {
    GLint stage = 0;
    c.gl.GetShaderiv(shader, GL_SHADER_TYPE, &stage);
    std::shared_ptr<const std::string> source;
    {
      const std::lock_guard lock(c.share->mutex);
      const auto found = c.share->compiled_sources.find(shader);
      source = found != c.share->compiled_sources.end() ? found->second : nullptr;
    }
    source = source != nullptr ? source : read_source(c.gl, shader);
    if (source == nullptr || source->empty()) {
      return {};  // a binary or SPIR-V stage
    }
    stages.push_back({static_cast<GLenum>(stage), source});
  }
  return stages;
}

// By the words that every store of a shader needs; one too many costs captures.
bool may_store(const std::vector<StageSource>& stages) {
  constexpr std::string_view words[] = {"buffer", "image", "atomic", "store"};
  return std::any_of(stages.begin(), stages.end(), [&](const StageSource& stage) {
    return std::any_of(std::begin(words), std::end(words),
                       [&](std::string_view word) { return stage.source->find(word) != std::string::npos; });
  });
}

// The stages of a program as it was just linked; what was derived from the old ones goes.
void record_link(Context& c, GLuint name, std::vector<StageSource> stages) {
  if (!c.capabilities.refinable || c.gl.IsProgram(name) == GL_FALSE) {
    return;
  }
  std::shared_ptr<Program> program;
  {
    const std::lock_guard lock(c.share->mutex);
    std::shared_ptr<Program>& slot = c.share->programs[name];
    slot = slot != nullptr ? slot : std::make_shared<Program>();
    program = slot;
  }
  const std::lock_guard lock(program->mutex);
  c.pipeline->discard(*program);
  c.pipeline->forget_program(name);
  program->name = name;
  program->stages = std::move(stages);
  program->from_binary = program->stages.empty();
  program->may_store = program->from_binary || may_store(program->stages);
  GLint linked = GL_FALSE;
  c.gl.GetProgramiv(name, GL_LINK_STATUS, &linked);
  program->linked = linked != GL_FALSE;
  program->subroutines_asked = false;
  c.subroutines_known = false;
}

void forget_deleted(Context& c, GLuint name) {
  std::shared_ptr<Program> program;
  {
    const std::lock_guard lock(c.share->mutex);
    const auto found = c.share->programs.find(name);
    if (found == c.share->programs.end()) {
      return;
    }
    program = found->second;
    c.share->programs.erase(found);
  }
  const std::lock_guard lock(program->mutex);
  c.pipeline->discard(*program);
  c.pipeline->forget_program(name);
  // Still in use: GL keeps it until another one is. We could not return to it after a refined draw.
  program->prepared = true;
  program->cause = Cause::program_gone;
}

GLint register_virtual_uniform(Context& c, Program& program, const GLchar* name) {
  const std::lock_guard lock(program.mutex);
  const std::shared_ptr<DerivedProgram> derived = c.pipeline->derived_for(program, &program);
  const std::string text(name);
  if (derived == nullptr || text.rfind("gl_", 0) == 0 || text.rfind("glark_", 0) == 0 ||
      c.gl.GetUniformLocation(derived->name, name) < 0) {
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
        variant->virtual_location_of.push_back(c.gl.GetUniformLocation(variant->name, name));
      }
    }
  }
  return virtual_location_base + static_cast<GLint>(index);
}

}  // namespace

namespace track {

std::shared_ptr<Program> find_program(const Context& c, GLuint name) {
  const std::lock_guard lock(c.share->mutex);
  const auto found = c.share->programs.find(name);
  return found != c.share->programs.end() ? found->second : nullptr;
}

std::shared_ptr<Program> known_program(Context& c, GLuint name) {
  std::shared_ptr<Program> program = find_program(c, name);
  if (program == nullptr) {
    ErrorScope errors(c);
    record_link(c, name, read_stages(c, name));
    program = find_program(c, name);
  }
  return program;
}

void adopt_current_program(Context& c) {
  const GLuint name = c.bindings.program;
  c.current_program = name != 0 ? known_program(c, name) : nullptr;
  c.mirror_uniforms = c.share->any_derived.load(std::memory_order_relaxed);
}

}  // namespace track

namespace hook {

void CompileShader(Context& c, GLuint shader) {
  c.gl.CompileShader(shader);
  if (!c.capabilities.refinable || c.gl.IsShader(shader) == GL_FALSE) {
    return;
  }
  std::shared_ptr<const std::string> source = read_source(c.gl, shader);
  const std::lock_guard lock(c.share->mutex);
  c.share->compiled_sources[shader] = std::move(source);
}

// SPIR-V takes the place of any source that the shader had.
void SpecializeShader(Context& c, GLuint shader, const GLchar* entry_point, GLuint constants, const GLuint* indices,
                      const GLuint* values) {
  c.gl.SpecializeShader(shader, entry_point, constants, indices, values);
  const std::lock_guard lock(c.share->mutex);
  c.share->compiled_sources[shader] = std::make_shared<const std::string>();
}

void LinkProgram(Context& c, GLuint program) {
  c.gl.LinkProgram(program);
  if (c.capabilities.refinable && c.gl.IsProgram(program) != GL_FALSE) {
    record_link(c, program, read_stages(c, program));
  }
}

void ProgramBinary(Context& c, GLuint program, GLenum format, const void* binary, GLsizei length) {
  c.gl.ProgramBinary(program, format, binary, length);
  record_link(c, program, {});
}

GLuint CreateShaderProgramv(Context& c, GLenum type, GLsizei count, const GLchar* const* strings) {
  const GLuint program = c.gl.CreateShaderProgramv(type, count, strings);
  if (program != 0 && c.capabilities.refinable) {  // its shader object is gone already
    std::string source;
    for (GLsizei i = 0; i < count; ++i) {
      source += strings[i];
    }
    record_link(c, program, {{type, std::make_shared<const std::string>(std::move(source))}});
  }
  return program;
}

void DeleteShader(Context& c, GLuint shader) {
  c.gl.DeleteShader(shader);
  // A shader that is still attached lives on and may be linked again; its source is read again then.
  const std::lock_guard lock(c.share->mutex);
  c.share->compiled_sources.erase(shader);
}

void DeleteProgram(Context& c, GLuint program) {
  c.gl.DeleteProgram(program);
  if (c.capabilities.refinable) {
    forget_deleted(c, program);
  }
}

void DeleteObjectARB(Context& c, GLhandleARB object) {
  c.gl.DeleteObjectARB(object);
  if (c.capabilities.refinable) {
    forget_deleted(c, static_cast<GLuint>(object));
  }
}

void UniformBlockBinding(Context& c, GLuint program, GLuint index, GLuint binding) {
  c.gl.UniformBlockBinding(program, index, binding);
  if (c.mirror_uniforms) {
    for (const UniformMirror& mirror : c.uniform_mirrors(program)) {
      std::string name(256, '\0');
      c.gl.GetActiveUniformBlockName(program, index, static_cast<GLsizei>(name.size()), nullptr, name.data());
      const GLuint own = c.gl.GetUniformBlockIndex(mirror.program, name.c_str());
      if (own != GL_INVALID_INDEX) {
        c.gl.UniformBlockBinding(mirror.program, own, binding);
      }
    }
  }
}

void ShaderStorageBlockBinding(Context& c, GLuint program, GLuint index, GLuint binding) {
  c.gl.ShaderStorageBlockBinding(program, index, binding);
  if (c.mirror_uniforms) {
    for (const UniformMirror& mirror : c.uniform_mirrors(program)) {
      std::string name(256, '\0');
      c.gl.GetProgramResourceName(program, GL_SHADER_STORAGE_BLOCK, index, static_cast<GLsizei>(name.size()), nullptr,
                                  name.data());
      const GLuint own = c.gl.GetProgramResourceIndex(mirror.program, GL_SHADER_STORAGE_BLOCK, name.c_str());
      if (own != GL_INVALID_INDEX) {
        c.gl.ShaderStorageBlockBinding(mirror.program, own, binding);
      }
    }
  }
}

GLint GetUniformLocation(Context& c, GLuint program, const GLchar* name) {
  const GLint location = c.gl.GetUniformLocation(program, name);
  if (location >= 0 || name == nullptr) {
    return location;
  }
  const std::shared_ptr<Program> known = c.capabilities.refinable ? track::find_program(c, program) : nullptr;
  return known != nullptr && !known->refinement_source.empty() ? register_virtual_uniform(c, *known, name) : location;
}

}  // namespace hook
}  // namespace glark::core
