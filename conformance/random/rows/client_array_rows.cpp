// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Arrays of the fixed function, in buffers and in the application's memory.
#include <cstring>

#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "client arrays";

// Calls `point` with an address: an offset into a bound buffer, or a place in memory. Both have the same size.
template <typename Point>
void from_somewhere(World& w, GLuint buffer, const void* memory, GLintptr offset, const Point& point) {
  if (w.values.coin()) return point(static_cast<const char*>(memory) + offset);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  point(reinterpret_cast<const char*>(offset));
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

template <typename Point>
void from_places(World& w, GLintptr offset, const Point& point) {
  from_somewhere(w, w.places[w.values.below(2)], w.places_memory.data(), offset, point);
}

template <typename Point>
void from_data(World& w, const Point& point) {
  from_somewhere(w, w.any_buffer(), w.memory.data(), 8 * w.values.between(0, 20), point);
}

GLsizei any_stride(World& w) { return w.values.pick<GLsizei>({16, 24, 32, 40}); }

GLenum any_colour_type(World& w) {
  return w.values.pick<GLenum>(
      {GL_FLOAT, GL_FLOAT, GL_UNSIGNED_BYTE, GL_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT});
}

void vertex_pointer(World& w) {
  const GLint size = w.values.between(2, 4);
  from_places(w, 0, [size](const void* at) { gl.VertexPointer(size, GL_FLOAT, place_bytes, at); });
}

void normal_pointer(World& w) {
  if (w.values.coin())
    return from_places(w, normal_offset, [](const void* at) { gl.NormalPointer(GL_FLOAT, place_bytes, at); });
  const auto type = w.values.pick<GLenum>({GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT});
  const GLsizei stride = any_stride(w);
  from_data(w, [&](const void* at) { gl.NormalPointer(type, stride, at); });
}

void color_pointer(World& w) {
  const GLint size = w.values.between(3, 4);
  const GLenum type = any_colour_type(w);
  const GLsizei stride = any_stride(w);
  from_data(w, [&](const void* at) { gl.ColorPointer(size, type, stride, at); });
}

void secondary_color_pointer(World& w) {
  const GLenum type = any_colour_type(w);
  const GLsizei stride = any_stride(w);
  from_data(w, [&](const void* at) { gl.SecondaryColorPointer(3, type, stride, at); });
}

void tex_coord_pointer(World& w) {
  const GLint size = w.values.between(1, 3);
  const GLsizei stride = any_stride(w);
  from_data(w, [&](const void* at) { gl.TexCoordPointer(size, GL_FLOAT, stride, at); });
}

void fog_coord_pointer(World& w) {
  const GLsizei stride = any_stride(w);
  from_data(w, [&](const void* at) { gl.FogCoordPointer(GL_FLOAT, stride, at); });
}

// An array that is enabled has a pointer: the rows above give it one first.
void enable_client_state(World& w) {
  switch (w.values.below(5)) {
    case 0: normal_pointer(w), gl.EnableClientState(GL_NORMAL_ARRAY); break;
    case 1: color_pointer(w), gl.EnableClientState(GL_COLOR_ARRAY); break;
    case 2: secondary_color_pointer(w), gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY); break;
    case 3: fog_coord_pointer(w), gl.EnableClientState(GL_FOG_COORD_ARRAY); break;
    default: tex_coord_pointer(w), gl.EnableClientState(GL_TEXTURE_COORD_ARRAY); break;
  }
}

void disable_client_state(World& w) {
  gl.DisableClientState(w.values.pick<GLenum>(
      {GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY}));
}

// The application's memory changes without a call.
void write_memory(World& w) {
  const std::size_t first = w.values.below(w.memory.size() - 64);
  for (std::size_t i = 0; i < 64; ++i) w.memory[first % 512 + i] = 0.25F + 0.75F * w.values.fraction();
}

void write_places_memory(World& w) {
  const std::size_t vertex = w.values.below(drawn_vertices);
  const std::array<float, 3> position = {6 * w.values.number(), 6 * w.values.number(), w.values.number()};
  std::memcpy(&w.places_memory[vertex * place_bytes], position.data(), sizeof(position));
}

void write_elements_memory(World& w) {
  w.elements_memory[w.values.below(40)] = static_cast<GLushort>(w.values.between(0, drawn_vertices - 1));
}

void interleaved_arrays(World& w) {
  gl.InterleavedArrays(GL_C4F_N3F_V3F, 0, w.memory.data());
  from_places(w, 0, [](const void* at) { gl.VertexPointer(3, GL_FLOAT, place_bytes, at); });
}

}  // namespace

Rows client_array_rows() {
  using enum Where;
  const auto row = [](const char* name, void (*make)(World&)) { return Row{name, family, fixed, make, compat_only}; };
  return {
      row("VertexPointer", vertex_pointer),
      row("NormalPointer", normal_pointer),
      row("ColorPointer", color_pointer),
      row("SecondaryColorPointer", secondary_color_pointer),
      row("TexCoordPointer", tex_coord_pointer),
      row("FogCoordPointer", fog_coord_pointer),
      row("EnableClientState", enable_client_state),
      row("DisableClientState", disable_client_state),
      row("ClientActiveTexture",
          [](World& w) { gl.ClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(w.values.below(2))); }),
      row("InterleavedArrays", interleaved_arrays),
      row("written memory", write_memory),
      row("written places", write_places_memory),
      row("written elements", write_elements_memory),
  };
}

}  // namespace glark::conformance
