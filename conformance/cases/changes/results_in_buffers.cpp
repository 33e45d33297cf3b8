// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Pixels of textures and results of queries that GL writes to a buffer, between two draws that read it as a vertex array.
#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

// A texture whose pixels are the other colours.
GLuint texture_of(const Scene& s) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, s.vertices() / 6, 6, 0, GL_RGBA, GL_UNSIGNED_BYTE, s.new_colours().data());
  return texture;
}

void read_texture(Scene& s, const std::function<void(GLuint)>& read) {
  const GLuint texture = texture_of(s);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, s.colours);
  read(texture);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.BindTexture(GL_TEXTURE_2D, s.image);
  gl.DeleteTextures(1, &texture);
}

// The result of a query becomes the colour of all vertices: no sample passes, so they turn black. `read` writes it at an
// offset, `bytes` long.
void query(Scene& s, GLintptr bytes, const std::function<void(GLuint, GLintptr)>& read) {
  GLuint name = 0;
  gl.GenQueries(1, &name);
  gl.BeginQuery(GL_SAMPLES_PASSED, name);
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.Finish();
  gl.BindBuffer(GL_QUERY_BUFFER, s.colours);
  for (GLintptr at = 0; at < s.colour_bytes(); at += bytes) read(name, at);
  gl.BindBuffer(GL_QUERY_BUFFER, 0);
  gl.DeleteQueries(1, &name);
}

std::vector<Change> texture_images() {
  return {
      {"GetTexImage",
       {"GetTexImage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         read_texture(s, [](GLuint) { gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); });
       },
       desktop_apis},
      {"GetTextureImage",
       {"GetTextureImage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         read_texture(s, [&](GLuint texture) {
           gl.GetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, 4 * s.vertices(), nullptr);
         });
       },
       desktop_apis,
       45},
      {"GetTextureSubImage",
       {"GetTextureSubImage"},
       Concern::arrays,
       [](Test&, Scene& s) {
         read_texture(s, [&](GLuint texture) {
           gl.GetTextureSubImage(texture, 0, 0, 0, 0, s.vertices() / 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                                 4 * s.vertices(), nullptr);
         });
       },
       desktop_apis,
       45},
  };
}

std::vector<Change> query_results() {
  return {
      {"GetQueryObjectuiv",
       {"GetQueryObjectuiv"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 4, [](GLuint name, GLintptr at) {
           gl.GetQueryObjectuiv(name, GL_QUERY_RESULT, reinterpret_cast<GLuint*>(at));
         });
       },
       desktop_apis,
       44},
      {"GetQueryObjectiv",
       {"GetQueryObjectiv"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 4, [](GLuint name, GLintptr at) {
           gl.GetQueryObjectiv(name, GL_QUERY_RESULT, reinterpret_cast<GLint*>(at));
         });
       },
       desktop_apis,
       44},
      {"GetQueryObjectui64v",
       {"GetQueryObjectui64v"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 8, [](GLuint name, GLintptr at) {
           gl.GetQueryObjectui64v(name, GL_QUERY_RESULT, reinterpret_cast<GLuint64*>(at));
         });
       },
       desktop_apis,
       44},
      {"GetQueryObjecti64v",
       {"GetQueryObjecti64v"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 8, [](GLuint name, GLintptr at) {
           gl.GetQueryObjecti64v(name, GL_QUERY_RESULT, reinterpret_cast<GLint64*>(at));
         });
       },
       desktop_apis,
       44},
      {"GetQueryBufferObjectuiv",
       {"GetQueryBufferObjectuiv"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 4,
               [&](GLuint name, GLintptr at) { gl.GetQueryBufferObjectuiv(name, s.colours, GL_QUERY_RESULT, at); });
       },
       desktop_apis,
       45},
      {"GetQueryBufferObjectiv",
       {"GetQueryBufferObjectiv"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 4,
               [&](GLuint name, GLintptr at) { gl.GetQueryBufferObjectiv(name, s.colours, GL_QUERY_RESULT, at); });
       },
       desktop_apis,
       45},
      {"GetQueryBufferObjectui64v",
       {"GetQueryBufferObjectui64v"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 8,
               [&](GLuint name, GLintptr at) { gl.GetQueryBufferObjectui64v(name, s.colours, GL_QUERY_RESULT, at); });
       },
       desktop_apis,
       45},
      {"GetQueryBufferObjecti64v",
       {"GetQueryBufferObjecti64v"},
       Concern::arrays,
       [](Test&, Scene& s) {
         query(s, 8,
               [&](GLuint name, GLintptr at) { gl.GetQueryBufferObjecti64v(name, s.colours, GL_QUERY_RESULT, at); });
       },
       desktop_apis,
       45},
  };
}

}  // namespace

Cases results_in_buffers_cases() {
  static const std::vector<Change> changes = joined({texture_images(), query_results()});
  return change_cases("result", changes, 60);
}

}  // namespace glark::conformance
