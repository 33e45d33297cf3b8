// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Procedural displacement: a coarse ground of 128 triangles, and a refinement shader that computes the height of every
// point. The height is the sum of six octaves of noise. There is no texture and no fine mesh. Vertices near the eye
// have greater depth tags. The lower half of the picture also shows the refined triangles as lines.
//
//   noise_terrain OUT.png
#include <GL/gl.h>
#include <GL/osmesa.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <GL/glark.h>

namespace {

constexpr int width = 800;
constexpr int height = 400;  // the height of each half
constexpr int cells = 8;     // number of cells along a side of the ground
constexpr unsigned max_level = 6;

// Value noise with its derivative, so that the normal is exact. The absolute value makes ridges.
constexpr const char* mountains = R"glsl(
float random(vec2 cell) {
  vec3 p = fract(vec3(cell.xyx) * 0.1031);
  p += dot(p, p.yzx + 33.33);
  return fract((p.x + p.y) * p.z);
}

vec3 noise(vec2 at) {  // height, and slopes along x and y
  vec2 cell = floor(at);
  vec2 f = at - cell;
  vec2 blend = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec2 slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float a = random(cell);
  float b = random(cell + vec2(1.0, 0.0)) - a;
  float c = random(cell + vec2(0.0, 1.0)) - a;
  float d = random(cell + vec2(1.0, 1.0)) - a - b - c;
  return vec3(a + b * blend.x + c * blend.y + d * blend.x * blend.y, slope * (vec2(b, c) + d * blend.yx));
}

void refine() {
  vec3 sum = vec3(0.0);
  float amplitude = 1.1;
  float frequency = 0.7;
  for (int octave = 0; octave < 6; ++octave) {
    vec3 wave = noise(gl_Vertex.xy * frequency + 7.0 * float(octave)) - vec3(0.5, 0.0, 0.0);
    float ridge = wave.x < 0.0 ? -1.0 : 1.0;
    sum += amplitude * vec3(0.25 - ridge * wave.x, -ridge * frequency * wave.yz);
    amplitude *= 0.45;
    frequency *= 2.1;
  }
  gl_Vertex.z += sum.x;
  gl_Normal = normalize(vec3(-sum.yz, 1.0));
  gl_Color.rgb = mix(vec3(0.35, 0.5, 0.25), vec3(0.95), smoothstep(0.15, 0.75, sum.x + 0.3 * gl_Normal.z));
}
)glsl";

// Sets the refinement shader of the fixed function, which is program 0. Prints a message and returns false if the
// shader does not build.
bool use(const char* source) {
  glRefinementShaderSourceARK(0, 1, &source, nullptr);
  GLint built = GL_FALSE;
  glGetRefinementivARK(0, GL_REFINEMENT_STATUS_ARK, &built);
  if (built == GL_TRUE) {
    return true;
  }
  std::string log(4096, '\0');
  glGetRefinementInfoLogARK(0, static_cast<GLsizei>(log.size()), nullptr, log.data());
  std::fprintf(stderr, "noise_terrain: %s\n", log.c_str());
  return false;
}

void vertex(int i, int j) {
  const float x = static_cast<float>(i) - cells / 2.0F;
  const float y = static_cast<float>(j);
  // At twice the distance, triangles have half as many segments. So segments have about one size on the screen.
  const double distance = std::hypot(x, y + 1.5);
  glDepthTag1i(static_cast<GLuint>(std::clamp(max_level + 1 - std::log2(distance), 1.0, double{max_level})));
  glVertex2f(x, y);
}

void draw_ground() {
  for (int j = 0; j < cells; ++j) {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= cells; ++i) {
      vertex(i, j + 1);
      vertex(i, j);
    }
    glEnd();
  }
}

void look() {
  constexpr float sun[4] = {-0.8F, 0.25F, 0.6F, 0};
  constexpr float sky[4] = {0.25F, 0.27F, 0.32F, 1};
  glMatrixMode(GL_PROJECTION);
  glFrustum(-1, 1, -0.5, 0.5, 1, 30);
  glMatrixMode(GL_MODELVIEW);
  glRotatef(-68, 1, 0, 0);
  glTranslatef(0, 0.7F, -2);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, sun);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, sky);
  glEnable(GL_COLOR_MATERIAL);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s OUT.png\n", argv[0]);
    return 2;
  }
  std::vector<unsigned char> pixels(4UL * width * 2 * height);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, 2 * height) == GL_FALSE) {
    return 1;
  }
  glEnable(GL_DEPTH_TEST);
  glClearColor(0.75F, 0.85F, 0.95F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  look();
  glARKinit(max_level);
  if (!use(mountains)) {
    return 1;
  }
  glEnable(GL_ARK);
  glViewport(0, height, width, height);
  draw_ground();
  glViewport(0, 0, width, height);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  draw_ground();
  glFinish();
  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], width, 2 * height, 4, pixels.data(), 4 * width);
  OSMesaDestroyContext(context);
  return written != 0 ? 0 : 1;
}
