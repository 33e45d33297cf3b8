// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-gallery: figures 9.4 and 9.5 of Boubekeur 2007. It draws each of the seven control meshes of tests/qas/meshes.h
// four times: coarse, as curved PN triangles, as QAS, and as Loop's limit surface itself. PN and QAS are refined inside
// OpenGL. It draws two of them also with Phong tessellation: coarse, with Phong tessellation, as curved PN triangles,
// and as Loop's limit surface.
//
//   glark-gallery OUT_DIRECTORY          writes qas_MESH.png and phong_MESH.png
#define GL_GLEXT_PROTOTYPES 1
#include <GL/osmesa.h>
#include <glark/qas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include "glark/clients/common/vector.h"
#include "glark/clients/common/vertex_normals.h"
#include "tests/bench/gl.h"
#include "tests/qas/meshes.h"

namespace {

using glark::qas::Corner;
using glark::qas::test::ControlMesh;

constexpr int side = 360;  // side of one view, in pixels
constexpr int views = 4;
constexpr unsigned level = 5;
enum : GLuint { point = 0, normal = 2 };  // a matrix takes two locations

constexpr const char* vertex_shader = R"glsl(#version 130
in mat2x3 point;
in mat2x3 normal;
out vec3 passed_normal;
out vec3 place;
void main() {
  passed_normal = gl_NormalMatrix * normal[0];
  place = (gl_ModelViewMatrix * vec4(point[0], 1.0)).xyz;
  gl_Position = gl_ModelViewProjectionMatrix * vec4(point[0], 1.0);
}
)glsl";

constexpr const char* pn_vertex_shader = R"glsl(#version 130
in vec3 point;
in vec3 normal;
out vec3 passed_normal;
out vec3 place;
void main() {
  passed_normal = gl_NormalMatrix * normal;
  place = (gl_ModelViewMatrix * vec4(point, 1.0)).xyz;
  gl_Position = gl_ModelViewProjectionMatrix * vec4(point, 1.0);
}
)glsl";

// Reflected stripes show errors of normals.
constexpr const char* fragment_shader = R"glsl(#version 130
in vec3 passed_normal;
in vec3 place;
uniform bool flat_shaded;
void main() {
  vec3 n = normalize(flat_shaded ? cross(dFdx(place), dFdy(place)) : passed_normal);
  if (n.z < 0.0) n = -n;
  vec3 light = normalize(vec3(-0.5, 0.6, 0.8));
  vec3 mirrored = reflect(normalize(place), n);
  float stripe = flat_shaded ? 0.0 : smoothstep(-0.12, 0.12, sin(14.0 * mirrored.y)) * 0.22;
  vec3 color = vec3(0.35, 0.6, 0.85) * (0.3 + 0.7 * max(dot(n, light), 0.0)) + stripe;
  gl_FragColor = vec4(color, 1.0);
}
)glsl";

GLuint link(const char* vertex) {
  const GLuint program = glCreateProgram();
  for (const auto& [stage, source] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment_shader}}) {
    const GLuint shader = glCreateShader(static_cast<GLenum>(stage));
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glBindAttribLocation(program, point, "point");
  glBindAttribLocation(program, normal, "normal");
  glLinkProgram(program);
  return program;
}

// Returns the sum of the triangles' normals around each vertex, weighted by area.
std::vector<float> vertex_normals(const ControlMesh& mesh) {
  std::vector<float> normals(mesh.positions.size());
  const std::span<const float> positions = mesh.positions;
  glark::common::add_triangle_normals(
      mesh.triangles, [&](std::uint32_t vertex) { return glark::common::vector_at(positions, vertex); },
      [&](std::uint32_t vertex, glark::common::Vector3f normal) {
        for (std::size_t k = 0; k < 3; ++k) normals[3 * std::size_t{vertex} + k] += normal[k];
      });
  return normals;
}

// Positions and normals of the corners of all triangles.
using Corners = std::vector<std::array<float, 6>>;

Corners coarse_corners(const ControlMesh& mesh) {
  const std::vector<float> normals = vertex_normals(mesh);
  Corners corners;
  for (const std::uint32_t vertex : mesh.triangles) {
    const std::size_t at = 3 * std::size_t{vertex};
    corners.push_back({mesh.positions[at], mesh.positions[at + 1], mesh.positions[at + 2], normals[at], normals[at + 1],
                       normals[at + 2]});
  }
  return corners;
}

Corners limit_corners(const ControlMesh& mesh) {
  glark::qas::LoopSurface surface(mesh.view());
  surface.update(mesh.positions);
  constexpr std::size_t n = std::size_t{1} << level;
  const std::size_t in_triangle = (n + 1) * (n + 2) / 2;
  std::vector<glark::qas::Sample> samples(mesh.triangles.size() / 3 * in_triangle);
  surface.refine(level, samples);
  Corners corners;
  const auto add = [&](std::size_t sample) {
    const auto& [p, q] = samples[sample];
    corners.push_back({p[0], p[1], p[2], q[0], q[1], q[2]});
  };
  for (std::size_t first = 0; first < samples.size(); first += in_triangle) {
    std::size_t row = first;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = row + n + 1 - i;
      for (std::size_t j = 0; j < n - i; ++j) {
        for (const std::size_t sample : {row + j, next + j, row + j + 1}) add(sample);
        if (j + 1 < n - i) {
          for (const std::size_t sample : {next + j, next + j + 1, row + j + 1}) add(sample);
        }
      }
      row = next;
    }
  }
  return corners;
}

void look(const ControlMesh& mesh, int view) {
  std::array<float, 3> low{1e9F, 1e9F, 1e9F};
  std::array<float, 3> high{-1e9F, -1e9F, -1e9F};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    low.at(i % 3) = std::min(low.at(i % 3), mesh.positions[i]);
    high.at(i % 3) = std::max(high.at(i % 3), mesh.positions[i]);
  }
  glViewport(view * side, 0, side, side);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.11, 0.11, -0.11, 0.11, 1, 10);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0, 0, -4);
  glRotatef(25, 1, 0, 0);
  glRotatef(-35, 0, 1, 0);
  const auto size = static_cast<float>(1.0 / mesh.diagonal());
  glScalef(size, size, size);
  glTranslatef(-0.5F * (low[0] + high[0]), -0.5F * (low[1] + high[1]), -0.5F * (low[2] + high[2]));
}

template <typename Vertex>
void draw(const std::vector<Vertex>& vertices, std::initializer_list<GLuint> locations) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
               GL_STATIC_DRAW);
  std::size_t offset = 0;
  for (const GLuint location : locations) {
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
    glEnableVertexAttribArray(location);
    offset += 3 * sizeof(float);
  }
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  for (const GLuint location : locations) glDisableVertexAttribArray(location);
  glDeleteBuffers(1, &buffer);
}

struct Programs {
  GLuint plain = link(pn_vertex_shader);
  GLuint qas = link(vertex_shader);
};

// Draws the first view and the last.
void draw_coarse_and_limit(const ControlMesh& mesh, const Programs& programs, const Corners& coarse) {
  const GLint flat_shaded = glGetUniformLocation(programs.plain, "flat_shaded");
  glDisable(GL_ARK);
  glUseProgram(programs.plain);
  look(mesh, 0);
  glUniform1i(flat_shaded, 1);
  draw(coarse, {point, normal});
  glUniform1i(flat_shaded, 0);
  look(mesh, 3);
  draw(limit_corners(mesh), {point, normal});
  glEnable(GL_ARK);
}

void draw_refined(const ControlMesh& mesh, const Corners& coarse, int view, GLint refinement) {
  glARKParameteriARK(GL_REFINEMENT_ARK, refinement);
  look(mesh, view);
  draw(coarse, {point, normal});
}

void draw_phong_views(const ControlMesh& mesh, const Programs& programs) {
  const Corners coarse = coarse_corners(mesh);
  draw_coarse_and_limit(mesh, programs, coarse);
  draw_refined(mesh, coarse, 1, GL_PHONG_ARK);
  draw_refined(mesh, coarse, 2, GL_CURVED_PN_ARK);
}

void draw_qas_views(const ControlMesh& mesh, const Programs& programs) {
  const Corners coarse = coarse_corners(mesh);
  draw_coarse_and_limit(mesh, programs, coarse);
  draw_refined(mesh, coarse, 1, GL_CURVED_PN_ARK);
  glark::qas::Surface surface(mesh.view());
  surface.update(mesh.positions);
  std::vector<Corner> corners(surface.corner_count());
  surface.write_corners(corners);
  glUseProgram(programs.qas);
  look(mesh, 2);
  draw(corners, {point, point + 1, normal, normal + 1});
}

bool write_picture(const std::filesystem::path& file, const std::vector<unsigned char>& pixels) {
  glFinish();
  if (stbi_write_png(file.c_str(), views * side, side, 4, pixels.data(), 4 * views * side) == 0) {
    std::fprintf(stderr, "glark-gallery: %s cannot be written\n", file.c_str());
    return false;
  }
  std::printf("%s\n", file.c_str());
  return true;
}

// Writes all pictures and returns the exit status.
int write_gallery(const std::filesystem::path& directory, std::vector<unsigned char>& pixels) {
  glEnable(GL_DEPTH_TEST);
  glClearColor(1, 1, 1, 1);
  glARKinit(level);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
  const Programs programs;
  const std::string refinement = glark::qas::refinement_shader();
  const char* const text = refinement.c_str();
  glRefinementShaderSourceARK(programs.qas, 1, &text, nullptr);
  stbi_flip_vertically_on_write(1);
  for (const ControlMesh& mesh : glark::qas::test::seven_meshes()) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_qas_views(mesh, programs);
    if (!write_picture(directory / ("qas_" + mesh.name + ".png"), pixels)) return 1;
    if (mesh.name != "knot" && mesh.name != "goblet") continue;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_phong_views(mesh, programs);
    if (!write_picture(directory / ("phong_" + mesh.name + ".png"), pixels)) return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: glark-gallery OUT_DIRECTORY\n");
    return 2;
  }
  std::vector<unsigned char> pixels(4UL * views * side * side);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, views * side, side) == GL_FALSE) return 1;
  const int status = write_gallery(argv[1], pixels);
  OSMesaDestroyContext(context);
  return status;
}
