// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/picture.h"

#include <algorithm>

namespace glark::shim {
namespace {

// Without a version: GLSL 1.10 and GLSL ES 1.00.
constexpr char picture_vertex_source[] = R"(
attribute vec2 position;
uniform vec2 scale;
varying vec2 at;
void main() {
  at = position * scale;
  gl_Position = vec4(position * 2.0 - 1.0, 0.0, 1.0);
}
)";
constexpr char picture_fragment_source[] = R"(
#ifdef GL_ES
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
#endif
uniform sampler2D picture;
varying vec2 at;
void main() { gl_FragColor = texture2D(picture, at); }
)";

GLuint compile(const gl::Dispatch& gl, GLenum stage, const char* source) {
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  return shader;
}

}  // namespace

// 0: GL refuses it.
GLuint build_panel_program(const gl::Dispatch& gl, const char* vertex_source, const char* fragment_source) {
  const GLuint program = gl.CreateProgram();
  for (const GLuint shader :
       {compile(gl, GL_VERTEX_SHADER, vertex_source), compile(gl, GL_FRAGMENT_SHADER, fragment_source)}) {
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader);
  }
  gl.BindAttribLocation(program, 0, "position");
  gl.BindAttribLocation(program, 1, "coordinate");
  gl.BindAttribLocation(program, 2, "color");
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked == GL_FALSE ? 0 : program;
}

bool PanelPicture::start() {
  program_ = build_panel_program(gl_, picture_vertex_source, picture_fragment_source);
  if (program_ == 0) return false;
  scale_ = gl_.GetUniformLocation(program_, "scale");
  constexpr GLfloat corners[] = {0, 0, 1, 0, 0, 1, 1, 1};
  gl_.GenBuffers(1, &corners_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, corners_);
  gl_.BufferData(GL_ARRAY_BUFFER, sizeof(corners), corners, GL_STATIC_DRAW);
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  gl_.GenFramebuffers(1, &frame_);
  return gl_.GetError() == GL_NO_ERROR;
}

void PanelPicture::grow(const Area& area) {
  if (area.width <= size_.width && area.height <= size_.height) return;
  size_ = {std::max(area.width, size_.width), std::max(area.height, size_.height)};
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size_.width, size_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
}

bool PanelPicture::begin(const Area& area) {
  area_ = area;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  grow(area);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
  gl_.Viewport(0, 0, area.width, area.height);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.ClearColor(0, 0, 0, 0);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  return true;
}

// The picture's colours are multiplied by its alpha: they were blended with nothing.
void PanelPicture::show(Size window, bool opaque) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (area_.width <= 0 || area_.height <= 0) return;
  gl_.Viewport(area_.x, window.height - area_.y - area_.height, area_.width, area_.height);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_DEPTH_TEST);
  opaque ? gl_.Disable(GL_BLEND) : gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.UseProgram(program_);
  gl_.Uniform2f(scale_, static_cast<GLfloat>(area_.width) / static_cast<GLfloat>(size_.width),
                static_cast<GLfloat>(area_.height) / static_cast<GLfloat>(size_.height));
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, corners_);
  gl_.EnableVertexAttribArray(0);
  gl_.DisableVertexAttribArray(1);
  gl_.DisableVertexAttribArray(2);
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace glark::shim
