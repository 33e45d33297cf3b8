// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Changes of what a program reads besides its attributes: uniforms, uniform blocks, the program itself.
#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

constexpr GLfloat other_tint[] = {0.4F, 0.5F, 1, 1};

GLsizeiptr content() { return 16; }
constexpr GLfloat other_block[] = {0.3F, 1, 0.5F, 1};

std::vector<Change> uniforms() {
  return {
      {"Uniform4f", {"Uniform4f"}, Concern::state, [](Test&, Scene&) { gl.Uniform4f(0, 0.4F, 0.5F, 1, 1); }},
      {"Uniform4f.blue", {"Uniform4f"}, Concern::state, [](Test&, Scene&) { gl.Uniform4f(0, 1, 0.9F, 0.2F, 1); }},
      {"Uniform4fv", {"Uniform4fv"}, Concern::state, [](Test&, Scene&) { gl.Uniform4fv(0, 1, other_tint); }},
      {"ProgramUniform4f",
       {"ProgramUniform4f"},
       Concern::state,
       [](Test&, Scene& s) { gl.ProgramUniform4f(s.program, 0, 0.4F, 0.5F, 1, 1); }},
      {"ProgramUniform4fv",
       {"ProgramUniform4fv"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.UseProgram(0);
         gl.ProgramUniform4fv(s.program, 0, 1, other_tint);
         gl.UseProgram(s.program);
       }},
      {"UseProgram",
       {"UseProgram"},
       Concern::state,
       [](Test& t, Scene& s) {
         const GLuint other = colour_program(t);
         gl.UseProgram(other);
         gl.DeleteProgram(s.program);
         s.program = other;
       }},
      {"LinkProgram",
       {"LinkProgram"},
       Concern::state,
       [](Test&, Scene& s) {
         // Linked again, the program has its initial uniforms: everything is black but for the alpha value.
         gl.LinkProgram(s.program);
         gl.Uniform4f(0, 0.2F, 0.9F, 0.9F, 1);
       }},
      {"Uniform1i",
       {"Uniform1i"},
       Concern::state,
       [](Test&, Scene& s) {
         // The sampler reads another unit.
         GLuint other = 0;
         gl.GenTextures(1, &other);
         gl.ActiveTexture(GL_TEXTURE0 + 5);
         gl.BindTexture(GL_TEXTURE_2D, other);
         const GLuint pixel = 0xff8040f0;
         gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
         gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
         gl.ActiveTexture(GL_TEXTURE0 + image_unit);
         gl.Uniform1i(gl.GetUniformLocation(s.program, "image"), 5);
       }},
  };
}

std::vector<Change> blocks() {
  return {
      {"BindBufferRange",
       {"BindBufferRange"},
       Concern::state,
       [](Test&, Scene& s) { gl.BindBufferRange(GL_UNIFORM_BUFFER, block_binding, s.block, block_bytes, content()); }},
      {"BindBufferBase",
       {"BindBufferBase"},
       Concern::state,
       [](Test&, Scene& s) {
         s.made.push_back(make_buffer(GL_UNIFORM_BUFFER, other_block, sizeof(other_block)));
         gl.BindBufferBase(GL_UNIFORM_BUFFER, block_binding, s.made.back());
       }},
      {"UniformBlockBinding",
       {"UniformBlockBinding"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.BindBufferRange(GL_UNIFORM_BUFFER, 4, s.block, block_bytes, content());
         gl.UniformBlockBinding(s.program, gl.GetUniformBlockIndex(s.program, "Block"), 4);
       }},
      {"BufferSubData",
       {"BufferSubData"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_UNIFORM_BUFFER, s.block);
         gl.BufferSubData(GL_UNIFORM_BUFFER, 0, content(), other_block);
       }},
      {"CopyBufferSubData",
       {"CopyBufferSubData"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_COPY_READ_BUFFER, s.block);
         gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER, block_bytes, 0, content());
       }},
      {"BindBuffersRange",
       {"BindBuffersRange"},
       Concern::state,
       [](Test&, Scene& s) {
         const GLintptr offset = block_bytes;
         const GLsizeiptr size = content();
         gl.BindBuffersRange(GL_UNIFORM_BUFFER, block_binding, 1, &s.block, &offset, &size);
       },
       desktop_apis,
       44},
      {"BindBuffersBase",
       {"BindBuffersBase"},
       Concern::state,
       [](Test&, Scene& s) {
         s.made.push_back(make_buffer(GL_UNIFORM_BUFFER, other_block, sizeof(other_block)));
         gl.BindBuffersBase(GL_UNIFORM_BUFFER, block_binding, 1, &s.made.back());
       },
       desktop_apis,
       44},
      {"NamedBufferSubData",
       {"NamedBufferSubData"},
       Concern::state,
       [](Test&, Scene& s) { gl.NamedBufferSubData(s.block, 0, content(), other_block); },
       desktop_apis,
       45},
      {"DeleteBuffers",
       {"DeleteBuffers"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.DeleteBuffers(1, &s.block);
         s.block = make_buffer(GL_UNIFORM_BUFFER, other_block, sizeof(other_block));
         gl.BindBufferBase(GL_UNIFORM_BUFFER, block_binding, s.block);
       }},
  };
}

std::vector<Change> of_programs(std::vector<Change> changes) {
  for (Change& change : changes) change.changes_program = true;
  return changes;
}

}  // namespace

Cases uniforms_cases() {
  static const std::vector<Change> of_uniforms = of_programs(uniforms());
  static const std::vector<Change> of_blocks = of_programs(blocks());
  Cases cases = change_cases("uniform", of_uniforms, 180);
  for (Case& each : change_cases("block", of_blocks, 195)) cases.push_back(std::move(each));
  return cases;
}

}  // namespace glark::conformance
