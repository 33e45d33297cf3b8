// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures GL calls that pass through, in nanoseconds: the best of many batches. Prints lines of "name ns". The program
// is built with libGLARK (glark-bench-calls) and without it (glark-bench-plain). glark-bench runs both in turn.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES 1
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/osmesa.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace {

template <typename Call>
void report(const char* name, int calls, int batches, Call&& call) {
  using Clock = std::chrono::steady_clock;
  double least = 1e18;
  for (int batch = 0; batch < batches; ++batch) {
    const auto begin = Clock::now();
    for (int i = 0; i < calls; ++i) call();
    least = std::min(least, std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / calls);
    glFinish();
  }
  std::printf("%s %.3f\n", name, least);
}

// The program has one uniform for glUniform4f.
GLint use_program() {
  const char* source = "uniform vec4 offset; void main() { gl_Position = gl_Vertex + offset; }";
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  glUseProgram(program);
  return glGetUniformLocation(program, "offset");
}

}  // namespace

int main() {
  constexpr int size = 64;
  std::vector<unsigned> pixels(static_cast<std::size_t>(size) * size);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, size, size) == GL_FALSE) return 1;
  const float outside[] = {5, 5, 0, 6, 5, 0, 5, 6, 0};  // outside the picture
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof(outside), outside, GL_STATIC_DRAW);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  report("glColor4f", 20000, 60, [] { glColor4f(0.1F, 0.2F, 0.3F, 1.0F); });
  report("glDrawArrays", 500, 60, [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
  report("glVertexPointer", 20000, 60, [] { glVertexPointer(3, GL_FLOAT, 0, nullptr); });
  report("glBindBuffer", 20000, 60, [buffer] { glBindBuffer(GL_ARRAY_BUFFER, buffer); });
  report("glBufferSubData", 2000, 60, [&] { glBufferSubData(GL_ARRAY_BUFFER, 0, 4, outside); });
  const GLint location = use_program();
  report("glUniform4f", 5000, 60, [location] { glUniform4f(location, 0.1F, 0.2F, 0.3F, 0.0F); });
  OSMesaDestroyContext(context);
  return 0;
}
