// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/renderer.h"

#include <cstddef>

namespace glark::shim {
namespace {

// Without a version: GLSL 1.10 and GLSL ES 1.00.
constexpr char vertex_source[] = R"(
attribute vec2 position;
attribute vec2 coordinate;
attribute vec4 color;
uniform vec2 origin;  // of the picture in the window
uniform vec2 size;
varying vec2 at;
varying vec4 tint;
void main() {
  at = coordinate;
  tint = color;
  vec2 place = (position - origin) * 2.0 / size - 1.0;
  gl_Position = vec4(place.x, -place.y, 0.0, 1.0);
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

const void* at_offset(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

bool PanelRenderer::start() {
  program_ = build_panel_program(gl_, vertex_source, fragment_source);
  if (program_ == 0) return false;
  origin_ = gl_.GetUniformLocation(program_, "origin");
  size_ = gl_.GetUniformLocation(program_, "size");
  gl_.GenBuffers(1, &vertices_);
  gl_.GenBuffers(1, &indices_);
  make_font();
  return picture_.start();
}

void PanelRenderer::make_font() {
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
}

// The context is ours alone, but its state is that of the last frame.
void PanelRenderer::set_state() const {
  const Area& area = lists_.area();
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.UseProgram(program_);
  gl_.Uniform2f(origin_, static_cast<GLfloat>(area.x), static_cast<GLfloat>(area.y));
  gl_.Uniform2f(size_, static_cast<GLfloat>(area.width), static_cast<GLfloat>(area.height));
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

void PanelRenderer::draw_list(const ImDrawList& list) const {
  gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
  const Area& area = lists_.area();
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const auto left = static_cast<GLint>(command.ClipRect.x);
    const auto top = static_cast<GLint>(command.ClipRect.y);
    const auto width = static_cast<GLint>(command.ClipRect.z) - left;
    const auto height = static_cast<GLint>(command.ClipRect.w) - top;
    if (width <= 0 || height <= 0 || command.UserCallback != nullptr) continue;
    gl_.Scissor(left - area.x, area.y + area.height - top - height, width, height);
    set_first_vertex(command.VtxOffset);
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                     sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                     at_offset(command.IdxOffset * sizeof(ImDrawIdx)));
  }
}

void PanelRenderer::paint(const ImDrawData& data) {
  if (!picture_.begin(lists_.area())) return;
  set_state();
  for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i]);
}

void PanelRenderer::draw(const ImDrawData& data, int frame, Size window, const Area& opaque) {
  if (frame != frame_ && lists_.update(data)) paint(data);
  frame_ = frame;
  picture_.show(window, lists_.area() == opaque);
}

}  // namespace glark::shim
