// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program/uniform_copy.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/objects/resource_name.h"

namespace glark::refine {
namespace {

constexpr GLint largest_table = 1 << 16;

struct ActiveUniform {
  std::string name;  // without "[0]"
  GLint size = 1;
  GLenum type = 0;
};

std::vector<ActiveUniform> active_uniforms(const gl::Dispatch& gl, GLuint program) {
  GLint count = 0;
  GLint longest = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
  std::string buffer(static_cast<std::size_t>(longest) + 1, '\0');
  std::vector<ActiveUniform> result;
  for (GLint i = 0; i < count; ++i) {
    ActiveUniform uniform;
    GLsizei length = 0;
    gl.GetActiveUniform(program, static_cast<GLuint>(i), static_cast<GLsizei>(buffer.size()), &length, &uniform.size,
                        &uniform.type, buffer.data());
    uniform.name = buffer.substr(0, static_cast<std::size_t>(length));
    if (uniform.name.size() > 3 && uniform.name.ends_with("[0]")) {
      uniform.name.resize(uniform.name.size() - 3);
    }
    result.push_back(std::move(uniform));
  }
  return result;
}

// Elements are located one by one: GL promises consecutive locations only for explicit ones.
std::string element_name(const ActiveUniform& uniform, GLint element) {
  return uniform.size == 1 && element == 0 ? uniform.name : uniform.name + "[" + std::to_string(element) + "]";
}

enum class Scalar { floating, integer, unsigned_integer, boolean_or_sampler, floating_double, integer_64, unsigned_64 };

struct Shape {
  Scalar scalar = Scalar::boolean_or_sampler;
  int columns = 1;
  int rows = 1;
};

struct ShapeOfType {
  GLenum type;
  Shape shape;
};
constexpr ShapeOfType shapes[] = {
    {GL_FLOAT, {Scalar::floating, 1, 1}},
    {GL_FLOAT_VEC2, {Scalar::floating, 1, 2}},
    {GL_FLOAT_VEC3, {Scalar::floating, 1, 3}},
    {GL_FLOAT_VEC4, {Scalar::floating, 1, 4}},
    {GL_FLOAT_MAT2, {Scalar::floating, 2, 2}},
    {GL_FLOAT_MAT3, {Scalar::floating, 3, 3}},
    {GL_FLOAT_MAT4, {Scalar::floating, 4, 4}},
    {GL_FLOAT_MAT2x3, {Scalar::floating, 2, 3}},
    {GL_FLOAT_MAT2x4, {Scalar::floating, 2, 4}},
    {GL_FLOAT_MAT3x2, {Scalar::floating, 3, 2}},
    {GL_FLOAT_MAT3x4, {Scalar::floating, 3, 4}},
    {GL_FLOAT_MAT4x2, {Scalar::floating, 4, 2}},
    {GL_FLOAT_MAT4x3, {Scalar::floating, 4, 3}},
    {GL_INT_VEC2, {Scalar::integer, 1, 2}},
    {GL_INT_VEC3, {Scalar::integer, 1, 3}},
    {GL_INT_VEC4, {Scalar::integer, 1, 4}},
    {GL_BOOL_VEC2, {Scalar::integer, 1, 2}},
    {GL_BOOL_VEC3, {Scalar::integer, 1, 3}},
    {GL_BOOL_VEC4, {Scalar::integer, 1, 4}},
    {GL_UNSIGNED_INT, {Scalar::unsigned_integer, 1, 1}},
    {GL_UNSIGNED_INT_VEC2, {Scalar::unsigned_integer, 1, 2}},
    {GL_UNSIGNED_INT_VEC3, {Scalar::unsigned_integer, 1, 3}},
    {GL_UNSIGNED_INT_VEC4, {Scalar::unsigned_integer, 1, 4}},
    {GL_DOUBLE, {Scalar::floating_double, 1, 1}},
    {GL_DOUBLE_VEC2, {Scalar::floating_double, 1, 2}},
    {GL_DOUBLE_VEC3, {Scalar::floating_double, 1, 3}},
    {GL_DOUBLE_VEC4, {Scalar::floating_double, 1, 4}},
    {GL_DOUBLE_MAT2, {Scalar::floating_double, 2, 2}},
    {GL_DOUBLE_MAT3, {Scalar::floating_double, 3, 3}},
    {GL_DOUBLE_MAT4, {Scalar::floating_double, 4, 4}},
    {GL_DOUBLE_MAT2x3, {Scalar::floating_double, 2, 3}},
    {GL_DOUBLE_MAT2x4, {Scalar::floating_double, 2, 4}},
    {GL_DOUBLE_MAT3x2, {Scalar::floating_double, 3, 2}},
    {GL_DOUBLE_MAT3x4, {Scalar::floating_double, 3, 4}},
    {GL_DOUBLE_MAT4x2, {Scalar::floating_double, 4, 2}},
    {GL_DOUBLE_MAT4x3, {Scalar::floating_double, 4, 3}},
    {GL_INT64_ARB, {Scalar::integer_64, 1, 1}},
    {GL_INT64_VEC2_ARB, {Scalar::integer_64, 1, 2}},
    {GL_INT64_VEC3_ARB, {Scalar::integer_64, 1, 3}},
    {GL_INT64_VEC4_ARB, {Scalar::integer_64, 1, 4}},
    {GL_UNSIGNED_INT64_ARB, {Scalar::unsigned_64, 1, 1}},
    {GL_UNSIGNED_INT64_VEC2_ARB, {Scalar::unsigned_64, 1, 2}},
    {GL_UNSIGNED_INT64_VEC3_ARB, {Scalar::unsigned_64, 1, 3}},
    {GL_UNSIGNED_INT64_VEC4_ARB, {Scalar::unsigned_64, 1, 4}},
};

Shape shape_of(GLenum type) {
  for (const ShapeOfType& row : shapes) {
    if (row.type == type) {
      return row.shape;
    }
  }
  return {};  // int, bool, samplers, images: one integer
}

// Whether one of the names is that of the uniform or of an element. The location of one element sets those after it, too.
bool names_any_of(const std::vector<std::string>& names, const ActiveUniform& uniform) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return name == uniform.name ||
           (name.starts_with(uniform.name) && name.find('[', uniform.name.size()) == uniform.name.size());
  });
}

void set_matrix(const gl::Dispatch& gl, GLuint program, GLint location, const Shape& shape, const GLfloat* value) {
  switch (shape.columns * 10 + shape.rows) {
    case 22: gl.ProgramUniformMatrix2fv(program, location, 1, GL_FALSE, value); break;
    case 33: gl.ProgramUniformMatrix3fv(program, location, 1, GL_FALSE, value); break;
    case 44: gl.ProgramUniformMatrix4fv(program, location, 1, GL_FALSE, value); break;
    case 23: gl.ProgramUniformMatrix2x3fv(program, location, 1, GL_FALSE, value); break;
    case 24: gl.ProgramUniformMatrix2x4fv(program, location, 1, GL_FALSE, value); break;
    case 32: gl.ProgramUniformMatrix3x2fv(program, location, 1, GL_FALSE, value); break;
    case 34: gl.ProgramUniformMatrix3x4fv(program, location, 1, GL_FALSE, value); break;
    case 42: gl.ProgramUniformMatrix4x2fv(program, location, 1, GL_FALSE, value); break;
    case 43: gl.ProgramUniformMatrix4x3fv(program, location, 1, GL_FALSE, value); break;
    default: break;
  }
}

void copy_floats(const gl::Dispatch& gl, GLuint from, GLint source, GLuint to, GLint target, const Shape& shape) {
  std::array<GLfloat, 16> value{};
  gl.GetUniformfv(from, source, value.data());
  if (shape.columns > 1) {
    set_matrix(gl, to, target, shape, value.data());
    return;
  }
  switch (shape.rows) {
    case 1: gl.ProgramUniform1fv(to, target, 1, value.data()); break;
    case 2: gl.ProgramUniform2fv(to, target, 1, value.data()); break;
    case 3: gl.ProgramUniform3fv(to, target, 1, value.data()); break;
    default: gl.ProgramUniform4fv(to, target, 1, value.data()); break;
  }
}

void copy_doubles(const gl::Dispatch& gl, GLuint from, GLint source, GLuint to, GLint target, const Shape& shape) {
  std::array<GLdouble, 16> value{};
  gl.GetUniformdv(from, source, value.data());
  switch (shape.columns * 10 + shape.rows) {
    case 11: gl.ProgramUniform1dv(to, target, 1, value.data()); break;
    case 12: gl.ProgramUniform2dv(to, target, 1, value.data()); break;
    case 13: gl.ProgramUniform3dv(to, target, 1, value.data()); break;
    case 14: gl.ProgramUniform4dv(to, target, 1, value.data()); break;
    case 22: gl.ProgramUniformMatrix2dv(to, target, 1, GL_FALSE, value.data()); break;
    case 33: gl.ProgramUniformMatrix3dv(to, target, 1, GL_FALSE, value.data()); break;
    case 23: gl.ProgramUniformMatrix2x3dv(to, target, 1, GL_FALSE, value.data()); break;
    case 24: gl.ProgramUniformMatrix2x4dv(to, target, 1, GL_FALSE, value.data()); break;
    case 32: gl.ProgramUniformMatrix3x2dv(to, target, 1, GL_FALSE, value.data()); break;
    case 34: gl.ProgramUniformMatrix3x4dv(to, target, 1, GL_FALSE, value.data()); break;
    case 42: gl.ProgramUniformMatrix4x2dv(to, target, 1, GL_FALSE, value.data()); break;
    case 43: gl.ProgramUniformMatrix4x3dv(to, target, 1, GL_FALSE, value.data()); break;
    default: gl.ProgramUniformMatrix4dv(to, target, 1, GL_FALSE, value.data()); break;
  }
}

void copy_integers(const gl::Dispatch& gl, GLuint from, GLint source, GLuint to, GLint target, const Shape& shape) {
  std::array<GLint, 4> value{};
  gl.GetUniformiv(from, source, value.data());
  switch (shape.rows) {
    case 1: gl.ProgramUniform1iv(to, target, 1, value.data()); break;
    case 2: gl.ProgramUniform2iv(to, target, 1, value.data()); break;
    case 3: gl.ProgramUniform3iv(to, target, 1, value.data()); break;
    default: gl.ProgramUniform4iv(to, target, 1, value.data()); break;
  }
}

void copy_unsigned(const gl::Dispatch& gl, GLuint from, GLint source, GLuint to, GLint target, const Shape& shape) {
  std::array<GLuint, 4> value{};
  gl.GetUniformuiv(from, source, value.data());
  switch (shape.rows) {
    case 1: gl.ProgramUniform1uiv(to, target, 1, value.data()); break;
    case 2: gl.ProgramUniform2uiv(to, target, 1, value.data()); break;
    case 3: gl.ProgramUniform3uiv(to, target, 1, value.data()); break;
    default: gl.ProgramUniform4uiv(to, target, 1, value.data()); break;
  }
}

void copy_integers_64(const gl::Dispatch& gl, GLuint from, GLint source, GLuint to, GLint target, const Shape& shape) {
  std::array<GLint64, 4> value{};
  if (gl.GetUniformi64vARB == nullptr) {
    return;  // NV_gpu_shader5 alone
  }
  gl.GetUniformi64vARB(from, source, value.data());
  switch (shape.rows) {
    case 1: gl.ProgramUniform1i64vARB(to, target, 1, value.data()); break;
    case 2: gl.ProgramUniform2i64vARB(to, target, 1, value.data()); break;
    case 3: gl.ProgramUniform3i64vARB(to, target, 1, value.data()); break;
    default: gl.ProgramUniform4i64vARB(to, target, 1, value.data()); break;
  }
}

void copy_unsigned_64(const gl::Dispatch& gl, GLuint from, GLint source, GLuint to, GLint target, const Shape& shape) {
  std::array<GLuint64, 4> value{};
  if (gl.GetUniformui64vARB == nullptr) {
    return;
  }
  gl.GetUniformui64vARB(from, source, value.data());
  switch (shape.rows) {
    case 1: gl.ProgramUniform1ui64vARB(to, target, 1, value.data()); break;
    case 2: gl.ProgramUniform2ui64vARB(to, target, 1, value.data()); break;
    case 3: gl.ProgramUniform3ui64vARB(to, target, 1, value.data()); break;
    default: gl.ProgramUniform4ui64vARB(to, target, 1, value.data()); break;
  }
}

void set_handle(const gl::Dispatch& gl, GLuint program, GLint location, GLuint64 handle) {
  const auto set =
      gl.ProgramUniformHandleui64ARB != nullptr ? gl.ProgramUniformHandleui64ARB : gl.ProgramUniformHandleui64NV;
  set(program, location, handle);
}

void copy_value(const gl::Dispatch& gl, GLuint from, GLint source, GLuint to, GLint target, GLenum type) {
  const Shape shape = shape_of(type);
  switch (shape.scalar) {
    case Scalar::floating: copy_floats(gl, from, source, to, target, shape); break;
    case Scalar::floating_double: copy_doubles(gl, from, source, to, target, shape); break;
    case Scalar::unsigned_integer: copy_unsigned(gl, from, source, to, target, shape); break;
    case Scalar::integer_64: copy_integers_64(gl, from, source, to, target, shape); break;
    case Scalar::unsigned_64: copy_unsigned_64(gl, from, source, to, target, shape); break;
    case Scalar::integer:
    case Scalar::boolean_or_sampler: copy_integers(gl, from, source, to, target, shape); break;
  }
}

void copy_fragment_outputs(const gl::Dispatch& gl, GLuint from, GLuint to) {
  if (gl.BindFragDataLocationIndexed == nullptr || gl.GetProgramInterfaceiv == nullptr) {
    return;
  }
  GLint count = 0;
  gl.GetProgramInterfaceiv(from, GL_PROGRAM_OUTPUT, GL_ACTIVE_RESOURCES, &count);
  for (GLint i = 0; i < count; ++i) {
    const std::string name = core::resource_name(gl, from, GL_PROGRAM_OUTPUT, static_cast<GLuint>(i));
    if (name.rfind("gl_", 0) == 0) {
      continue;
    }
    const GLint location = gl.GetProgramResourceLocation(from, GL_PROGRAM_OUTPUT, name.c_str());
    const GLint index = gl.GetProgramResourceLocationIndex(from, GL_PROGRAM_OUTPUT, name.c_str());
    if (location >= 0) {
      const std::string base = name.ends_with("[0]") ? name.substr(0, name.size() - 3) : name;
      gl.BindFragDataLocationIndexed(to, static_cast<GLuint>(location), index > 0 ? static_cast<GLuint>(index) : 0U,
                                     base.c_str());
    }
  }
}

void set_feedback_varyings(const gl::Dispatch& gl, const core::LinkSettings& settings, GLuint to) {
  std::vector<const char*> names;
  for (const core::FeedbackVarying& varying : settings.feedback_varyings) {
    names.push_back(varying.name.c_str());
  }
  if (!names.empty()) {
    gl.TransformFeedbackVaryings(to, static_cast<GLsizei>(names.size()), names.data(), settings.feedback_mode);
  }
}

}  // namespace

void copy_link_settings(const gl::Dispatch& gl, const core::Program& from, GLuint to) {
  const core::LinkSettings& settings = from.link_settings;
  // If the application's program has no vertex shader, the fixed function's stage stands in. It does not redeclare
  // gl_PerVertex, as a separable program must.
  const bool separable = settings.separable && from.has_stage(GL_VERTEX_SHADER);
  gl.ProgramParameteri(to, GL_PROGRAM_SEPARABLE, separable ? GL_TRUE : GL_FALSE);
  copy_fragment_outputs(gl, from.name, to);
  set_feedback_varyings(gl, settings, to);
  for (std::size_t i = 0; i < settings.geometry.size(); ++i) {
    if (settings.geometry[i] >= 0) {
      gl.ProgramParameteri(to, core::geometry_parameters[i], settings.geometry[i]);
    }
  }
}

void map_uniform_locations(const gl::Dispatch& gl, GLuint from, core::DerivedProgram& derived) {
  derived.location_of.clear();
  for (const ActiveUniform& uniform : active_uniforms(gl, from)) {
    for (GLint element = 0; element < uniform.size; ++element) {
      const std::string name = element_name(uniform, element);
      const GLint source = gl.GetUniformLocation(from, name.c_str());
      if (source < 0 || source >= largest_table) {
        continue;  // in a block, or built-in
      }
      if (static_cast<std::size_t>(source) >= derived.location_of.size()) {
        derived.location_of.resize(static_cast<std::size_t>(source) + 1, -1);
      }
      derived.location_of[static_cast<std::size_t>(source)] = gl.GetUniformLocation(derived.name, name.c_str());
    }
  }
}

void copy_uniform_values(const gl::Dispatch& gl, GLuint from, const core::DerivedProgram& derived,
                         const std::map<GLint, GLuint64>& handles) {
  for (const ActiveUniform& uniform : active_uniforms(gl, from)) {
    for (GLint element = 0; element < uniform.size; ++element) {
      const GLint source = gl.GetUniformLocation(from, element_name(uniform, element).c_str());
      if (source < 0 || static_cast<std::size_t>(source) >= derived.location_of.size()) {
        continue;
      }
      const GLint target = derived.location_of[static_cast<std::size_t>(source)];
      if (const auto handle = handles.find(source); target >= 0 && handle != handles.end()) {
        set_handle(gl, derived.name, target, handle->second);
      } else if (target >= 0) {
        copy_value(gl, from, source, derived.name, target, uniform.type);
      }
    }
  }
}

std::optional<std::vector<std::string>> plain_uniforms(const gl::Dispatch& gl, GLuint program, const std::string& but) {
  for (const GLenum blocks : {GL_UNIFORM_BLOCK, GL_SHADER_STORAGE_BLOCK, GL_ATOMIC_COUNTER_BUFFER}) {
    GLint count = 0;
    gl.GetProgramInterfaceiv(program, blocks, GL_ACTIVE_RESOURCES, &count);
    if (count > 0) {
      return std::nullopt;
    }
  }
  std::vector<std::string> names;
  for (const ActiveUniform& uniform : active_uniforms(gl, program)) {
    if (uniform.name == but) {
      continue;
    }
    const bool boolean = uniform.type == GL_BOOL || (uniform.type >= GL_BOOL_VEC2 && uniform.type <= GL_BOOL_VEC4);
    if (uniform.name.starts_with("gl_") || (!boolean && capture::words_of(uniform.type) == 0)) {
      return std::nullopt;
    }
    for (GLint element = 0; element < uniform.size; ++element) {
      names.push_back(element_name(uniform, element));
    }
  }
  return names;
}

void copy_virtual_uniforms(const gl::Dispatch& gl, const std::vector<std::string>& names,
                           const core::DerivedProgram* other, core::DerivedProgram& derived) {
  for (const std::string& name : names) {
    derived.virtual_location_of.push_back(gl.GetUniformLocation(derived.name, name.c_str()));
  }
  if (other == nullptr || names.empty()) {
    return;
  }
  for (const ActiveUniform& uniform : active_uniforms(gl, derived.name)) {
    if (!names_any_of(names, uniform)) {
      continue;
    }
    for (GLint element = 0; element < uniform.size; ++element) {
      const std::string name = element_name(uniform, element);
      const GLint source = gl.GetUniformLocation(other->name, name.c_str());
      const GLint target = gl.GetUniformLocation(derived.name, name.c_str());
      if (source >= 0 && target >= 0) {
        copy_value(gl, other->name, source, derived.name, target, uniform.type);
      }
    }
  }
}

void copy_block_bindings(const gl::Dispatch& gl, GLuint from, GLuint to) {
  GLint count = 0;
  gl.GetProgramiv(from, GL_ACTIVE_UNIFORM_BLOCKS, &count);
  for (GLint i = 0; i < count; ++i) {
    const std::string name = core::resource_name(gl, from, GL_UNIFORM_BLOCK, static_cast<GLuint>(i));
    const GLuint index = gl.GetUniformBlockIndex(to, name.c_str());
    GLint binding = 0;
    gl.GetActiveUniformBlockiv(from, static_cast<GLuint>(i), GL_UNIFORM_BLOCK_BINDING, &binding);
    if (index != GL_INVALID_INDEX) {
      gl.UniformBlockBinding(to, index, static_cast<GLuint>(binding));
    }
  }
  if (gl.ShaderStorageBlockBinding == nullptr) {
    return;
  }
  gl.GetProgramInterfaceiv(from, GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &count);
  for (GLint i = 0; i < count; ++i) {
    const std::string name = core::resource_name(gl, from, GL_SHADER_STORAGE_BLOCK, static_cast<GLuint>(i));
    const GLuint index = gl.GetProgramResourceIndex(to, GL_SHADER_STORAGE_BLOCK, name.c_str());
    const GLenum property = GL_BUFFER_BINDING;
    GLint binding = 0;
    gl.GetProgramResourceiv(from, GL_SHADER_STORAGE_BLOCK, static_cast<GLuint>(i), 1, &property, 1, nullptr, &binding);
    if (index != GL_INVALID_INDEX) {
      gl.ShaderStorageBlockBinding(to, index, static_cast<GLuint>(binding));
    }
  }
}

}  // namespace glark::refine
