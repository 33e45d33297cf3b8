// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Vertex formats, vertex buffer bindings and vertex arrays of generic attributes.
#include "conformance/random/row.h"

namespace glark::conformance {
namespace {

constexpr const char* family = "vertex arrays";

struct Format {
  GLint size;
  GLenum type;
  GLboolean normalized;
};

// Types whose values are near 0 to 1. A stage that is not affine bounds what it reads, so there integers may be whole.
Format any_format(World& w) {
  const GLint size = w.values.between(1, 4);
  const GLenum type = w.values.pick<GLenum>({GL_FLOAT, GL_FLOAT, GL_HALF_FLOAT, GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT,
                                             GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_INT_2_10_10_10_REV});
  const bool is_packed = type == GL_INT_2_10_10_10_REV;
  const bool is_float = type == GL_FLOAT || type == GL_HALF_FLOAT;
  return {is_packed ? 4 : size, type, static_cast<GLboolean>(is_float && w.values.coin() ? GL_FALSE : GL_TRUE)};
}

GLsizei any_stride(World& w) { return w.values.pick<GLsizei>({16, 20, 32, 24, 8}); }
GLintptr any_offset(World& w) { return 4 * w.values.between(0, 40); }
GLuint any_binding(World& w) { return w.values.coin() ? w.any_float_attribute() : spare_binding; }
const void* at(GLintptr offset) { return reinterpret_cast<const void*>(offset); }

// Calls `make` while a buffer is bound to ARRAY_BUFFER.
template <typename Make>
void from_buffer(World& w, GLuint buffer, const Make& make) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  make();
  if (w.is_fixed()) gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

void vertex_attrib_pointer(World& w) {
  const Format format = any_format(w);
  from_buffer(w, w.any_buffer(), [&] {
    const GLsizei stride = w.values.below(4) == 0 ? 0 : any_stride(w);
    gl.VertexAttribPointer(w.any_float_attribute(), format.size, format.type, format.normalized, stride,
                           at(any_offset(w)));
  });
}

void places_pointer(World& w) {
  const auto which = w.values.below(w.places.size());
  if (w.values.coin()) return point_at_places(w, which);
  from_buffer(w, w.places[which], [&] {  // z and w are 0 and 1 anyway
    gl.VertexAttribPointer(at_position, w.values.between(2, 4), GL_FLOAT, GL_FALSE, place_bytes, at(0));
  });
}

void vertex_attrib_format(World& w) {
  const Format format = any_format(w);
  gl.VertexAttribFormat(w.any_float_attribute(), format.size, format.type, format.normalized,
                        static_cast<GLuint>(any_offset(w)));
}

void vertex_attrib_binding(World& w) { gl.VertexAttribBinding(w.any_float_attribute(), any_binding(w)); }

void bind_vertex_buffer(World& w) {
  gl.BindVertexBuffer(any_binding(w), w.any_buffer(), any_offset(w), w.values.below(5) == 0 ? 0 : any_stride(w));
}

struct Bindings {
  std::array<GLuint, 2> buffers;
  std::array<GLintptr, 2> offsets;
  std::array<GLsizei, 2> strides;
};

Bindings any_bindings(World& w) {
  return {{w.any_buffer(), w.any_buffer()}, {any_offset(w), any_offset(w)}, {any_stride(w), any_stride(w)}};
}

void bind_vertex_buffers(World& w) {
  const Bindings all = any_bindings(w);
  gl.BindVertexBuffers(at_columns, 2, all.buffers.data(), all.offsets.data(), all.strides.data());
}

// The bound vertex array, or another one.
GLuint any_array(World& w) {
  GLint bound = 0;
  gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  return w.values.coin() && bound != 0 ? static_cast<GLuint>(bound) : w.arrays[w.values.below(w.arrays.size())];
}

void array_vertex_buffer(World& w) {
  const GLuint array = any_array(w);
  gl.VertexArrayVertexBuffer(array, any_binding(w), w.any_buffer(), any_offset(w), any_stride(w));
}

void array_vertex_buffers(World& w) {
  const GLuint array = any_array(w);
  const Bindings all = any_bindings(w);
  gl.VertexArrayVertexBuffers(array, at_columns, 2, all.buffers.data(), all.offsets.data(), all.strides.data());
}

void array_attrib_format(World& w) {
  const GLuint array = any_array(w);
  const Format format = any_format(w);
  gl.VertexArrayAttribFormat(array, w.any_float_attribute(), format.size, format.type, format.normalized,
                             static_cast<GLuint>(any_offset(w)));
}

void integer_pointer(World& w) {
  const auto type = w.values.pick<GLenum>({GL_BYTE, GL_UNSIGNED_BYTE});
  from_buffer(w, w.any_buffer(), [&] {
    gl.VertexAttribIPointer(at_integers, w.values.between(1, 4), type, any_stride(w), at(any_offset(w)));
  });
}

void integer_format(World& w) {
  const auto type = w.values.pick<GLenum>({GL_BYTE, GL_UNSIGNED_BYTE});
  gl.VertexAttribIFormat(at_integers, w.values.between(1, 4), type, static_cast<GLuint>(any_offset(w)));
  gl.VertexAttribBinding(at_integers, at_integers);
  gl.BindVertexBuffer(at_integers, w.any_buffer(), any_offset(w), any_stride(w));
}

void double_pointer(World& w) {
  from_buffer(w, w.doubles[w.values.below(w.doubles.size())], [&] {
    gl.VertexAttribLPointer(at_doubles, w.values.between(1, 4), GL_DOUBLE, 8 * w.values.between(1, 5),
                            at(8 * w.values.between(0, 9)));
  });
}

void double_format(World& w) {
  gl.VertexAttribLFormat(at_doubles, w.values.between(1, 4), GL_DOUBLE,
                         static_cast<GLuint>(8 * w.values.between(0, 9)));
  gl.VertexAttribBinding(at_doubles, at_doubles);
  gl.BindVertexBuffer(at_doubles, w.doubles[w.values.below(2)], 8 * w.values.between(0, 9), 8 * w.values.between(1, 5));
}

GLuint any_switchable(World& w) {
  const GLuint others = w.is_desktop() ? 3 : 2;
  const auto which = static_cast<GLuint>(w.values.below(float_attributes.size() + others));
  if (which < float_attributes.size()) return float_attributes[which];
  return which == float_attributes.size() ? at_integers : which == float_attributes.size() + 1 ? at_colour : at_doubles;
}

// Gives the array a pointer before it is enabled, so that it reads a buffer.
void enable_array(World& w) {
  const GLuint index = any_switchable(w);
  GLint buffer = 0;
  gl.GetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
  if (buffer == 0) {
    if (index == at_integers) return integer_pointer(w);
    if (index == at_doubles) return double_pointer(w);
    from_buffer(w, w.any_buffer(),
                [&] { gl.VertexAttribPointer(index, 4, GL_FLOAT, GL_FALSE, 16, at(any_offset(w))); });
  }
  gl.EnableVertexAttribArray(index);
}

// Enables arrays that read a buffer in the bound vertex array.
void array_enable(World& w) {
  GLint bound = 0;
  gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  if (bound == 0) return;
  const GLuint index = w.any_float_attribute();
  GLint buffer = 0;
  gl.GetVertexAttribiv(index, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
  if (buffer != 0) gl.EnableVertexArrayAttrib(static_cast<GLuint>(bound), index);
}

void new_array(World& w) {
  GLuint& name = w.arrays[w.values.below(w.arrays.size())];
  gl.DeleteVertexArrays(1, &name);
  gl.GenVertexArrays(1, &name);
  gl.BindVertexArray(name);
  point_at_places(w, w.values.below(2));
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, w.elements);
  enable_array(w);
}

// Other content of a buffer that arrays read, by different commands.
void write_data(World& w) {
  std::array<float, 64> values{};
  for (float& each : values) each = 0.25F + 0.75F * w.values.fraction();
  const GLuint buffer = w.any_buffer();
  const GLintptr offset = 64 * w.values.between(0, 12);
  if (w.values.coin() && gl.NamedBufferSubData != nullptr) {
    gl.NamedBufferSubData(buffer, offset, sizeof(values), values.data());
    return;
  }
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
  if (w.values.coin()) {
    gl.BufferSubData(GL_COPY_WRITE_BUFFER, offset, sizeof(values), values.data());
  } else {
    auto* const mapped =
        static_cast<float*>(gl.MapBufferRange(GL_COPY_WRITE_BUFFER, offset, sizeof(values), GL_MAP_WRITE_BIT));
    if (mapped != nullptr) std::copy(values.begin(), values.end(), mapped);
    gl.UnmapBuffer(GL_COPY_WRITE_BUFFER);
  }
}

void copy_data(World& w) {
  gl.BindBuffer(GL_COPY_READ_BUFFER, w.data[1]);
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, w.data[w.values.coin() ? 0 : 2]);
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 64 * w.values.between(0, 9),
                       64 * w.values.between(0, 9), 256);
}

void write_elements(World& w) {
  const std::array<GLushort, 3> triangle = {static_cast<GLushort>(3 * w.values.between(0, 15)),
                                            static_cast<GLushort>(3 * w.values.between(0, 15) + 1),
                                            static_cast<GLushort>(3 * w.values.between(0, 15) + 2)};
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, w.elements);
  gl.BufferSubData(GL_COPY_WRITE_BUFFER, short_indices + 6 * w.values.between(0, 15), sizeof(triangle),
                   triangle.data());
}

void write_commands(World& w) {
  const GLuint count = 3 * static_cast<GLuint>(w.values.between(1, 8));
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, w.commands);
  for (const GLintptr word : {0, 8, 32, 40}) gl.BufferSubData(GL_COPY_WRITE_BUFFER, 4 * word, 4, &count);
}

}  // namespace

Rows array_rows() {
  using enum Where;
  return {
      {"VertexAttribPointer", family, stage, vertex_attrib_pointer},
      {"VertexAttribPointer of places", family, stage, places_pointer},
      {"VertexAttribFormat", family, stage, vertex_attrib_format},
      {"VertexAttribBinding", family, stage, vertex_attrib_binding},
      {"BindVertexBuffer", family, stage, bind_vertex_buffer},
      {"BindVertexBuffers", family, stage, bind_vertex_buffers, desktop_apis, 44},
      {"VertexArrayVertexBuffer", family, stage, array_vertex_buffer, desktop_apis, 45},
      {"VertexArrayVertexBuffers", family, stage, array_vertex_buffers, desktop_apis, 45},
      {"VertexArrayAttribFormat", family, stage, array_attrib_format, desktop_apis, 45},
      {"VertexArrayAttribBinding", family, stage,
       [](World& w) {
         const GLuint array = any_array(w);
         gl.VertexArrayAttribBinding(array, w.any_float_attribute(), any_binding(w));
       },
       desktop_apis, 45},
      {"VertexAttribDivisor", family, stage,
       [](World& w) { gl.VertexAttribDivisor(w.any_float_attribute(), static_cast<GLuint>(w.values.below(3))); }},
      {"VertexBindingDivisor", family, stage,
       [](World& w) { gl.VertexBindingDivisor(any_binding(w), static_cast<GLuint>(w.values.below(3))); }},
      {"VertexArrayBindingDivisor", family, stage,
       [](World& w) {
         const GLuint array = any_array(w);
         gl.VertexArrayBindingDivisor(array, any_binding(w), static_cast<GLuint>(w.values.below(3)));
       },
       desktop_apis, 45},
      {"VertexAttribIPointer", family, stage, integer_pointer},
      {"VertexAttribIFormat", family, stage, integer_format},
      {"VertexAttribLPointer", family, stage, double_pointer, desktop_apis},
      {"VertexAttribLFormat", family, stage, double_format, desktop_apis},
      {"EnableVertexAttribArray", family, stage, enable_array},
      {"DisableVertexAttribArray", family, stage, [](World& w) { gl.DisableVertexAttribArray(any_switchable(w)); }},
      {"EnableVertexArrayAttrib", family, stage, array_enable, desktop_apis, 45},
      {"DisableVertexArrayAttrib", family, stage,
       [](World& w) {
         const GLuint array = any_array(w);
         gl.DisableVertexArrayAttrib(array, w.any_float_attribute());
       },
       desktop_apis, 45},
      {"BindVertexArray", family, shader,
       [](World& w) { gl.BindVertexArray(w.arrays[w.values.below(w.arrays.size())]); }},
      {"DeleteVertexArrays", family, stage, new_array},
      {"BufferSubData", "buffers", everywhere, write_data},
      {"CopyBufferSubData", "buffers", everywhere, copy_data},
      {"BufferSubData of elements", "buffers", shader, write_elements},
      {"BufferSubData of commands", "buffers", shader, write_commands},
  };
}

}  // namespace glark::conformance
