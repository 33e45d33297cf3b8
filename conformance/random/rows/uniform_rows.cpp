// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Uniforms of every type, set in the program in use or in a named one.
#include <string>

#include "conformance/random/row.h"
#include "conformance/random/stage_program.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "uniforms";

// "Uniform3fv" and "ProgramUniform3fv" set u_3f, "UniformMatrix2x3fv" sets u_2x3f, "UniformMatrix2fv" u_2x2f.
std::string uniform_of(const char* command) {
  std::string type(command);
  type = type.substr(type.find_first_of("1234"));
  if (type.back() == 'v') type.pop_back();
  const bool is_square =
      std::string(command).find("Matrix") != std::string::npos && type.find('x') == std::string::npos;
  return "u_" + (is_square ? type.substr(0, 1) + "x" + type : type);
}

// An element of the array, and how many from there a command may set.
struct Elements {
  GLint location;
  GLsizei count;
};

Elements any_elements(World& w, GLuint program, const char* command) {
  const bool is_second = w.values.coin();
  const std::string name = uniform_of(command) + (is_second ? "[1]" : "[0]");
  const GLint location = gl.GetUniformLocation(program, name.c_str());
  return {location, is_second || w.values.coin() ? 1 : uniform_elements};
}

template <typename T>
const T* any_values(World& w) {
  static std::array<T, 2 * 16> values;
  for (T& each : values) each = w.values.plain<T>();
  return values.data();
}

template <auto Command, typename... Before>
void set(World& w, GLuint program, const char* name, Before... before) {
  using Arguments = CommandArguments<Command>;
  using Last = std::tuple_element_t<Arguments::count - 1, typename Arguments::Types>;
  const Elements elements = any_elements(w, program, name);
  if constexpr (!std::is_pointer_v<Last>) {
    call<Command>(w, before..., elements.location);
  } else {
    const Last values = any_values<std::remove_const_t<std::remove_pointer_t<Last>>>(w);
    if constexpr (Arguments::count - sizeof...(Before) == 4)
      (gl.*Command)(before..., elements.location, elements.count, static_cast<GLboolean>(w.values.coin()), values);
    else
      (gl.*Command)(before..., elements.location, elements.count, values);
  }
}

#define GLARK_UNIFORM(command, apis)                                                                                   \
  {#command, family, uniforms, [](World& w) { set<&GladGLContext::command>(w, w.program_in_use(), #command); }, apis}, \
  {                                                                                                                    \
    "Program" #command, family, uniforms,                                                                              \
        [](World& w) {                                                                                                 \
          const GLuint program = w.any_program();                                                                      \
          set<&GladGLContext::Program##command>(w, program, #command, program);                                        \
        },                                                                                                             \
        apis                                                                                                           \
  }

Rows vector_rows() {
  using enum Where;
  return {
      GLARK_UNIFORM(Uniform1f, every_api),     GLARK_UNIFORM(Uniform2f, every_api),
      GLARK_UNIFORM(Uniform3f, every_api),     GLARK_UNIFORM(Uniform4f, every_api),
      GLARK_UNIFORM(Uniform1i, every_api),     GLARK_UNIFORM(Uniform2i, every_api),
      GLARK_UNIFORM(Uniform3i, every_api),     GLARK_UNIFORM(Uniform4i, every_api),
      GLARK_UNIFORM(Uniform1ui, every_api),    GLARK_UNIFORM(Uniform2ui, every_api),
      GLARK_UNIFORM(Uniform3ui, every_api),    GLARK_UNIFORM(Uniform4ui, every_api),
      GLARK_UNIFORM(Uniform1fv, every_api),    GLARK_UNIFORM(Uniform2fv, every_api),
      GLARK_UNIFORM(Uniform3fv, every_api),    GLARK_UNIFORM(Uniform4fv, every_api),
      GLARK_UNIFORM(Uniform1iv, every_api),    GLARK_UNIFORM(Uniform2iv, every_api),
      GLARK_UNIFORM(Uniform3iv, every_api),    GLARK_UNIFORM(Uniform4iv, every_api),
      GLARK_UNIFORM(Uniform1uiv, every_api),   GLARK_UNIFORM(Uniform2uiv, every_api),
      GLARK_UNIFORM(Uniform3uiv, every_api),   GLARK_UNIFORM(Uniform4uiv, every_api),
      GLARK_UNIFORM(Uniform1d, desktop_apis),  GLARK_UNIFORM(Uniform2d, desktop_apis),
      GLARK_UNIFORM(Uniform3d, desktop_apis),  GLARK_UNIFORM(Uniform4d, desktop_apis),
      GLARK_UNIFORM(Uniform1dv, desktop_apis), GLARK_UNIFORM(Uniform2dv, desktop_apis),
      GLARK_UNIFORM(Uniform3dv, desktop_apis), GLARK_UNIFORM(Uniform4dv, desktop_apis),
  };
}

Rows matrix_uniform_rows() {
  using enum Where;
  return {
      GLARK_UNIFORM(UniformMatrix2fv, every_api),      GLARK_UNIFORM(UniformMatrix3fv, every_api),
      GLARK_UNIFORM(UniformMatrix4fv, every_api),      GLARK_UNIFORM(UniformMatrix2x3fv, every_api),
      GLARK_UNIFORM(UniformMatrix3x2fv, every_api),    GLARK_UNIFORM(UniformMatrix2x4fv, every_api),
      GLARK_UNIFORM(UniformMatrix4x2fv, every_api),    GLARK_UNIFORM(UniformMatrix3x4fv, every_api),
      GLARK_UNIFORM(UniformMatrix4x3fv, every_api),    GLARK_UNIFORM(UniformMatrix2dv, desktop_apis),
      GLARK_UNIFORM(UniformMatrix3dv, desktop_apis),   GLARK_UNIFORM(UniformMatrix4dv, desktop_apis),
      GLARK_UNIFORM(UniformMatrix2x3dv, desktop_apis), GLARK_UNIFORM(UniformMatrix3x2dv, desktop_apis),
      GLARK_UNIFORM(UniformMatrix2x4dv, desktop_apis), GLARK_UNIFORM(UniformMatrix4x2dv, desktop_apis),
      GLARK_UNIFORM(UniformMatrix3x4dv, desktop_apis), GLARK_UNIFORM(UniformMatrix4x3dv, desktop_apis),
  };
}
#undef GLARK_UNIFORM

GLintptr any_block(World& w) { return colour_block_bytes * w.values.between(0, colour_blocks - 1); }

Rows block_rows() {
  using enum Where;
  return {
      {"BindBufferRange", family, stage,
       [](World& w) { gl.BindBufferRange(GL_UNIFORM_BUFFER, colour_block_binding, w.blocks, any_block(w), 16); }},
      {"BindBufferBase", family, stage,
       [](World& w) { gl.BindBufferBase(GL_UNIFORM_BUFFER, colour_block_binding, w.blocks); }},
      {"BindBuffersRange", family, stage,
       [](World& w) {
         const GLintptr offset = any_block(w);
         const GLsizeiptr size = 16;
         gl.BindBuffersRange(GL_UNIFORM_BUFFER, colour_block_binding, 1, &w.blocks, &offset, &size);
       },
       desktop_apis, 44},
      {"BufferSubData of a block", family, stage,
       [](World& w) {
         const std::array<float, 4> tint = {w.values.fraction(), w.values.fraction(), w.values.fraction(), 1};
         gl.BindBuffer(GL_UNIFORM_BUFFER, w.blocks);
         gl.BufferSubData(GL_UNIFORM_BUFFER, any_block(w), sizeof(tint), tint.data());
       }},
      {"UniformBlockBinding", family, stage,
       [](World& w) {
         const GLuint program = w.any_program();
         const GLuint binding = colour_block_binding + static_cast<GLuint>(w.values.below(2));
         gl.BindBufferRange(GL_UNIFORM_BUFFER, colour_block_binding + 1, w.blocks, any_block(w), 16);
         gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Block"), binding);
       }},
  };
}

}  // namespace

Rows uniform_rows() {
  Rows all = vector_rows();
  for (const Rows& each : {matrix_uniform_rows(), block_rows()}) all.insert(all.end(), each.begin(), each.end());
  return all;
}

Rows program_rows() {
  using enum Where;
  return {
      {"UseProgram", "programs", shader, [](World& w) { gl.UseProgram(w.any_program()); }},
      {"UseProgram(0)", "programs", uniforms, [](World&) { gl.UseProgram(0); }},
      {"BindProgramPipeline", "programs", uniforms,
       [](World& w) { gl.BindProgramPipeline(w.pipelines[w.values.below(w.pipelines.size())]); }},
      {"UseProgramStages", "programs", uniforms,
       [](World& w) {
         const GLuint pipeline = w.pipelines[w.values.below(w.pipelines.size())];
         gl.UseProgramStages(pipeline, GL_VERTEX_SHADER_BIT | GL_FRAGMENT_SHADER_BIT, w.any_program());
       }},
      {"ActiveShaderProgram", "programs", uniforms,
       [](World& w) {
         const GLuint pipeline = w.pipelines[w.values.below(w.pipelines.size())];
         gl.ActiveShaderProgram(pipeline, w.any_program());
       }},
  };
}

}  // namespace glark::conformance
