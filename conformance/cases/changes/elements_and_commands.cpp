// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Changes of the indices of a draw, and of the commands of indirect draws.
#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

GLsizeiptr index_bytes(const Scene& s) { return 2 * GLsizeiptr{s.vertices()}; }

GLuint other_elements(Scene& s) {
  s.made.push_back(make_buffer(GL_COPY_READ_BUFFER, s.new_indices().data(), s.new_indices().size() * 2));
  return s.made.back();
}

constexpr GLintptr command_bytes = 64;  // from one content to the other

std::vector<Change> indices() {
  return {
      {"BufferSubData",
       {"BufferSubData"},
       Concern::indices,
       [](Test&, Scene& s) { gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, index_bytes(s), s.new_indices().data()); }},
      {"BufferData",
       {"BufferData"},
       Concern::indices,
       [](Test&, Scene& s) {
         gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 2 * index_bytes(s), s.new_indices().data(), GL_STATIC_DRAW);
       }},
      {"CopyBufferSubData",
       {"CopyBufferSubData"},
       Concern::indices,
       [](Test&, Scene& s) {
         gl.CopyBufferSubData(GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, s.other_indices(), 0, index_bytes(s));
       }},
      {"BindBuffer",
       {"BindBuffer"},
       Concern::indices,
       [](Test&, Scene& s) { gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, other_elements(s)); }},
      {"DeleteBuffers",
       {"DeleteBuffers"},
       Concern::indices,
       [](Test&, Scene& s) {
         gl.DeleteBuffers(1, &s.indices);
         s.indices = make_buffer(GL_ELEMENT_ARRAY_BUFFER, s.new_indices().data(), s.new_indices().size() * 2);
       }},
      {"NamedBufferSubData",
       {"NamedBufferSubData"},
       Concern::indices,
       [](Test&, Scene& s) { gl.NamedBufferSubData(s.indices, 0, index_bytes(s), s.new_indices().data()); },
       desktop_apis,
       45},
      {"VertexArrayElementBuffer",
       {"VertexArrayElementBuffer"},
       Concern::indices,
       [](Test&, Scene& s) { gl.VertexArrayElementBuffer(s.array, other_elements(s)); },
       desktop_apis,
       45},
      {"VertexArrayElementBuffer.unbound",
       {"VertexArrayElementBuffer"},
       Concern::indices,
       [](Test&, Scene& s) {
         const GLuint other = other_elements(s);
         gl.BindVertexArray(0);
         gl.VertexArrayElementBuffer(s.array, other);
         gl.BindVertexArray(s.array);
       },
       desktop_apis,
       45},
      {"PrimitiveRestartIndex",
       {"PrimitiveRestartIndex", "Enable", "Disable"},
       Concern::indices,
       [](Test&, Scene& s) {
         // Without the index of one vertex, the triangles behind it begin at other vertices.
         gl.Enable(GL_PRIMITIVE_RESTART);
         gl.PrimitiveRestartIndex(static_cast<GLuint>(s.vertices()) / 3);
       },
       desktop_apis},
  };
}

std::vector<Change> commands() {
  return {
      {"BufferSubData",
       {"BufferSubData"},
       Concern::commands,
       [](Test&, Scene& s) {
         const auto half = static_cast<GLuint>(s.vertices()) / 2;
         gl.BufferSubData(GL_DRAW_INDIRECT_BUFFER, 0, 4, &half);
         gl.BufferSubData(GL_DRAW_INDIRECT_BUFFER, 16, 4, &half);
       }},
      {"CopyBufferSubData",
       {"CopyBufferSubData"},
       Concern::commands,
       [](Test&, Scene&) {
         gl.CopyBufferSubData(GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER, command_bytes, 0, command_bytes);
       }},
      {"BindBuffer",
       {"BindBuffer"},
       Concern::commands,
       [](Test&, Scene& s) {
         const auto half = static_cast<GLuint>(s.vertices()) / 2;
         const GLuint words[] = {half, 1, 0, 0, half, 1, 0, 0, 0};
         s.made.push_back(make_buffer(GL_DRAW_INDIRECT_BUFFER, words, sizeof(words)));
       }},
      {"NamedBufferSubData",
       {"NamedBufferSubData"},
       Concern::commands,
       [](Test&, Scene& s) {
         const auto half = static_cast<GLuint>(s.vertices()) / 2;
         gl.NamedBufferSubData(s.commands, 0, 4, &half);
         gl.NamedBufferSubData(s.commands, 16, 4, &half);
       },
       desktop_apis,
       45},
  };
}

}  // namespace

Cases elements_and_commands_cases() {
  static const std::vector<Change> of_indices = indices();
  static const std::vector<Change> of_commands = commands();
  Cases cases = change_cases("index", of_indices, 150);
  for (Case& each : change_cases("command", of_commands, 170)) cases.push_back(std::move(each));
  return cases;
}

}  // namespace glark::conformance
