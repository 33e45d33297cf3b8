// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares a frame of QAS with the same triangles evaluated beforehand, in buffers that do not change.
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "tests/bench/cases/case.h"
#include "tests/bench/gl.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/same_picture.h"
#include "tests/bench/subject/mesh.h"
#include "tests/qas/meshes.h"

namespace glark::bench {
namespace {

using qas::test::ControlMesh;

constexpr const char* shade = R"(
out vec4 shaded;
uniform vec4 fit;
void show(vec3 p, vec3 n) {
  vec3 light = normalize(vec3(0.4, 0.5, 0.8));
  float diffuse = max(dot(n, light), 0.0);
  float specular = pow(max(dot(n, normalize(light + vec3(0.0, 0.0, 1.0))), 0.0), 16.0);
  shaded = vec4(vec3(0.2) + diffuse * vec3(0.5, 0.5, 0.4) + specular * vec3(0.2), 1.0);
  gl_Position = vec4((p - fit.xyz) * fit.w * vec3(1.0, 1.0, -1.0), 1.0);
}
)";
constexpr const char* of_patches = "in mat2x3 point; in mat2x3 normal; void main() { show(point[0], normal[0]); }\n";
constexpr const char* of_points = "in vec3 point; in vec3 normal; void main() { show(point, normal); }\n";
constexpr const char* fragment = "#version 400\nin vec4 shaded; out vec4 color; void main() { color = shaded; }\n";

constexpr GLuint point_input = 1, normal_input = 3;

GLuint link(const char* inputs_and_main) {
  const GLuint program = glCreateProgram();
  const std::string vertex = std::string("#version 400\n") + shade + inputs_and_main;
  for (const auto& [stage, text] :
       {std::pair{GL_VERTEX_SHADER, vertex.c_str()}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = glCreateShader(static_cast<GLenum>(stage));
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
  }
  glBindAttribLocation(program, point_input, "point");
  glBindAttribLocation(program, normal_input, "normal");
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) throw std::runtime_error("the program of QAS does not link");
  return program;
}

template <typename T>
GLuint filled(GLenum target, const std::vector<T>& values) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STREAM_DRAW);
  return buffer;
}

void input(GLuint location, GLsizei stride, std::size_t offset) {
  glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
  glEnableVertexAttribArray(location);
}

class Frames {
 public:
  Frames(const ControlMesh& mesh, unsigned level) : mesh_(mesh), surface_(mesh.view(), {.threads = 1}), level_(level) {
    surface_.update(mesh.positions);
    corners_.resize(surface_.corner_count());
    surface_.write_corners(corners_);
    glGenVertexArrays(2, arrays_);
    prepare_patches();
    prepare_points();
    for (const GLuint program : {patches_, points_}) {
      glUseProgram(program);
      glUniform4f(glGetUniformLocation(program, "fit"), 0, 0, 0, static_cast<float>(2 / mesh.diagonal()));
    }
    const std::string source = qas::refinement_shader();
    const char* const text = source.c_str();
    glRefinementShaderSourceARK(patches_, 1, &text, nullptr);
    GLint built = GL_FALSE;
    glGetRefinementivARK(patches_, GL_REFINEMENT_STATUS_ARK, &built);
    if (built == GL_FALSE) throw std::runtime_error("the refinement shader of QAS does not build");
    // The uniforms follow those of the program when it is drawn.
  }
  ~Frames() {
    glDeleteVertexArrays(2, arrays_);
    glDeleteBuffers(3, buffers_);
    glDeleteProgram(patches_);
    glDeleteProgram(points_);
  }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  Competitor refined() const {
    return {[this] { use_patches(); },
            [this] { glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size())); }};
  }
  // Returns a whole frame: the step, the upload, and the draw.
  Competitor animated() {
    return {[this] { use_patches(); },
            [this] {
              surface_.update(mesh_.positions);
              surface_.write_corners(corners_);
              glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(corners_.size() * sizeof(qas::Corner)),
                              corners_.data());
              glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
            }};
  }
  Competitor beforehand() const {
    return {[this] {
              glDisable(GL_ARK);
              glUseProgram(points_);
              glBindVertexArray(arrays_[1]);
            },
            [this] { glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr); }};
  }

 private:
  void prepare_patches() {
    glBindVertexArray(arrays_[0]);
    buffers_[0] = filled(GL_ARRAY_BUFFER, corners_);
    input(point_input, sizeof(qas::Corner), offsetof(qas::Corner, position));
    input(point_input + 1, sizeof(qas::Corner), offsetof(qas::Corner, edge_position));
    input(normal_input, sizeof(qas::Corner), offsetof(qas::Corner, normal));
    input(normal_input + 1, sizeof(qas::Corner), offsetof(qas::Corner, edge_normal));
  }

  // Prepares one refined triangle with barycentric coordinates as positions. Vertices are shared within the coarse
  // triangle.
  void prepare_points() {
    const Mesh corners{{{{1, 0, 0}, {}, {}}, {{0, 1, 0}, {}, {}}, {{0, 0, 1}, {}, {}}}, {0, 1, 2}};
    const Mesh pattern = refine(corners, level_);
    std::vector<qas::Sample> samples;
    std::vector<std::uint32_t> indices;
    for (std::size_t patch = 0; patch < surface_.patches().size(); ++patch) {
      const auto first = static_cast<std::uint32_t>(samples.size());
      for (const Vertex& vertex : pattern.vertices)
        samples.push_back(surface_.evaluate(patch, {vertex.position[0], vertex.position[1], vertex.position[2]}));
      for (const std::uint32_t index : pattern.indices) indices.push_back(first + index);
    }
    index_count_ = static_cast<GLsizei>(indices.size());
    glBindVertexArray(arrays_[1]);
    buffers_[1] = filled(GL_ELEMENT_ARRAY_BUFFER, indices);
    buffers_[2] = filled(GL_ARRAY_BUFFER, samples);
    input(point_input, sizeof(qas::Sample), offsetof(qas::Sample, position));
    input(normal_input, sizeof(qas::Sample), offsetof(qas::Sample, normal));
  }

  void use_patches() const {
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
    glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, static_cast<GLint>(level_));
    glEnable(GL_ARK);
    glUseProgram(patches_);
    glBindVertexArray(arrays_[0]);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  }

  const ControlMesh& mesh_;
  qas::Surface surface_;
  unsigned level_;
  std::vector<qas::Corner> corners_;
  GLuint patches_ = link(of_patches), points_ = link(of_points);
  GLuint arrays_[2] = {}, buffers_[3] = {};
  GLsizei index_count_ = 0;
};

void run(const std::string& name, const ControlMesh& mesh, unsigned level, Report& report, const Effort& effort) {
  glARKinit(6);
  Frames frames(mesh, level);
  const std::string wrong = difference(picture_of(frames.refined()), picture_of(frames.beforehand()));
  if (!wrong.empty()) throw std::runtime_error(name + ": " + wrong);
  const auto times = interleave({frames.refined(), frames.animated(), frames.beforehand()}, effort);
  report.add({name + "/static",
              "",
              level == 5 ? Goal::at_least : Goal::none,
              0.7,
              speed_ratio(times[2], times[0]),
              "x",
              {{"refined_ms", times[0].median() * 1e3}, {"other_ms", times[2].median() * 1e3}}});
  report.add({name + "/animated/static", "", Goal::none, 0, speed_ratio(times[2], times[1]), "x", {}});
}

}  // namespace

void add_qas_draw_cases(std::vector<Case>& cases) {
  for (const unsigned level : {3U, 4U, 5U}) {
    const std::string name = "qas/draw/knot/level" + std::to_string(level);
    cases.push_back({name, [name, level](Report& report, const Effort& effort) {
                       run(name, qas::test::knot(30, 5), level, report, effort);
                     }});
  }
}

}  // namespace glark::bench
