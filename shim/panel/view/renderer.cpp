// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/renderer.h"

#include <algorithm>
#include <cstddef>

namespace glark::shim {
namespace {

// Without a version: GLSL 1.10 and GLSL ES 1.00.
constexpr char vertex_source[] = R"(
attribute vec2 position;
attribute vec2 coordinate;
attribute vec4 color;
uniform vec2 size;
varying vec2 at;
varying vec4 tint;
void main() {
  at = coordinate;
  tint = color;
  gl_Position = vec4(position.x * 2.0 / size.x - 1.0, 1.0 - position.y * 2.0 / size.y, 0.0, 1.0);
}
)";
constexpr char fragment_source[] = R"(
#ifdef GL_ES
precision mediump float;
#endif
uniform sampler2D font;
varying vec2 at;
varying vec4 tint;
void main() { gl_FragColor = vec4(tint.rgb, tint.a * texture2D(font, at).a); }
)";

GLuint compile(const gl::Dispatch& gl, GLenum stage, const char* source) {
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  return shader;
}

const void* at_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

bool PanelRenderer::start() {
  program_ = gl_.CreateProgram();
  for (const GLuint shader :
       {compile(gl_, GL_VERTEX_SHADER, vertex_source), compile(gl_, GL_FRAGMENT_SHADER, fragment_source)}) {
    gl_.AttachShader(program_, shader);
    gl_.DeleteShader(shader);
  }
  gl_.BindAttribLocation(program_, 0, "position");
  gl_.BindAttribLocation(program_, 1, "coordinate");
  gl_.BindAttribLocation(program_, 2, "color");
  gl_.LinkProgram(program_);
  GLint linked = GL_FALSE;
  gl_.GetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) return false;
  size_ = gl_.GetUniformLocation(program_, "size");
  gl_.GenBuffers(1, &vertices_);
  gl_.GenBuffers(1, &indices_);

  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  gl_.GenTextures(1, &font_);
  gl_.BindTexture(GL_TEXTURE_2D, font_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})  // OpenGL ES 2 needs it for this size
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, width, height, 0, GL_ALPHA, GL_UNSIGNED_BYTE, pixels);
  return gl_.GetError() == GL_NO_ERROR;
}

// The context is ours alone, but its state is that of the last frame.
void PanelRenderer::set_state(const ImDrawData& data, Size size) const {
  gl_.Viewport(0, 0, size.width, size.height);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.UseProgram(program_);
  gl_.Uniform2f(size_, data.DisplaySize.x, data.DisplaySize.y);
  gl_.BindTexture(GL_TEXTURE_2D, font_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  for (const GLuint attribute : {0U, 1U, 2U}) gl_.EnableVertexAttribArray(attribute);
}

// Lists with more vertices than an index can name begin at several of them.
void PanelRenderer::set_first_vertex(unsigned vertex) const {
  constexpr GLsizei stride = sizeof(ImDrawVert);
  const std::size_t first = vertex * sizeof(ImDrawVert);
  gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, stride, at_offset(first + offsetof(ImDrawVert, pos)));
  gl_.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, at_offset(first + offsetof(ImDrawVert, uv)));
  gl_.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, at_offset(first + offsetof(ImDrawVert, col)));
}

void PanelRenderer::draw_list(const ImDrawList& list, const ImDrawData& data, Size size) const {
  gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
  const float scale = static_cast<float>(size.width) / data.DisplaySize.x;
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const auto left = static_cast<GLint>(command.ClipRect.x * scale);
    const auto top = static_cast<GLint>(command.ClipRect.y * scale);
    const auto width = static_cast<GLint>(command.ClipRect.z * scale) - left;
    const auto height = static_cast<GLint>(command.ClipRect.w * scale) - top;
    if (width <= 0 || height <= 0 || command.UserCallback != nullptr) continue;
    gl_.Scissor(std::max(left, 0), size.height - top - height, width, height);
    set_first_vertex(command.VtxOffset);
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                     sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                     at_offset(command.IdxOffset * sizeof(ImDrawIdx)));
  }
}

void PanelRenderer::draw(const ImDrawData& data, Size size) const {
  set_state(data, size);
  for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data, size);
}

}  // namespace glark::shim
