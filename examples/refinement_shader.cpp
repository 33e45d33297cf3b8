// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Your own refinement shader: two triangles become a rippling sheet. refine() runs once for each refined vertex, before
// the fixed function. It gets the interpolated inputs of the vertex and may change them; here it changes position and
// normal.
//
//   refinement_shader OUT.png
#include <GL/gl.h>
#include <GL/osmesa.h>

#include <cstdio>
#include <string>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <GL/glark.h>

namespace {

constexpr int size = 512;
constexpr unsigned level = 7;

// Makes rings of height h(r) around the middle. The normal is the normal of the graph of h.
constexpr const char* waves = R"glsl(
void refine() {
  float r = length(gl_Vertex.xy);
  float h = 0.12 * cos(18.0 * r) * exp(-1.5 * r);
  float slope = -0.12 * exp(-1.5 * r) * (18.0 * sin(18.0 * r) + 1.5 * cos(18.0 * r));
  gl_Vertex.z += h;
  gl_Normal = normalize(vec3(-slope * gl_Vertex.xy / max(r, 1e-4), 1.0));
}
)glsl";

// Sets the refinement shader of the fixed function, which is program 0. Prints a message and returns false if the
// shader does not build.
bool use_waves() {
  glRefinementShaderSourceARK(0, 1, &waves, nullptr);
  GLint built = GL_FALSE;
  glGetRefinementivARK(0, GL_REFINEMENT_STATUS_ARK, &built);
  if (built == GL_TRUE) {
    return true;
  }
  GLint length = 0;
  glGetRefinementivARK(0, GL_REFINEMENT_LOG_LENGTH_ARK, &length);
  std::string log(static_cast<std::string::size_type>(length), '\0');
  glGetRefinementInfoLogARK(0, length, nullptr, log.data());
  std::fprintf(stderr, "refinement_shader: %s\n", log.c_str());
  return false;
}

void look_from_above_at_the_side() {
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0.1F, -2.6F);
  glRotatef(-55, 1, 0, 0);
  glRotatef(30, 0, 0, 1);
}

void light() {
  constexpr float direction[4] = {-0.6F, 0.3F, 0.8F, 0};
  constexpr float water[4] = {0.15F, 0.5F, 0.7F, 1};
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_NORMALIZE);
  glLightfv(GL_LIGHT0, GL_POSITION, direction);
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, water);
}

void draw_sheet() {
  glDepthTag1i(level);
  glBegin(GL_TRIANGLE_STRIP);
  glNormal3f(0, 0, 1);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(-1, 1);
  glVertex2f(1, 1);
  glEnd();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s OUT.png\n", argv[0]);
    return 2;
  }
  std::vector<unsigned char> pixels(4UL * size * size);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, size, size) == GL_FALSE) {
    return 1;
  }
  glEnable(GL_DEPTH_TEST);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  look_from_above_at_the_side();
  light();
  glARKinit(level);
  if (!use_waves()) {
    return 1;
  }
  glEnable(GL_ARK);
  draw_sheet();
  glFinish();
  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], size, size, 4, pixels.data(), 4 * size);
  OSMesaDestroyContext(context);
  return written != 0 ? 0 : 1;
}
