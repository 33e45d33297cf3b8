// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A coarse mesh gives the topology of a surface, a refinement shader its shape. A slab of 136 triangles with four holes
// becomes a smooth body: each refined vertex moves onto the zero of a function. Then the body twists.
// From the left, the picture shows the slab, the body, the twisted body, and its refined triangles, which are finer
// around the holes. Transform feedback reads the drawn triangles back. They form a closed surface, and Euler's formula
// finds the four holes.
//
//   genus_4 OUT.png
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <GL/glark.h>

namespace {

constexpr int size = 400;
constexpr int columns = 4;
constexpr int cells = 5;  // number of cells along a side of the slab; cells with two odd numbers are holes
constexpr unsigned max_level = 4;

constexpr const char* vertex_shader = R"glsl(#version 120
attribute vec3 position;
attribute vec3 normal;
varying vec3 refined;
varying vec3 shade_normal;
void main() {
  refined = position;
  shade_normal = gl_NormalMatrix * normal;
  gl_Position = gl_ModelViewProjectionMatrix * vec4(position, 1.0);
})glsl";

constexpr const char* fragment_shader = R"glsl(#version 120
varying vec3 shade_normal;
uniform vec3 color;
void main() {
  float light = abs(dot(normalize(shade_normal), normalize(vec3(-0.4, 0.5, 0.9))));
  gl_FragColor = vec4(color * (0.3 + 0.7 * light), 1.0);
})glsl";

// The body is the space within w of the middle plane and outside the holes. Each vertex moves along the gradient of
// this function.
constexpr const char* refinement_shader = R"glsl(
uniform float twist;

float body(vec3 p) {
  const float w = 0.28;
  vec2 square = p.xy * p.xy;
  float inside = 2.1 - sqrt(length(square));  // a rounded square
  for (int i = 0; i < 4; ++i) {
    vec2 hole = vec2(mod(float(i), 2.0), floor(float(i) / 2.0)) * 1.6 - 0.8;
    float distance = length(p.xy - hole) - 0.42;
    float blend = clamp(0.5 + (inside - distance) / 0.6, 0.0, 1.0);  // a smooth minimum
    inside = mix(inside, distance, blend) - 0.3 * blend * (1.0 - blend);
  }
  return length(vec2(max(w - inside, 0.0), p.z)) - w;
}

vec3 slope(vec3 p) {
  const vec2 h = vec2(0.01, 0.0);
  return vec3(body(p + h.xyy) - body(p - h.xyy), body(p + h.yxy) - body(p - h.yxy), body(p + h.yyx) - body(p - h.yyx)) / 0.02;
}

void refine() {
  for (int step = 0; step < 8; ++step) {
    vec3 s = slope(position);
    position -= body(position) * s / max(dot(s, s), 0.1);
  }
  normal = normalize(slope(position));
  float turn = twist * position.x;
  mat2 rotation = mat2(cos(turn), sin(turn), -sin(turn), cos(turn));
  position.yz = rotation * position.yz;
  normal.yz = rotation * normal.yz;  // approximate: the twist shears as well
}
)glsl";

struct Slab {
  std::vector<float> positions;
  std::vector<unsigned char> tags;
  std::vector<unsigned short> indices;
};

bool is_solid(int i, int j) {
  const bool outside = i < 0 || j < 0 || i >= cells || j >= cells;
  return !outside && !(i % 2 == 1 && j % 2 == 1);
}

// Adds a quadrilateral for every side of a solid cell without a solid neighbour behind it.
Slab make_slab() {
  Slab slab;
  const auto vertex = [](int i, int j, int top) {
    return static_cast<unsigned short>((j * (cells + 1) + i) * 2 + top);
  };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const bool inner = i > 0 && j > 0 && i < cells && j < cells;
      for (const float z : {-0.3F, 0.3F}) {
        slab.positions.insert(slab.positions.end(),
                              {0.8F * static_cast<float>(i) - 2, 0.8F * static_cast<float>(j) - 2, z});
        slab.tags.push_back(inner ? max_level : max_level - 2);
      }
    }
  }
  const auto quad = [&](unsigned short a, unsigned short b, unsigned short c, unsigned short d) {
    slab.indices.insert(slab.indices.end(), {a, b, c, a, c, d});
  };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      if (!is_solid(i, j)) continue;
      quad(vertex(i, j, 1), vertex(i + 1, j, 1), vertex(i + 1, j + 1, 1), vertex(i, j + 1, 1));
      quad(vertex(i, j, 0), vertex(i, j + 1, 0), vertex(i + 1, j + 1, 0), vertex(i + 1, j, 0));
      const auto wall = [&](int i0, int j0, int i1, int j1) {
        quad(vertex(i0, j0, 0), vertex(i1, j1, 0), vertex(i1, j1, 1), vertex(i0, j0, 1));
      };
      if (!is_solid(i, j - 1)) wall(i, j, i + 1, j);
      if (!is_solid(i + 1, j)) wall(i + 1, j, i + 1, j + 1);
      if (!is_solid(i, j + 1)) wall(i + 1, j + 1, i, j + 1);
      if (!is_solid(i - 1, j)) wall(i, j + 1, i, j);
    }
  }
  return slab;
}

GLuint make_program() {
  const GLuint program = glCreateProgram();
  for (const auto& [stage, source] :
       {std::pair{GL_VERTEX_SHADER, vertex_shader}, std::pair{GL_FRAGMENT_SHADER, fragment_shader}}) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  const char* const varying = "refined";
  glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
  glBindAttribLocation(program, 0, "position");
  glBindAttribLocation(program, 1, "normal");
  glLinkProgram(program);
  glRefinementShaderSourceARK(program, 1, &refinement_shader, nullptr);
  return program;
}

void draw(const Slab& slab) {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(slab.indices.size()), GL_UNSIGNED_SHORT, slab.indices.data());
}

void place(int column) {
  glViewport(column * size, 0, size, size);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.45, 0.45, -0.45, 0.45, 1, 20);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(0, 0, -7);
  glRotatef(-50, 1, 0, 0);
  glRotatef(20, 0, 0, 1);
}

using Point = std::array<float, 3>;

// Returns the corners of the triangles that draw() draws.
std::vector<Point> read_back(const Slab& slab) {
  constexpr GLsizeiptr most_bytes = GLsizeiptr{16} << 20;
  GLuint buffer = 0;
  GLuint query = 0;
  GLuint triangles = 0;
  glGenBuffers(1, &buffer);
  glGenQueries(1, &query);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, most_bytes, nullptr, GL_STREAM_READ);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  glBeginTransformFeedback(GL_TRIANGLES);
  draw(slab);
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
  std::vector<Point> points(std::size_t{3} * triangles);
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(points.size() * sizeof(Point)),
                     points.data());
  return points;
}

// Returns the genus, or -1 if the surface is not closed. For a closed surface of genus g, V - E + F is 2 - 2 g.
// Vertices with the same bits are one vertex.
int genus(const std::vector<Point>& points) {
  std::map<Point, int> vertices;
  std::map<std::pair<int, int>, int> edges;
  for (const Point& point : points) vertices.try_emplace(point, static_cast<int>(vertices.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int a = vertices.at(points[i]);
    const int b = vertices.at(points[i % 3 == 2 ? i - 2 : i + 1]);
    ++edges[std::minmax(a, b)];
  }
  const bool closed = std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 2; });
  const int characteristic =
      static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(points.size() / 3);
  return closed ? (2 - characteristic) / 2 : -1;
}

int draw_all(const Slab& slab, GLuint program) {
  glUseProgram(program);
  GLint built = GL_FALSE;
  glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK,
                       &built);  // after this, the uniform of refine() has a location
  const GLint twist = glGetUniformLocation(program, "twist");
  const GLint color = glGetUniformLocation(program, "color");
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, slab.positions.data());
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, slab.tags.data());
  glEnableClientState(GL_DEPTH_TAG_ARRAY_ARK);
  glUniform3f(color, 0.75F, 0.55F, 0.8F);
  glVertexAttrib3f(1, 0.3F, 0.2F, 1);
  place(0);
  draw(slab);
  glEnable(GL_ARK);
  for (int column = 1; column < columns; ++column) {
    place(column);
    if (column == 2) glUniform1f(twist, 0.35F);
    if (column == 3) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    draw(slab);
  }
  const int found = genus(read_back(slab));
  std::printf("genus %d\n", found);
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s OUT.png\n", argv[0]);
    return 2;
  }
  std::vector<unsigned char> pixels(4UL * columns * size * size);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, columns * size, size) == GL_FALSE) {
    return 1;
  }
  glEnable(GL_DEPTH_TEST);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glARKinit(max_level);
  const int found = draw_all(make_slab(), make_program());
  glFinish();
  stbi_flip_vertically_on_write(1);
  const int written = stbi_write_png(argv[1], columns * size, size, 4, pixels.data(), 4 * columns * size);
  OSMesaDestroyContext(context);
  return written != 0 && found == 4 ? 0 : 1;
}
