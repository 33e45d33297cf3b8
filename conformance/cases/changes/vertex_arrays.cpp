// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every command that changes where a vertex array object finds its data, between two draws.
#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

constexpr GLuint free_binding = 9;

// Runs a call while another vertex array is bound: it names the first one.
void from_elsewhere(Scene& s, const std::function<void()>& call) {
  GLuint other = 0;
  gl.GenVertexArrays(1, &other);
  gl.BindVertexArray(other);
  call();
  gl.BindVertexArray(s.array);
  gl.DeleteVertexArrays(1, &other);
}

// A current value shows where the array is disabled.
void set_current_colour() { gl.VertexAttrib4f(at_colour, 0.5F, 0.25F, 1, 1); }

void bind_vertex_buffers(Scene& s, const std::function<void(const GLuint*, const GLintptr*, const GLsizei*)>& bind) {
  const GLuint buffer = s.colours;
  const GLintptr offset = s.other_colours();
  const GLsizei stride = 4;
  bind(&buffer, &offset, &stride);
}

std::vector<Change> common() {
  return {
      {"VertexAttribPointer",
       {"VertexAttribPointer"},
       Concern::arrays,
       [](Test&, Scene& s) { s.point_at(s.other_colours()); }},
      {"stride", {"VertexAttribPointer"}, Concern::arrays, [](Test&, Scene& s) { s.point_at(0, 8); }},
      {"other_buffer",
       {"BindBuffer", "VertexAttribPointer"},
       Concern::arrays,
       [](Test&, Scene& s) {
         s.made.push_back(
             make_buffer(GL_ARRAY_BUFFER, s.new_colours().data(), static_cast<std::size_t>(s.all_colour_bytes())));
         s.point_at(0);
       }},
      {"type",
       {"VertexAttribPointer"},
       Concern::arrays,
       [](Test&, Scene&) { gl.VertexAttribPointer(at_colour, 2, GL_UNSIGNED_SHORT, GL_TRUE, 4, nullptr); }},
      {"components",
       {"VertexAttribPointer"},
       Concern::arrays,
       [](Test&, Scene&) { gl.VertexAttribPointer(at_colour, 2, GL_UNSIGNED_BYTE, GL_TRUE, 4, nullptr); }},
      {"not_normalized",
       {"VertexAttribPointer"},
       Concern::arrays,
       [](Test&, Scene&) { gl.VertexAttribPointer(at_colour, 4, GL_UNSIGNED_BYTE, GL_FALSE, 4, nullptr); }},
      {"VertexAttribFormat",
       {"VertexAttribFormat"},
       Concern::arrays,
       [](Test&, Scene&) { gl.VertexAttribFormat(at_colour, 2, GL_UNSIGNED_BYTE, GL_TRUE, 1); }},
      {"VertexAttribBinding",
       {"VertexAttribBinding"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindVertexBuffer(free_binding, s.colours, s.other_colours(), 4);
         gl.VertexAttribBinding(at_colour, free_binding);
       }},
      {"BindVertexBuffer",
       {"BindVertexBuffer"},
       Concern::arrays,
       [](Test&, Scene& s) { gl.BindVertexBuffer(at_colour, s.colours, s.other_colours(), 4); }},
      {"stride_of_binding",
       {"BindVertexBuffer"},
       Concern::arrays,
       [](Test&, Scene& s) { gl.BindVertexBuffer(at_colour, s.colours, 0, 0); }},
      {"VertexAttribDivisor",
       {"VertexAttribDivisor"},
       Concern::instances,
       [](Test&, Scene&) { gl.VertexAttribDivisor(at_colour, 1); }},
      {"VertexBindingDivisor",
       {"VertexBindingDivisor"},
       Concern::instances,
       [](Test&, Scene&) { gl.VertexBindingDivisor(at_colour, 1); }},
      {"DisableVertexAttribArray",
       {"DisableVertexAttribArray"},
       Concern::arrays,
       [](Test&, Scene&) {
         set_current_colour();
         gl.DisableVertexAttribArray(at_colour);
       }},
      {"EnableVertexAttribArray",
       {"EnableVertexAttribArray"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, s.colours);
         gl.VertexAttribPointer(at_extra, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, nullptr);
         gl.EnableVertexAttribArray(at_extra);
       }},
      {"BindVertexArray",
       {"BindVertexArray", "GenVertexArrays"},
       Concern::arrays,
       [](Test&, Scene& s) {
         const GLuint old = s.array;
         s.array = s.make_array(s.other_colours());
         gl.DeleteVertexArrays(1, &old);
       }},
      {"DeleteVertexArrays",
       {"DeleteVertexArrays"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.DeleteVertexArrays(1, &s.array);
         s.array = s.make_array(s.other_colours());
       }},
  };
}

std::vector<Change> several() {
  return {
      {"BindVertexBuffers",
       {"BindVertexBuffers"},
       Concern::arrays,
       [](Test&, Scene& s) {
         bind_vertex_buffers(s, [](const GLuint* buffer, const GLintptr* offset, const GLsizei* stride) {
           gl.BindVertexBuffers(at_colour, 1, buffer, offset, stride);
         });
       },
       desktop_apis,
       44},
      {"VertexArrayVertexBuffers",
       {"VertexArrayVertexBuffers"},
       Concern::arrays,
       [](Test&, Scene& s) {
         bind_vertex_buffers(s, [&](const GLuint* buffer, const GLintptr* offset, const GLsizei* stride) {
           gl.VertexArrayVertexBuffers(s.array, at_colour, 1, buffer, offset, stride);
         });
       },
       desktop_apis,
       45},
      {"VertexArrayVertexBuffers.unbound",
       {"VertexArrayVertexBuffers"},
       Concern::arrays,
       [](Test&, Scene& s) {
         from_elsewhere(s, [&] {
           bind_vertex_buffers(s, [&](const GLuint* buffer, const GLintptr* offset, const GLsizei* stride) {
             gl.VertexArrayVertexBuffers(s.array, at_colour, 1, buffer, offset, stride);
           });
         });
       },
       desktop_apis,
       45},
  };
}

// Direct state access, to the bound vertex array and to another one.
std::vector<Change> direct() {
  return {
      {"VertexArrayVertexBuffer",
       {"VertexArrayVertexBuffer"},
       Concern::arrays,
       [](Test&, Scene& s) { gl.VertexArrayVertexBuffer(s.array, at_colour, s.colours, s.other_colours(), 4); },
       desktop_apis,
       45},
      {"VertexArrayVertexBuffer.unbound",
       {"VertexArrayVertexBuffer"},
       Concern::arrays,
       [](Test&, Scene& s) {
         from_elsewhere(s, [&] { gl.VertexArrayVertexBuffer(s.array, at_colour, s.colours, s.other_colours(), 4); });
       },
       desktop_apis,
       45},
      {"VertexArrayAttribFormat",
       {"VertexArrayAttribFormat"},
       Concern::arrays,
       [](Test&, Scene& s) { gl.VertexArrayAttribFormat(s.array, at_colour, 2, GL_UNSIGNED_BYTE, GL_TRUE, 1); },
       desktop_apis,
       45},
      {"VertexArrayAttribFormat.unbound",
       {"VertexArrayAttribFormat"},
       Concern::arrays,
       [](Test&, Scene& s) {
         from_elsewhere(s, [&] { gl.VertexArrayAttribFormat(s.array, at_colour, 2, GL_UNSIGNED_BYTE, GL_TRUE, 1); });
       },
       desktop_apis,
       45},
      {"VertexArrayAttribBinding",
       {"VertexArrayAttribBinding"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.VertexArrayVertexBuffer(s.array, free_binding, s.colours, s.other_colours(), 4);
         gl.VertexArrayAttribBinding(s.array, at_colour, free_binding);
       },
       desktop_apis,
       45},
      {"VertexArrayAttribBinding.unbound",
       {"VertexArrayAttribBinding"},
       Concern::arrays,
       [](Test&, Scene& s) {
         from_elsewhere(s, [&] {
           gl.VertexArrayVertexBuffer(s.array, free_binding, s.colours, s.other_colours(), 4);
           gl.VertexArrayAttribBinding(s.array, at_colour, free_binding);
         });
       },
       desktop_apis,
       45},
      {"VertexArrayBindingDivisor",
       {"VertexArrayBindingDivisor"},
       Concern::instances,
       [](Test&, Scene& s) { gl.VertexArrayBindingDivisor(s.array, at_colour, 1); },
       desktop_apis,
       45},
      {"VertexArrayBindingDivisor.unbound",
       {"VertexArrayBindingDivisor"},
       Concern::instances,
       [](Test&, Scene& s) { from_elsewhere(s, [&] { gl.VertexArrayBindingDivisor(s.array, at_colour, 1); }); },
       desktop_apis,
       45},
      {"DisableVertexArrayAttrib",
       {"DisableVertexArrayAttrib"},
       Concern::arrays,
       [](Test&, Scene& s) {
         set_current_colour();
         gl.DisableVertexArrayAttrib(s.array, at_colour);
       },
       desktop_apis,
       45},
      {"DisableVertexArrayAttrib.unbound",
       {"DisableVertexArrayAttrib"},
       Concern::arrays,
       [](Test&, Scene& s) {
         set_current_colour();
         from_elsewhere(s, [&] { gl.DisableVertexArrayAttrib(s.array, at_colour); });
       },
       desktop_apis,
       45},
      {"EnableVertexArrayAttrib",
       {"EnableVertexArrayAttrib"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, s.colours);
         gl.VertexAttribPointer(at_extra, 4, GL_UNSIGNED_BYTE, GL_TRUE, 4, nullptr);
         from_elsewhere(s, [&] { gl.EnableVertexArrayAttrib(s.array, at_extra); });
       },
       desktop_apis,
       45},
      {"CreateVertexArrays",
       {"CreateVertexArrays"},
       Concern::arrays,
       [](Test&, Scene& s) {
         const GLuint old = s.array;
         s.array = s.make_array(s.other_colours());
         gl.BindVertexArray(old);
         gl.BindVertexArray(s.array);
         gl.DeleteVertexArrays(1, &old);
       },
       desktop_apis,
       45},
  };
}

}  // namespace

Cases vertex_arrays_cases() {
  static const std::vector<Change> changes = joined({common(), several(), direct()});
  return change_cases("array", changes, 100);
}

}  // namespace glark::conformance
