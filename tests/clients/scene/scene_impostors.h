// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Quads whose vertex stages have no meaning between the corners: balls drawn by their fragments, sticks whose corners
// are chosen by branches, and glyphs placed by gl_VertexID. The picture is lost if a stage runs on interpolated inputs.
// A client defines GL(name) as for scene_fixed.h. For a core profile of OpenGL 4.5.
#pragma once

#include "tests/clients/scene/picture.h"

enum { ball_count = 9, corner_floats = 8 };

// The fourth number is four times the radius, in hundredths, and the number of the corner.
static const char ball_vertex[] =
    "#version 450 core\n"
    "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
    "out vec2 corner; out vec3 color;\n"
    "void main() {\n"
    "  float number = mod(position.w, 4.0);\n"
    "  float radius = floor(position.w / 4.0) * 0.01;\n"
    "  corner = 2.0 * vec2(mod(number, 2.0), floor(number / 2.0)) - 1.0;\n"
    "  color = abs(normal);\n"
    "  gl_Position = vec4(position.xy + radius * corner, position.z, 1.0);\n"
    "}\n";
static const char ball_fragment[] =
    "#version 450 core\n"
    "in vec2 corner; in vec3 color; out vec4 result;\n"
    "void main() {\n"
    "  float height = 1.0 - dot(corner, corner);\n"
    "  if (height < 0.0) discard;\n"
    "  result = vec4(color * (0.3 + 0.7 * sqrt(height)), 1.0);\n"
    "}\n";

static const char stick_vertex[] =
    "#version 450 core\n"
    "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
    "out vec3 color;\n"
    "void main() {\n"
    "  float number = mod(position.w, 4.0);\n"
    "  vec2 at = position.xy;\n"
    "  if (number >= 2.0) at += 0.4 * normal.xy;\n"
    "  vec2 side = 0.03 * normalize(vec2(-normal.y, normal.x));\n"
    "  at += (number == 0.0 || number == 2.0) ? side : -side;\n"
    "  color = vec3(0.9, 0.9, 0.3 * number);\n"
    "  gl_Position = vec4(at, position.z + 0.1, 1.0);\n"
    "}\n";
static const char stick_fragment[] =
    "#version 450 core\n"
    "in vec3 color; out vec4 result;\n"
    "void main() { result = vec4(color, 1.0); }\n";

static const char glyph_vertex[] =
    "#version 450 core\n"
    "out vec2 corner; flat out uint glyph;\n"
    "void main() {\n"
    "  corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);\n"
    "  glyph = uint(gl_VertexID) / 4u;\n"
    "  gl_Position = vec4(-0.9 + 0.2 * (float(glyph) + 0.8 * corner.x), -0.9 + 0.2 * corner.y, 0.0, 1.0);\n"
    "}\n";
static const char glyph_fragment[] =
    "#version 450 core\n"
    "in vec2 corner; flat in uint glyph; out vec4 result;\n"
    "void main() {\n"
    "  ivec2 cell = ivec2(corner * vec2(3.0, 4.0));\n"
    "  if (((11111u * (glyph + 3u)) >> uint(cell.x + 3 * cell.y) & 1u) == 0u) discard;\n"
    "  result = vec4(0.8, 1.0, 0.8, 1.0);\n"
    "}\n";

static GLuint ball_program, stick_program, glyph_program;

static GLuint impostor_program(const char* vertex, const char* fragment) {
  const GLuint program = GL(CreateProgram)();
  const char* const sources[2] = {vertex, fragment};
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = GL(CreateShader)(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    GL(ShaderSource)(shader, 1, &sources[i], NULL);
    GL(CompileShader)(shader);
    GL(AttachShader)(program, shader);
  }
  GL(LinkProgram)(program);
  GLint linked = 0;
  GL(GetProgramiv)(program, GL_LINK_STATUS, &linked);
  require(linked, "the program did not link");
  return program;
}

static void scene_setup(void) {
  static GLfloat corners[4 * ball_count][corner_floats];
  static GLushort indices[ball_count][6];
  for (int i = 0; i < 4 * ball_count; ++i) {
    const int ball = i / 4;
    const int number = i % 4;
    const int row = ball / 3;
    const GLfloat corner[corner_floats] = {-0.6f + 0.5f * (GLfloat)(ball % 3),
                                           -0.4f + 0.5f * (GLfloat)row,
                                           0.04f * (GLfloat)ball,
                                           (GLfloat)(4 * (12 + 2 * ball) + number),
                                           0.3f + 0.08f * (GLfloat)ball,
                                           0.9f - 0.09f * (GLfloat)ball,
                                           0.5f,
                                           0};
    for (int k = 0; k < corner_floats; ++k) corners[i][k] = corner[k];
  }
  for (int ball = 0; ball < ball_count; ++ball) {
    static const GLushort order[6] = {0, 1, 2, 2, 1, 3};
    for (int k = 0; k < 6; ++k) indices[ball][k] = (GLushort)(4 * ball + order[k]);
  }
  ball_program = impostor_program(ball_vertex, ball_fragment);
  stick_program = impostor_program(stick_vertex, stick_fragment);
  glyph_program = impostor_program(glyph_vertex, glyph_fragment);
  GLuint array;
  GL(GenVertexArrays)(1, &array);
  GL(BindVertexArray)(array);
  GLuint buffers[2];
  GL(GenBuffers)(2, buffers);
  GL(BindBuffer)(GL_ARRAY_BUFFER, buffers[0]);
  GL(BufferData)(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
  GL(BindBuffer)(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  GL(BufferData)(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  GL(VertexAttribPointer)(0, 4, GL_FLOAT, GL_FALSE, sizeof corners[0], NULL);
  GL(VertexAttribPointer)(1, 3, GL_FLOAT, GL_FALSE, sizeof corners[0], (const char*)NULL + 4 * sizeof(GLfloat));
  GL(EnableVertexAttribArray)(0);
  GL(EnableVertexAttribArray)(1);
  GL(Viewport)(0, 0, picture_size, picture_size);
  GL(ClearColor)(0.1f, 0.2f, 0.3f, 1);
  GL(Enable)(GL_DEPTH_TEST);
}

static inline void scene_draw(void) {
  GL(Clear)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  GL(UseProgram)(ball_program);
  GL(DrawElements)(GL_TRIANGLES, 6 * ball_count, GL_UNSIGNED_SHORT, NULL);
  GL(UseProgram)(stick_program);
  GL(DrawElements)(GL_TRIANGLES, 6 * ball_count, GL_UNSIGNED_SHORT, NULL);
  GL(UseProgram)(glyph_program);
  GL(DrawElements)(GL_TRIANGLES, 6 * ball_count, GL_UNSIGNED_SHORT, NULL);
}

// Reads the last frame back, before the buffers are swapped.
static inline void scene_read(unsigned char pixels[4 * picture_size * picture_size]) {
  GL(Finish)();
  GL(PixelStorei)(GL_PACK_ALIGNMENT, 1);
  GL(ReadPixels)(0, 0, picture_size, picture_size, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  require(GL(GetError)() == GL_NO_ERROR, "the scene raised a GL error");
}
