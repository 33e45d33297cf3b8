// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depth tags that change with every frame: rings of waves run outwards over a pond of 288 triangles. The refinement
// shader moves the refined vertices by a function of time. In the same frame, the CPU tags each coarse vertex by the
// bend of this function near it. So fine triangles travel with the waves.
// The picture has four frames, with the refined triangles as lines over the water. A query counts the triangles of each
// frame. The program compares the count with section 11.R.5 of the extension.
//
//   waves OUT.png
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <GL/glark.h>

namespace {

constexpr int size = 400;
constexpr int frames = 4;
constexpr int cells = 12;
constexpr unsigned max_level = 4;

constexpr const char* vertex_shader = R"glsl(#version 120
attribute vec2 place;
varying float light;
float height = 0.0;
vec2 slope = vec2(0.0);
void main() {
  vec3 normal = normalize(vec3(-slope, 1.0));
  light = 0.35 + 0.65 * max(0.0, dot(normal, normalize(vec3(-0.6, 0.4, 0.7))));
  gl_Position = gl_ModelViewProjectionMatrix * vec4(place, height, 1.0);
})glsl";

constexpr const char* fragment_shader = R"glsl(#version 120
varying float light;
uniform vec3 color;
void main() { gl_FragColor = vec4(color * light, 1.0); }
)glsl";

// A packet of waves around the ring of radius `time`. refine() may also set globals of the vertex shader.
constexpr const char* refinement_shader = R"glsl(
uniform float time;
void refine() {
  float r = length(place);
  float packet = 0.16 * exp(-9.0 * (r - time) * (r - time));
  height = packet * cos(14.0 * (r - time));
  float rise = -packet * (14.0 * sin(14.0 * (r - time)) + 18.0 * (r - time) * cos(14.0 * (r - time)));
  slope = rise * place / max(r, 1e-4);
}
)glsl";

GLuint make_program() {
  const GLuint program = glCreateProgram();
  for (const auto& [stage, source] :
       {std::pair{GL_VERTEX_SHADER, vertex_shader}, std::pair{GL_FRAGMENT_SHADER, fragment_shader}}) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glBindAttribLocation(program, 0, "place");
  glLinkProgram(program);
  glRefinementShaderSourceARK(program, 1, &refinement_shader, nullptr);
  return program;
}

struct Pond {
  std::vector<std::array<float, 2>> places;
  std::vector<unsigned char> tags;
  std::vector<unsigned short> indices;
};

Pond make_pond() {
  Pond pond;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i)
      pond.places.push_back({4.0F * static_cast<float>(i) / cells - 2, 4.0F * static_cast<float>(j) / cells - 2});
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto corner = static_cast<unsigned short>(j * (cells + 1) + i);
      const auto above = static_cast<unsigned short>(corner + cells + 1);
      for (const int index : {int{corner}, corner + 1, above + 1, int{corner}, above + 1, int{above}}) {
        pond.indices.push_back(static_cast<unsigned short>(index));
      }
    }
  }
  return pond;
}

// The bend of the waves fades with the packet. At a quarter of the bend, segments may be twice as long.
void tag(Pond& pond, float time) {
  pond.tags.clear();
  for (const auto& [x, y] : pond.places) {
    const float off = std::hypot(x, y) - time;
    const float depth = static_cast<float>(max_level) + std::log2(std::exp(-9.0F * off * off) + 1e-6F) / 2;
    pond.tags.push_back(static_cast<unsigned char>(std::max(0.0F, depth)));
  }
}

// Section 11.R.5, where m is the least of the three edge depths.
unsigned expected_triangles(const Pond& pond) {
  unsigned sum = 0;
  for (std::size_t i = 0; i < pond.indices.size(); i += 3) {
    std::array<unsigned, 3> segments{};
    for (std::size_t k = 0; k < 3; ++k) {
      segments.at(k) =
          1U << ((unsigned{pond.tags[pond.indices[i + k]]} + pond.tags[pond.indices[i + (k + 1) % 3]]) / 2);
    }
    const unsigned least = *std::min_element(segments.begin(), segments.end());
    sum += (least - 1) * (least - 2) + segments[0] + segments[1] + segments[2] - 2;
  }
  return sum;
}

unsigned draw(const Pond& pond, GLuint query) {
  unsigned triangles = 0;
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, pond.places.data());
  glEnableVertexAttribArray(0);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, pond.tags.data());
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  glBeginQuery(GL_PRIMITIVES_GENERATED, query);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(pond.indices.size()), GL_UNSIGNED_SHORT, pond.indices.data());
  glEndQuery(GL_PRIMITIVES_GENERATED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
  return triangles;
}

void look() {
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 20);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0.2F, -4.6F);
  glRotatef(-50, 1, 0, 0);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

bool draw_frames(GLuint program) {
  Pond pond = make_pond();
  GLuint query = 0;
  glGenQueries(1, &query);
  glUseProgram(program);
  GLint built = GL_FALSE;
  glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  bool as_expected = built == GL_TRUE;
  for (int frame = 0; frame < frames; ++frame) {
    const float time = 0.3F + 0.5F * static_cast<float>(frame);
    glViewport(frame * size, 0, size, size);
    glUniform1f(glGetUniformLocation(program, "time"), time);
    tag(pond, time);
    glUniform3f(glGetUniformLocation(program, "color"), 0.35F, 0.65F, 0.85F);
    const unsigned triangles = draw(pond, query);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glUniform3f(glGetUniformLocation(program, "color"), 0.2F, 0.45F, 0.65F);
    draw(pond, query);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    std::printf("time %.1f: %u triangles\n", static_cast<double>(time), triangles);
    as_expected = as_expected && triangles == expected_triangles(pond);
  }
  return as_expected;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s OUT.png\n", argv[0]);
    return 2;
  }
  std::vector<unsigned char> pixels(4UL * frames * size * size);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, frames * size, size) == GL_FALSE) {
    return 1;
  }
  look();
  glARKinit(max_level);
  glEnable(GL_ARK);
  const bool as_expected = draw_frames(make_program());
  glFinish();
  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], frames * size, size, 4, pixels.data(), 4 * frames * size);
  OSMesaDestroyContext(context);
  return written != 0 && as_expected ? 0 : 1;
}
