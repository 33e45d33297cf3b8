// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every command that sets the current value of an attribute of integers, between draws without an array for it.
#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

std::vector<Change> integers() {
  return {
      {"VertexAttribI1i",
       {"VertexAttribI1i"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI1i(at_steps, 5); },
       desktop_apis},
      {"VertexAttribI1iv",
       {"VertexAttribI1iv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLint v[] = {5};
         gl.VertexAttribI1iv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI2i",
       {"VertexAttribI2i"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI2i(at_steps, 1, 4); },
       desktop_apis},
      {"VertexAttribI2iv",
       {"VertexAttribI2iv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLint v[] = {1, 4};
         gl.VertexAttribI2iv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI3i",
       {"VertexAttribI3i"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI3i(at_steps, 1, 0, 4); },
       desktop_apis},
      {"VertexAttribI3iv",
       {"VertexAttribI3iv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLint v[] = {1, 0, 4};
         gl.VertexAttribI3iv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI4i",
       {"VertexAttribI4i"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI4i(at_steps, 3, 2, 1, 0); }},
      {"VertexAttribI4iv",
       {"VertexAttribI4iv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLint v[] = {3, 2, 1, 0};
         gl.VertexAttribI4iv(at_steps, v);
       }},
      {"VertexAttribI1ui",
       {"VertexAttribI1ui"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI1ui(at_steps, 5); },
       desktop_apis},
      {"VertexAttribI1uiv",
       {"VertexAttribI1uiv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLuint v[] = {5};
         gl.VertexAttribI1uiv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI2ui",
       {"VertexAttribI2ui"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI2ui(at_steps, 1, 4); },
       desktop_apis},
      {"VertexAttribI2uiv",
       {"VertexAttribI2uiv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLuint v[] = {1, 4};
         gl.VertexAttribI2uiv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI3ui",
       {"VertexAttribI3ui"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI3ui(at_steps, 1, 0, 4); },
       desktop_apis},
      {"VertexAttribI3uiv",
       {"VertexAttribI3uiv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLuint v[] = {1, 0, 4};
         gl.VertexAttribI3uiv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI4ui",
       {"VertexAttribI4ui"},
       Concern::integers,
       [](Test&, Scene&) { gl.VertexAttribI4ui(at_steps, 3, 2, 1, 0); },
       desktop_apis},
      {"VertexAttribI4uiv",
       {"VertexAttribI4uiv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLuint v[] = {3, 2, 1, 0};
         gl.VertexAttribI4uiv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI4bv",
       {"VertexAttribI4bv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLbyte v[] = {3, 2, 1, 0};
         gl.VertexAttribI4bv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI4ubv",
       {"VertexAttribI4ubv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLubyte v[] = {3, 2, 1, 0};
         gl.VertexAttribI4ubv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI4sv",
       {"VertexAttribI4sv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLshort v[] = {3, 2, 1, 0};
         gl.VertexAttribI4sv(at_steps, v);
       },
       desktop_apis},
      {"VertexAttribI4usv",
       {"VertexAttribI4usv"},
       Concern::integers,
       [](Test&, Scene&) {
         const GLushort v[] = {3, 2, 1, 0};
         gl.VertexAttribI4usv(at_steps, v);
       },
       desktop_apis},
  };
}

}  // namespace

Cases current_integers_cases() {
  static const std::vector<Change> changes = integers();
  return change_cases("current_integer", changes, 360);
}

}  // namespace glark::conformance
