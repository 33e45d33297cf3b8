// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A subdivision surface in real time: a toy of 60 triangles bends. The picture shows the coarse toy and the surface
// that it controls. In every frame, the library glark-qas computes one step of Loop's scheme on the CPU. The refinement
// shader fits two quadratic patches to each triangle, one for positions and one for normals. Vertices near the eye have
// greater depth tags.
//
//   qas_surface OUT.png [SECONDS]      the moment of the animation
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <glark/qas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <GL/glark.h>

namespace {

constexpr int width = 1024, height = 512;
constexpr unsigned deepest = 5;

struct ControlMesh {
  std::vector<float> positions;  // x y z
  std::vector<std::uint32_t> triangles;
};

// A cube with an arm on every face.
ControlMesh make_jack() {
  ControlMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) mesh.positions.push_back((corner >> axis & 1) != 0 ? 0.45F : -0.45F);
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, c, d});
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool positive : {false, true}) {
      const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = positive ? 1 << axis : 0;
      int corners[4] = {base, base + u, base + u + v,
                        base + v};  // the corners of the face, counter-clockwise seen from outside
      if (!positive) std::swap(corners[1], corners[3]);
      const auto tip = static_cast<std::uint32_t>(mesh.positions.size() / 3);
      for (const int corner : corners) {
        for (int k = 0; k < 3; ++k) {
          const float at = mesh.positions[3 * static_cast<std::size_t>(corner) + static_cast<std::size_t>(k)];
          mesh.positions.push_back(k == axis ? (positive ? 1.9F : -1.9F) : 1.2F * at);
        }
      }
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t next = (i + 1) % 4;
        quad(static_cast<std::uint32_t>(corners[i]), static_cast<std::uint32_t>(corners[next]), tip + next, tip + i);
      }
      quad(tip, tip + 1, tip + 2, tip + 3);
    }
  }
  return mesh;
}

// Bends the toy: its arms turn about the z axis. The angle grows with the distance from the axis.
std::vector<float> bent(const std::vector<float>& rest, float seconds) {
  std::vector<float> positions = rest;
  for (std::size_t i = 0; i < rest.size(); i += 3) {
    const float x = rest[i], y = rest[i + 1];
    const float angle = 0.6F * std::sin(2 * seconds) * std::hypot(x, y);
    positions[i] = x * std::cos(angle) - y * std::sin(angle);
    positions[i + 1] = x * std::sin(angle) + y * std::cos(angle);
  }
  return positions;
}

// One input has a point and the middle of the edge to the next corner. The refinement shader reads both; the vertex
// stage reads the point.
constexpr const char* vertex_shader = R"glsl(#version 130
in mat2x3 point;
in mat2x3 normal;
out vec3 passed_normal;
void main() {
  passed_normal = gl_NormalMatrix * normal[0];
  gl_Position = gl_ModelViewProjectionMatrix * vec4(point[0], 1.0);
}
)glsl";

constexpr const char* fragment_shader = R"glsl(#version 130
in vec3 passed_normal;
void main() {
  vec3 n = normalize(passed_normal), light = normalize(vec3(-0.5, 0.6, 0.8));
  float shine = pow(max(dot(n, normalize(light + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
  gl_FragColor = vec4(vec3(0.9, 0.45, 0.15) * (0.25 + 0.75 * max(dot(n, light), 0.0)) + 0.5 * shine, 1.0);
}
)glsl";

enum : GLuint { point = 0, normal = 2, tag = 4 };  // a matrix takes two locations

// Returns the program with the refinement shader of QAS. Prints a message and returns 0 if it does not build.
GLuint make_program() {
  const GLuint program = glCreateProgram();
  const GLenum stages[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
  const char* const sources[] = {vertex_shader, fragment_shader};
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = glCreateShader(stages[i]);
    glShaderSource(shader, 1, &sources[i], nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glBindAttribLocation(program, point, "point");
  glBindAttribLocation(program, normal, "normal");
  glLinkProgram(program);
  const std::string refinement = glark::qas::refinement_shader({"point[0]", "point[1]", "normal[0]", "normal[1]"});
  const char* const text = refinement.c_str();
  glRefinementShaderSourceARK(program, 1, &text, nullptr);
  GLint built = GL_FALSE;
  glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  if (built == GL_TRUE) return program;
  char log[2048];
  glGetRefinementInfoLogARK(program, sizeof(log), nullptr, log);
  std::fprintf(stderr, "qas_surface: %s\n", log);
  return 0;
}

// Computes depth tags from the distances of vertices. So triangles agree on their common edges.
std::vector<GLubyte> depth_tags(const std::vector<float>& positions) {
  std::vector<GLubyte> tags;
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const float towards_eye = (positions[i] + positions[i + 1] + positions[i + 2]) / 3;  // about -1 to 1
    tags.push_back(static_cast<GLubyte>(std::clamp(4 + towards_eye, 3.0F, float(deepest))));
  }
  return tags;
}

void upload(const glark::qas::Surface& surface, const std::vector<GLubyte>& tags, GLuint corner_buffer,
            GLuint tag_buffer) {
  using glark::qas::Corner;
  glBindBuffer(GL_ARRAY_BUFFER, corner_buffer);
  const auto bytes = static_cast<GLsizeiptr>(surface.corner_count() * sizeof(Corner));
  glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
  surface.write_corners({static_cast<Corner*>(glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY)), surface.corner_count()});
  glUnmapBuffer(GL_ARRAY_BUFFER);
  const auto column = [](GLuint location, std::size_t offset) {
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), reinterpret_cast<const void*>(offset));
    glEnableVertexAttribArray(location);
  };
  column(point, offsetof(Corner, position));
  column(point + 1, offsetof(Corner, edge_position));
  column(normal, offsetof(Corner, normal));
  column(normal + 1, offsetof(Corner, edge_normal));
  std::vector<GLubyte> corner_tags;
  for (const auto& [a, b] : surface.corner_vertices())
    corner_tags.push_back(static_cast<GLubyte>((tags[a] + tags[b]) / 2));
  glBindBuffer(GL_ARRAY_BUFFER, tag_buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corner_tags.size()), corner_tags.data(), GL_STREAM_DRAW);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

void look(int left) {
  glViewport(left, 0, width / 2, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.42, 0.42, -0.42, 0.42, 1, 20);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0, 0, -5.6F);
  glRotatef(35, 1, 0, 0);
  glRotatef(-45, 0, 1, 0);
}

// Draws the coarse mesh flat, with its edges.
void draw_control_mesh(const std::vector<float>& positions, const std::vector<std::uint32_t>& triangles) {
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  for (const bool edges : {false, true}) {
    glPolygonMode(GL_FRONT_AND_BACK, edges ? GL_LINE : GL_FILL);
    glColor3f(edges ? 0.1F : 0.95F, edges ? 0.1F : 0.85F, edges ? 0.1F : 0.7F);
    glBegin(GL_TRIANGLES);
    for (const std::uint32_t vertex : triangles) glVertex3fv(&positions[3 * std::size_t{vertex}]);
    glEnd();
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: %s OUT.png [SECONDS]\n", argv[0]);
    return 2;
  }
  std::vector<unsigned char> pixels(4UL * width * height);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, width, height) == GL_FALSE) return 1;
  glEnable(GL_DEPTH_TEST);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glARKinit(deepest);
  glARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, tag);

  // Runs once: the topology, the program, the buffers.
  const ControlMesh jack = make_jack();
  glark::qas::Surface surface({jack.positions.size() / 3, jack.triangles});
  const GLuint program = make_program();
  if (program == 0) return 1;
  GLuint buffers[2];
  glGenBuffers(2, buffers);

  // Runs in every frame: the mesh moves, its limit points follow, and the patches are refined while they are drawn.
  const float seconds = argc == 3 ? std::strtof(argv[2], nullptr) : 0.5F;
  const std::vector<float> positions = bent(jack.positions, seconds);
  surface.update(positions);
  look(0);
  draw_control_mesh(positions, jack.triangles);
  look(width / 2);
  upload(surface, depth_tags(positions), buffers[0], buffers[1]);
  glUseProgram(program);
  glEnable(GL_ARK);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(surface.corner_count()));
  glFinish();

  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], width, height, 4, pixels.data(), 4 * width);
  OSMesaDestroyContext(context);
  return written != 0 ? 0 : 1;
}
