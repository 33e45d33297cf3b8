// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The scene of the fixed-function tests: a software context, textures whose colour is a smooth function of the
// coordinate, and a curved grid with every attribute.
#pragma once

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/osmesa.h>
// osmesa.h comes first: it includes the GL headers, which declare prototypes only if asked at their first inclusion.
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace glark::refine::test {

inline constexpr int image_size = 64;

// A compatibility context of OSMesa, current from construction on.
class Context {
 public:
  Context() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_PROFILE,
                              OSMESA_COMPAT_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              2,
                              0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context_ || !OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, image_size, image_size))
      std::abort();
  }
  ~Context() { OSMesaDestroyContext(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  OSMesaContext context_ = nullptr;
  std::vector<GLubyte> pixels_ = std::vector<GLubyte>(4 * image_size * image_size);
};

// A program with only the vertex shader; the fragment stage stays fixed function. Returns 0 and fills `log` if it does
// not link.
inline GLuint link_vertex_shader(const std::string& source, std::string& log) {
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  std::array<char, 4096> buffer{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(buffer.size()), nullptr, buffer.data());
  log = std::string(buffer.data()) + "\n" + source;
  return 0;
}

inline std::vector<GLubyte> ramp_texels(int depth) {
  constexpr int size = 32;
  std::vector<GLubyte> texels;
  for (int z = 0; z < depth; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        for (int value : {40 + 6 * x, 250 - 7 * y, depth > 1 ? 7 * z : 4 * (x + y) / 2, 255 - 2 * x})
          texels.push_back(GLubyte(value));
  return texels;
}

inline std::vector<GLubyte> cube_face_texels(int face) {
  constexpr int size = 32;
  std::vector<GLubyte> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const float s = (2.0f * float(x) + 1.0f) / size - 1.0f;
      const float t = (2.0f * float(y) + 1.0f) / size - 1.0f;
      const float directions[6][3] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
      const float length = std::sqrt(1.0f + s * s + t * t);
      for (float component : directions[face]) texels.push_back(GLubyte(127.5f + 127.0f * component / length));
      texels.push_back(255);
    }
  return texels;
}

// Binds a 2D, a 3D and a cube map texture to the active unit. Mirrored, so that no colour jumps where a coordinate
// wraps.
inline void bind_textures() {
  std::array<GLuint, 3> names{};
  glGenTextures(3, names.data());
  const std::array<GLenum, 3> targets = {GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    glBindTexture(targets[i], names[i]);
    glTexParameteri(targets[i], GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
      glTexParameteri(targets[i], wrap, targets[i] == GL_TEXTURE_CUBE_MAP ? GL_CLAMP_TO_EDGE : GL_MIRRORED_REPEAT);
  }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, ramp_texels(1).data());
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 32, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, ramp_texels(32).data());
  for (int face = 0; face < 6; ++face)
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 cube_face_texels(face).data());
}

inline void set_up_scene() {
  glViewport(0, 0, image_size, image_size);
  glEnable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.5, 0.5, -0.5, 0.5, 1.0, 10.0);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0.1f, 0.0f, -3.0f);
  glRotatef(-35.0f, 1.0f, 0.3f, 0.1f);
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  for (int unit = 2; unit >= 0; --unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    bind_textures();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, unit == 1 ? GL_ADD : GL_MODULATE);
  }
}

inline float height(float x, float y) { return 0.35f * std::sin(2.2f * x) * std::cos(1.7f * y); }

inline void grid_vertex(float x, float y) {
  const float dx = 0.77f * std::cos(2.2f * x) * std::cos(1.7f * y);
  const float dy = -0.595f * std::sin(2.2f * x) * std::sin(1.7f * y);
  const float length = std::sqrt(dx * dx + dy * dy + 1.0f);
  glNormal3f(-dx / length, -dy / length, 1.0f / length);
  glColor4f(0.5f + 0.5f * x, 0.5f + 0.4f * y, 0.6f - 0.3f * x * y, 0.75f + 0.2f * y);
  glSecondaryColor3f(0.3f - 0.2f * x, 0.1f, 0.2f + 0.2f * y);
  glFogCoordf(2.0f + x + 0.5f * y);
  for (int unit = 0; unit < 3; ++unit)
    glMultiTexCoord4f(GL_TEXTURE0 + unit, 0.5f + 0.4f * x, 0.5f + 0.45f * y, 0.3f + 0.1f * float(unit),
                      1.0f + 0.2f * x);
  glVertex3f(x, y, height(x, y));
}

// 14 x 14 cells; the right half is wound the other way, so that both faces show.
inline void draw_grid(GLenum primitive) {
  constexpr int cells = 14;
  const auto at = [](int i) { return 2.0f * float(i) / cells - 1.0f; };
  glBegin(primitive);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      std::array<std::array<int, 2>, 6> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}};
      if (i >= cells / 2) std::reverse(corners.begin(), corners.end());
      for (const auto& corner : corners) grid_vertex(at(i + corner[0]), at(j + corner[1]));
    }
  glEnd();
}

}  // namespace glark::refine::test
