// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every command that sets the current value of a generic attribute, between draws without an array for it.
#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

constexpr GLuint packed = 400U | 60U << 10U | 600U << 20U | 3U << 30U;

std::vector<Change> lengths() {
  return {
      {"VertexAttrib1f", {"VertexAttrib1f"}, Concern::state, [](Test&, Scene&) { gl.VertexAttrib1f(at_extra, 0.7F); }},
      {"VertexAttrib1fv",
       {"VertexAttrib1fv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLfloat v[] = {0.7F};
         gl.VertexAttrib1fv(at_extra, v);
       }},
      {"VertexAttrib1d",
       {"VertexAttrib1d"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib1d(at_extra, 0.7); },
       desktop_apis},
      {"VertexAttrib1dv",
       {"VertexAttrib1dv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLdouble v[] = {0.7};
         gl.VertexAttrib1dv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib1s",
       {"VertexAttrib1s"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib1s(at_extra, 1); },
       desktop_apis},
      {"VertexAttrib1sv",
       {"VertexAttrib1sv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLshort v[] = {1};
         gl.VertexAttrib1sv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib2f",
       {"VertexAttrib2f"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib2f(at_extra, 0.1F, 0.5F); }},
      {"VertexAttrib2fv",
       {"VertexAttrib2fv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLfloat v[] = {0.1F, 0.5F};
         gl.VertexAttrib2fv(at_extra, v);
       }},
      {"VertexAttrib2d",
       {"VertexAttrib2d"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib2d(at_extra, 0.1, 0.5); },
       desktop_apis},
      {"VertexAttrib2dv",
       {"VertexAttrib2dv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLdouble v[] = {0.1, 0.5};
         gl.VertexAttrib2dv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib2s",
       {"VertexAttrib2s"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib2s(at_extra, 1, 1); },
       desktop_apis},
      {"VertexAttrib2sv",
       {"VertexAttrib2sv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLshort v[] = {1, 1};
         gl.VertexAttrib2sv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib3f",
       {"VertexAttrib3f"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib3f(at_extra, 0.1F, 0.05F, 0.6F); }},
      {"VertexAttrib3fv",
       {"VertexAttrib3fv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLfloat v[] = {0.1F, 0.05F, 0.6F};
         gl.VertexAttrib3fv(at_extra, v);
       }},
      {"VertexAttrib3d",
       {"VertexAttrib3d"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib3d(at_extra, 0.1, 0.05, 0.6); },
       desktop_apis},
      {"VertexAttrib3dv",
       {"VertexAttrib3dv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLdouble v[] = {0.1, 0.05, 0.6};
         gl.VertexAttrib3dv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib3s",
       {"VertexAttrib3s"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib3s(at_extra, 1, 1, 0); },
       desktop_apis},
      {"VertexAttrib3sv",
       {"VertexAttrib3sv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLshort v[] = {1, 1, 0};
         gl.VertexAttrib3sv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4f",
       {"VertexAttrib4f"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib4f(at_extra, 0.4F, 0.05F, 0.5F, 1); }},
      {"VertexAttrib4fv",
       {"VertexAttrib4fv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLfloat v[] = {0.4F, 0.05F, 0.5F, 1};
         gl.VertexAttrib4fv(at_extra, v);
       }},
      {"VertexAttrib4d",
       {"VertexAttrib4d"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib4d(at_extra, 0.4, 0.05, 0.5, 1); },
       desktop_apis},
      {"VertexAttrib4dv",
       {"VertexAttrib4dv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLdouble v[] = {0.4, 0.05, 0.5, 1};
         gl.VertexAttrib4dv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4s",
       {"VertexAttrib4s"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib4s(at_extra, 1, 1, 0, 1); },
       desktop_apis},
      {"VertexAttrib4sv",
       {"VertexAttrib4sv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLshort v[] = {1, 1, 0, 1};
         gl.VertexAttrib4sv(at_extra, v);
       },
       desktop_apis},
  };
}

std::vector<Change> formats() {
  return {
      {"VertexAttrib4bv",
       {"VertexAttrib4bv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLbyte v[] = {1, 0, 1, 1};
         gl.VertexAttrib4bv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4ubv",
       {"VertexAttrib4ubv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLubyte v[] = {1, 0, 1, 1};
         gl.VertexAttrib4ubv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4usv",
       {"VertexAttrib4usv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLushort v[] = {1, 0, 1, 1};
         gl.VertexAttrib4usv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4iv",
       {"VertexAttrib4iv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLint v[] = {1, 0, 1, 1};
         gl.VertexAttrib4iv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4uiv",
       {"VertexAttrib4uiv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLuint v[] = {1, 0, 1, 1};
         gl.VertexAttrib4uiv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4Nub",
       {"VertexAttrib4Nub"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib4Nub(at_extra, 100, 20, 150, 255); },
       desktop_apis},
      {"VertexAttrib4Nbv",
       {"VertexAttrib4Nbv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLbyte v[] = {50, 10, 90, 127};
         gl.VertexAttrib4Nbv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4Nubv",
       {"VertexAttrib4Nubv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLubyte v[] = {100, 20, 150, 255};
         gl.VertexAttrib4Nubv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4Nsv",
       {"VertexAttrib4Nsv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLshort v[] = {15000, 1000, 20000, 32767};
         gl.VertexAttrib4Nsv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4Nusv",
       {"VertexAttrib4Nusv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLushort v[] = {25000, 1000, 40000, 65535};
         gl.VertexAttrib4Nusv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4Niv",
       {"VertexAttrib4Niv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLint v[] = {1000000000, 0, 1500000000, 2147483647};
         gl.VertexAttrib4Niv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttrib4Nuiv",
       {"VertexAttrib4Nuiv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLuint v[] = {2000000000, 0, 3000000000, 4294967295};
         gl.VertexAttrib4Nuiv(at_extra, v);
       },
       desktop_apis},
      {"VertexAttribP1ui",
       {"VertexAttribP1ui"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP1ui(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, packed); },
       desktop_apis},
      {"VertexAttribP1uiv",
       {"VertexAttribP1uiv"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP1uiv(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, &packed); },
       desktop_apis},
      {"VertexAttribP2ui",
       {"VertexAttribP2ui"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP2ui(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, packed); },
       desktop_apis},
      {"VertexAttribP2uiv",
       {"VertexAttribP2uiv"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP2uiv(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, &packed); },
       desktop_apis},
      {"VertexAttribP3ui",
       {"VertexAttribP3ui"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP3ui(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, packed); },
       desktop_apis},
      {"VertexAttribP3uiv",
       {"VertexAttribP3uiv"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP3uiv(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, &packed); },
       desktop_apis},
      {"VertexAttribP4ui",
       {"VertexAttribP4ui"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP4ui(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, packed); },
       desktop_apis},
      {"VertexAttribP4uiv",
       {"VertexAttribP4uiv"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttribP4uiv(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, &packed); },
       desktop_apis},
      {"one_channel.red",
       {"VertexAttrib4f"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib4f(at_extra, 0.5F, 0.05F, 0, 0); }},
      {"one_channel.green",
       {"VertexAttrib4f"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib4f(at_extra, 0.1F, 0.45F, 0, 0); }},
      {"one_channel.blue",
       {"VertexAttrib4f"},
       Concern::state,
       [](Test&, Scene&) { gl.VertexAttrib4f(at_extra, 0.1F, 0.05F, 0.4F, 0); }},
  };
}

}  // namespace

Cases current_values_cases() {
  static const std::vector<Change> changes = joined({lengths(), formats()});
  return change_cases("current", changes, 300);
}

}  // namespace glark::conformance
