// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A scene of shaders and vertex buffers, lit per vertex, for core profiles and OpenGL ES 2. A client defines these
// macros before it includes this file:
// - GL(name), as for scene_fixed.h;
// - SCENE_GLSL_VERTEX and SCENE_GLSL_FRAGMENT, the head of each shader: #version, and the keywords of this version for
//   INPUT, OUTPUT, VARYING and COLOR;
// - SCENE_HAS_VAO, 0 or 1.
// SCENE_LINK(program) may replace glLinkProgram.
#pragma once

#include "tests/clients/scene/picture.h"
#include "tests/clients/scene/sphere.h"

#define SCENE_GLSL_450_VERTEX "#version 450 core\n#define INPUT in\n#define OUTPUT out\n"
#define SCENE_GLSL_450_FRAGMENT "#version 450 core\n#define VARYING in\n#define COLOR color_out\nout vec4 color_out;\n"
#define SCENE_GLSL_120_VERTEX "#version 120\n#define INPUT attribute\n#define OUTPUT varying\n"
#define SCENE_GLSL_120_FRAGMENT "#version 120\n#define VARYING varying\n#define COLOR gl_FragColor\n"
#define SCENE_GLSL_100_VERTEX "#version 100\n#define INPUT attribute\n#define OUTPUT varying\n"
#define SCENE_GLSL_100_FRAGMENT \
  "#version 100\nprecision mediump float;\n#define VARYING varying\n#define COLOR gl_FragColor\n"

static const char scene_vertex_source[] = SCENE_GLSL_VERTEX
    "INPUT vec3 position;\n"
    "uniform vec3 centre;\n"
    "uniform vec3 base;\n"
    "OUTPUT vec3 shade;\n"
    "void main() {\n"
    "  vec3 p = position + centre;\n"
    "  float light = max(dot(position, normalize(vec3(2.0, 3.0, 4.0))), 0.0);\n"
    "  shade = base * (0.2 + 0.8 * light);\n"
    "  gl_Position = vec4(2.0 * p.xy, -1.5 * p.z - 5.0, -p.z);\n"  // a frustum from z = -2 to z = -10
    "}\n";
static const char scene_fragment_source[] = SCENE_GLSL_FRAGMENT
    "VARYING vec3 shade;\n"
    "void main() { COLOR = vec4(shade, 1.0); }\n";

#ifndef SCENE_LINK
#define SCENE_LINK GL(LinkProgram)
#endif

static GLint scene_centre, scene_base;

static inline GLuint scene_shader(GLenum kind, const char* source) {
  const GLuint shader = GL(CreateShader)(kind);
  GL(ShaderSource)(shader, 1, &source, NULL);
  GL(CompileShader)(shader);
  return shader;
}

static void scene_setup(void) {
  static GLfloat positions[3 * sphere_corners];
  static GLushort indices[sphere_indices];
  make_sphere(positions, indices);
  const GLuint program = GL(CreateProgram)();
  GL(AttachShader)(program, scene_shader(GL_VERTEX_SHADER, scene_vertex_source));
  GL(AttachShader)(program, scene_shader(GL_FRAGMENT_SHADER, scene_fragment_source));
  GL(BindAttribLocation)(program, 0, "position");
  SCENE_LINK(program);
  GLint linked = 0;
  GL(GetProgramiv)(program, GL_LINK_STATUS, &linked);
  require(linked, "the program did not link");
  GL(UseProgram)(program);
  scene_centre = GL(GetUniformLocation)(program, "centre");
  scene_base = GL(GetUniformLocation)(program, "base");
#if SCENE_HAS_VAO
  GLuint array;
  GL(GenVertexArrays)(1, &array);
  GL(BindVertexArray)(array);
#endif
  GLuint buffers[2];
  GL(GenBuffers)(2, buffers);
  GL(BindBuffer)(GL_ARRAY_BUFFER, buffers[0]);
  GL(BufferData)(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
  GL(BindBuffer)(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  GL(BufferData)(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  GL(VertexAttribPointer)(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
  GL(EnableVertexAttribArray)(0);
  GL(Viewport)(0, 0, picture_size, picture_size);
  GL(ClearColor)(0.1f, 0.2f, 0.3f, 1);
  GL(Enable)(GL_DEPTH_TEST);
  GL(Enable)(GL_CULL_FACE);
}

static inline void scene_draw(void) {
  GL(Clear)(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  GL(Uniform3f)(scene_centre, -0.5f, 0.3f, -3.6f);
  GL(Uniform3f)(scene_base, 0.9f, 0.6f, 0.2f);
  GL(DrawElements)(GL_TRIANGLES, sphere_indices, GL_UNSIGNED_SHORT, NULL);
  GL(Uniform3f)(scene_centre, 0.9f, -1.4f, -3.2f);
  GL(Uniform3f)(scene_base, 0.4f, 0.8f, 0.5f);
  GL(DrawArrays)(GL_TRIANGLE_FAN, 3 * (sphere_sectors + 1), sphere_sectors + 1);
}

// Reads the last frame back, before the buffers are swapped.
static inline void scene_read(unsigned char pixels[4 * picture_size * picture_size]) {
  GL(Finish)();
  GL(PixelStorei)(GL_PACK_ALIGNMENT, 1);
  GL(ReadPixels)(0, 0, picture_size, picture_size, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  require(GL(GetError)() == GL_NO_ERROR, "the scene raised a GL error");
}
