// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Vertices in buffers: every format, stride, offset and divisor. The picture must not change.
#include <cstring>

#include "tests/core/support/program_scene.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

struct Format {
  const char* name;
  GLenum type;
  GLint size;  // GL_BGRA too
  GLboolean normalized;
  GLuint bytes;  // of a vertex
  float scale;   // from what the shader sees to a colour
};

const Format formats[] = {
    {"byte", GL_BYTE, 3, GL_TRUE, 4, 1},
    {"unsigned_byte", GL_UNSIGNED_BYTE, 3, GL_TRUE, 4, 1},
    {"unsigned_byte_bgra", GL_UNSIGNED_BYTE, GL_BGRA, GL_TRUE, 4, 1},
    {"unsigned_byte_as_float", GL_UNSIGNED_BYTE, 4, GL_FALSE, 4, 1.0F / 255},
    {"short", GL_SHORT, 3, GL_TRUE, 8, 1},
    {"short_as_float", GL_SHORT, 3, GL_FALSE, 8, 1.0F / 32768},
    {"unsigned_short", GL_UNSIGNED_SHORT, 4, GL_TRUE, 8, 1},
    {"int", GL_INT, 3, GL_TRUE, 12, 1},
    {"unsigned_int", GL_UNSIGNED_INT, 3, GL_TRUE, 12, 1},
    {"unsigned_int_as_float", GL_UNSIGNED_INT, 2, GL_FALSE, 8, 2.3e-10F},
    {"half", GL_HALF_FLOAT, 3, GL_FALSE, 8, 1},
    {"float", GL_FLOAT, 3, GL_FALSE, 12, 1},
    {"double", GL_DOUBLE, 3, GL_FALSE, 24, 1},
    {"fixed", GL_FIXED, 3, GL_FALSE, 12, 1},
    {"packed", GL_INT_2_10_10_10_REV, 4, GL_TRUE, 4, 1},
    {"packed_unsigned", GL_UNSIGNED_INT_2_10_10_10_REV, 4, GL_TRUE, 4, 1},
    {"packed_unsigned_bgra", GL_UNSIGNED_INT_2_10_10_10_REV, GL_BGRA, GL_TRUE, 4, 1},
    {"packed_as_float", GL_UNSIGNED_INT_2_10_10_10_REV, 4, GL_FALSE, 4, 1.0F / 1023},
    {"packed_floats", GL_UNSIGNED_INT_10F_11F_11F_REV, 3, GL_FALSE, 4, 1},
};

// Bytes that are colours in that format: fractions for floating-point formats, any value for integers.
std::vector<GLubyte> colors_in(const Format& format, GLuint stride, int vertices) {
  std::vector<GLubyte> bytes(static_cast<std::size_t>(stride) * static_cast<std::size_t>(vertices));
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<GLubyte>(i * 83 + 40);
  const auto put = [&](std::size_t at, const auto& value) { std::memcpy(&bytes[at], &value, sizeof value); };
  for (int vertex = 0; vertex < vertices; ++vertex) {
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = static_cast<std::size_t>(vertex) * stride;
      const auto step = static_cast<GLushort>((vertex * 5 + k * 7) % 11);
      const auto index = static_cast<std::size_t>(k);
      if (format.type == GL_FLOAT) put(at + 4 * index, 0.1F * static_cast<float>(step));
      if (format.type == GL_DOUBLE) put(at + 8 * index, 0.1 * static_cast<double>(step));
      if (format.type == GL_FIXED) put(at + 4 * index, static_cast<GLint>(step) * 6500);
      if (format.type == GL_HALF_FLOAT) put(at + 2 * index, static_cast<GLushort>(0x3000 + 0x100 * step));
    }
    // Exponents about 1/2.
    const GLuint packed = 0x700U << 11 | 0x340U | 0x1c0U << 22 | static_cast<GLuint>(vertex * 9) << 12;
    if (format.type == GL_UNSIGNED_INT_10F_11F_11F_REV) put(static_cast<std::size_t>(vertex) * stride, packed);
  }
  return bytes;
}

class VertexFormats : public testing::TestWithParam<Format> {
 protected:
  VertexFormats() {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    make_buffer(GL_ARRAY_BUFFER, mode_shapes()[1].vertices);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), nullptr);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    const GLuint program = link_program(
        {.vertex = inputs + "uniform float scale; out vec3 c;\nvoid main() { gl_Position = vec4(position, 0.0, "
                            "1.0); c = 0.5 + 0.45 * color * scale; }\n",
         .fragment = pass_color});
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "scale"), GetParam().scale);
  }
  OsmesaContext context_{Profile::compatibility};
  GLuint array_ = 0;
};

INSTANTIATE_TEST_SUITE_P(All, VertexFormats, testing::ValuesIn(formats),
                         [](const testing::TestParamInfo<Format>& format) { return std::string(format.param.name); });

void draw_strip() { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); }

TEST_P(VertexFormats, FromAPointer) {
  const Format& format = GetParam();
  make_buffer(GL_ARRAY_BUFFER, colors_in(format, format.bytes, 7));
  glVertexAttribPointer(1, format.size, format.type, format.normalized, static_cast<GLsizei>(format.bytes), nullptr);
  expect_same_scene({4}, draw_strip);
  glVertexAttribPointer(1, format.size, format.type, format.normalized, static_cast<GLsizei>(format.bytes),
                        byte_offset(format.bytes));
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw_strip);
}

TEST_P(VertexFormats, FromClientMemory) {
  const Format& format = GetParam();
  const std::vector<GLubyte> colors = colors_in(format, format.bytes, 6);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), mode_shapes()[1].vertices.data());
  glVertexAttribPointer(1, format.size, format.type, format.normalized, static_cast<GLsizei>(format.bytes),
                        colors.data());
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  expect_same_scene({4}, draw_strip);
}

// Format and binding apart: a relative offset, an offset of the binding, and a stride with a gap.
TEST_P(VertexFormats, FromABinding) {
  const Format& format = GetParam();
  const GLuint stride = format.bytes + 16;
  std::vector<GLubyte> colors(40);
  const std::vector<GLubyte> strided = colors_in(format, stride, 6);
  colors.insert(colors.end(), strided.begin(), strided.end());
  const GLuint buffer = make_buffer(GL_ARRAY_BUFFER, colors);
  glVertexAttribFormat(1, format.size, format.type, format.normalized, 8);
  glVertexAttribBinding(1, 5);
  glBindVertexBuffer(5, buffer, 32, static_cast<GLsizei>(stride));
  expect_same_scene({4}, draw_strip);
}

TEST_P(VertexFormats, OnePerInstanceAndOneForAll) {
  const Format& format = GetParam();
  const GLuint buffer = make_buffer(GL_ARRAY_BUFFER, colors_in(format, format.bytes, 3));
  glVertexAttribFormat(1, format.size, format.type, format.normalized, 0);
  glVertexAttribBinding(1, 3);
  glBindVertexBuffer(3, buffer, 0, static_cast<GLsizei>(format.bytes));
  glVertexBindingDivisor(3, 2);
  expect_same_scene({24}, [] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 6, 6); });
  glVertexBindingDivisor(3, 0);
  glBindVertexBuffer(3, buffer, 0, 0);  // every vertex reads the first
  expect_same_scene({4}, draw_strip);
}

class VertexFormatsInterleaved : public testing::TestWithParam<GLenum> {
 protected:
  OsmesaContext context_{Profile::compatibility};
};

INSTANTIATE_TEST_SUITE_P(All, VertexFormatsInterleaved,
                         testing::Values(GL_V2F, GL_V3F, GL_C4UB_V2F, GL_C4UB_V3F, GL_C3F_V3F, GL_N3F_V3F,
                                         GL_C4F_N3F_V3F, GL_T2F_V3F, GL_T2F_C4UB_V3F, GL_T2F_C3F_V3F, GL_T2F_N3F_V3F,
                                         GL_T2F_C4F_N3F_V3F, GL_T4F_V4F, GL_T4F_C4F_N3F_V4F));

// All floats are between 0 and 1, so that each of them may be any of the attributes. Some colours are made from the
// bytes of one float.
TEST_P(VertexFormatsInterleaved, InterleavedArrays) {
  std::vector<GLfloat> data(15 * 9);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<GLfloat>((i * i * 37 + 11 * i) % 101) / 101.0F;
  const std::size_t floats = GetParam() == GL_T4F_V4F ? 8 : 15;
  const bool homogeneous = GetParam() == GL_T4F_V4F || GetParam() == GL_T4F_C4F_N3F_V4F;
  for (std::size_t w = floats - 1; homogeneous && w < data.size(); w += floats) data[w] = 1;
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
  const bool lit = GetParam() == GL_N3F_V3F || GetParam() == GL_C4F_N3F_V3F || GetParam() == GL_T2F_N3F_V3F ||
                   GetParam() == GL_T2F_C4F_N3F_V3F || GetParam() == GL_T4F_C4F_N3F_V4F;
  if (!lit) glDisable(GL_LIGHTING);
  glInterleavedArrays(GetParam(), 0, data.data());
  expect_same_scene({3}, [] { glDrawArrays(GL_TRIANGLES, 0, 9); });
  make_buffer(GL_ARRAY_BUFFER, data);
  glInterleavedArrays(GetParam(), 0, nullptr);
  expect_same_scene({3}, [] { glDrawArrays(GL_TRIANGLES, 0, 9); });
}

}  // namespace
}  // namespace glark::core::test
