// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Writes of a buffer by its name (direct state access), between two draws that read it as a vertex array.
#include "conformance/cases/cases.h"
#include "conformance/cases/changes/buffer_content.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

void map_named(Scene& s, GLbitfield flags) {
  write_mapped(s, gl.MapNamedBufferRange(s.colours, 0, s.colour_bytes(), GL_MAP_WRITE_BIT | flags));
}

// Direct state access: the buffer is bound to no target.
std::vector<Change> direct() {
  return {
      {"NamedBufferData",
       {"NamedBufferData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.NamedBufferData(s.colours, s.all_colour_bytes(), s.new_colours().data(), GL_STATIC_DRAW);
       },
       desktop_apis,
       45},
      {"NamedBufferSubData",
       {"NamedBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.NamedBufferSubData(s.colours, 0, s.colour_bytes(), s.new_colours().data());
       },
       desktop_apis,
       45},
      {"MapNamedBuffer",
       {"MapNamedBuffer", "UnmapNamedBuffer"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         write_mapped(s, gl.MapNamedBuffer(s.colours, GL_WRITE_ONLY));
         gl.UnmapNamedBuffer(s.colours);
       },
       desktop_apis,
       45},
      {"MapNamedBufferRange",
       {"MapNamedBufferRange"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         map_named(s, 0);
         gl.UnmapNamedBuffer(s.colours);
       },
       desktop_apis,
       45},
      {"FlushMappedNamedBufferRange",
       {"FlushMappedNamedBufferRange"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         map_named(s, GL_MAP_FLUSH_EXPLICIT_BIT);
         gl.FlushMappedNamedBufferRange(s.colours, 0, s.colour_bytes());
         gl.UnmapNamedBuffer(s.colours);
       },
       desktop_apis,
       45},
      {"CopyNamedBufferSubData",
       {"CopyNamedBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         const GLuint source = source_of(s, GL_COPY_READ_BUFFER);
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.CopyNamedBufferSubData(source, s.colours, 0, 0, s.colour_bytes());
       },
       desktop_apis,
       45},
      {"ClearNamedBufferData",
       {"ClearNamedBufferData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.ClearNamedBufferData(s.colours, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &one_colour);
       },
       desktop_apis,
       45},
      {"ClearNamedBufferSubData",
       {"ClearNamedBufferSubData"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.ClearNamedBufferSubData(s.colours, GL_R32UI, 0, s.colour_bytes(), GL_RED_INTEGER, GL_UNSIGNED_INT,
                                    &one_colour);
       },
       desktop_apis,
       45},
      {"CreateBuffers",
       {"CreateBuffers", "NamedBufferStorage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         gl.DeleteBuffers(1, &s.colours);
         gl.CreateBuffers(1, &s.colours);
         gl.NamedBufferStorage(s.colours, s.all_colour_bytes(), s.new_colours().data(), 0);
         gl.BindBuffer(GL_ARRAY_BUFFER, s.colours);
         s.point_at(0);
       },
       desktop_apis,
       45},
  };
}

}  // namespace

Cases named_buffer_writes_cases() {
  static const std::vector<Change> changes = direct();
  return change_cases("named_buffer", changes, 40);
}

}  // namespace glark::conformance
