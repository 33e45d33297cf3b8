// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program that runs for long: meshes come and go, in buffers, in client memory and in display lists; programs are linked
// again; pools, levels and refinements change. Linear refinement shows the unrefined picture all the time, and the memory
// of the process stops growing. SOAK_SCENES says for how long (12 scenes), SOAK_SEED is the seed (1).
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "tests/core/support/picture.h"
#include "tests/core/support/programs.h"

namespace glark::core::test {
namespace {

constexpr std::size_t most_meshes = 40;
constexpr int frames_of_a_scene = 24;  // without a change, so that refined vertices are kept
constexpr double megabyte = 1 << 20;
constexpr double most_growth = 24;  // megabytes, from the largest value of the second quarter to that of the last one
constexpr int scenes_until_full = 400;  // most meshes have come then, and all programs are compiled
constexpr const char* kept_megabytes = "8";

double from_environment(const char* name, double otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtod(text, nullptr) : otherwise;
}

double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  file >> all >> resident;
  constexpr double page = 4096;
  return static_cast<double>(resident) * page / megabyte;
}

struct Corner {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> normal;
  std::array<GLfloat, 4> colour;
};

// A sheet of cells * cells squares.
struct Sheet {
  std::vector<Corner> corners;
  std::vector<GLuint> indices;
};

enum class Way { buffers, client_memory, list };

struct Mesh {
  Sheet sheet;
  Way way = Way::buffers;
  std::size_t program = 0;  // 0: fixed function
  GLuint array = 0;
  std::array<GLuint, 2> buffers{};
  GLuint list = 0;
};

class Soak {
 public:
  explicit Soak(unsigned seed) : random_(seed) {
    link_again(1);
    link_again(2);
  }
  Soak(const Soak&) = delete;
  Soak& operator=(const Soak&) = delete;
  ~Soak() {
    for (Mesh& mesh : meshes_) drop(mesh);
  }

  // Changes the scene, draws it for some frames, and compares it with the unrefined picture.
  void scene() {
    change();
    glDisable(GL_ARK);
    const Picture plain = picture();
    const bool linear = choose_refinement();
    for (int frame = 0; frame < frames_of_a_scene; ++frame) draw();
    const Picture refined = picture();
    if (linear) {
      ASSERT_LE(differing_pixels(plain, refined), tolerated_pixels) << "scene " << scenes_ << ": " << settings_;
    }
    ASSERT_EQ(pending_errors(), "") << "scene " << scenes_ << ": " << settings_;
    ++scenes_;
  }
  int scenes() const { return scenes_; }

 private:
  unsigned one_of(unsigned count) { return static_cast<unsigned>(random_() % count); }
  GLfloat between(GLfloat low, GLfloat high) { return std::uniform_real_distribution<GLfloat>(low, high)(random_); }

  Sheet sheet() {
    Sheet result;
    const unsigned cells = 1 + one_of(one_of(4) == 0 ? 40 : 6);
    const GLfloat x = between(-1, 0.5F), y = between(-1, 0.5F), size = between(0.1F, 0.9F);
    const GLfloat red = between(0.2F, 1), blue = between(0.2F, 1);
    for (unsigned row = 0; row <= cells; ++row)
      for (unsigned column = 0; column <= cells; ++column) {
        const GLfloat u = static_cast<GLfloat>(column) / static_cast<GLfloat>(cells);
        const GLfloat v = static_cast<GLfloat>(row) / static_cast<GLfloat>(cells);
        result.corners.push_back({{x + u * size, y + v * size, 0}, {0, 0, 1}, {red * u, v, blue * (1 - u), 1}});
      }
    for (unsigned row = 0; row < cells; ++row)
      for (unsigned column = 0; column < cells; ++column) {
        const GLuint corner = row * (cells + 1) + column;
        for (const GLuint next : {0U, 1U, cells + 1, cells + 1, 1U, cells + 2}) result.indices.push_back(corner + next);
      }
    return result;
  }

  static void point(const Mesh& mesh, const Corner* first) {
    const auto* const bytes = reinterpret_cast<const char*>(first);
    if (mesh.program == 0) {
      glVertexPointer(3, GL_FLOAT, sizeof(Corner), bytes);
      glNormalPointer(GL_FLOAT, sizeof(Corner), bytes + offsetof(Corner, normal));
      glColorPointer(4, GL_FLOAT, sizeof(Corner), bytes + offsetof(Corner, colour));
      for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY}) glEnableClientState(array);
      return;
    }
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), bytes);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), bytes + offsetof(Corner, normal));
    glVertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, sizeof(Corner), bytes + offsetof(Corner, colour));
    for (const GLuint location : {0U, 1U, 2U}) glEnableVertexAttribArray(location);
  }

  static void draw_elements(const Mesh& mesh, const void* indices) {
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.sheet.indices.size()), GL_UNSIGNED_INT, indices);
  }

  Mesh make() {
    Mesh mesh;
    mesh.sheet = sheet();
    mesh.way = static_cast<Way>(one_of(3));
    mesh.program = one_of(3);
    glGenVertexArrays(1, &mesh.array);
    glBindVertexArray(mesh.array);
    if (mesh.way == Way::buffers) {
      mesh.buffers[1] = make_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.sheet.indices);
      mesh.buffers[0] = make_buffer(GL_ARRAY_BUFFER, mesh.sheet.corners);
      point(mesh, nullptr);
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
    if (mesh.way == Way::list) {
      mesh.list = glGenLists(1);
      glNewList(mesh.list, GL_COMPILE);
      glBegin(GL_TRIANGLES);
      for (const GLuint index : mesh.sheet.indices) {
        const Corner& corner = mesh.sheet.corners[index];
        glColor4fv(corner.colour.data());
        glVertexAttrib4fv(2, corner.colour.data());
        glNormal3fv(corner.normal.data());
        glVertex3fv(corner.position.data());
      }
      glEnd();
      glEndList();
    }
    return mesh;
  }

  static void drop(Mesh& mesh) {
    glDeleteVertexArrays(1, &mesh.array);
    glDeleteBuffers(2, mesh.buffers.data());
    if (mesh.list != 0) glDeleteLists(mesh.list, 1);
  }

  void link_again(std::size_t which) {
    glDeleteProgram(programs_.at(which));
    programs_.at(which) =
        link_program({.vertex = "#version 120\nattribute vec3 position; attribute vec3 normal; attribute vec4 colour; "
                                "varying vec4 shown;\n"
                                "void main() { gl_Position = vec4(position, 1.0); shown = normal.z * " +
                                std::string(which == 1 ? "colour" : "colour.zxyw") + "; }\n",
                      .fragment = "#version 120\nvarying vec4 shown;\nvoid main() { gl_FragColor = shown; }\n",
                      .attributes = {"position", "normal", "colour"}});
  }

  void change() {
    for (unsigned changes = one_of(6); changes > 0 || meshes_.empty(); changes -= changes > 0 ? 1 : 0) {
      if (meshes_.size() >= most_meshes || (one_of(3) == 0 && !meshes_.empty())) {
        const std::size_t at = one_of(static_cast<unsigned>(meshes_.size()));
        drop(meshes_[at]);
        meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(at));
      } else {
        meshes_.push_back(make());
      }
    }
    if (one_of(20) == 0) link_again(1 + one_of(2));
  }

  // Returns whether the surface is flat and its colours are linear.
  bool choose_refinement() {
    constexpr std::array<GLenum, 5> refinements{GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK, GL_CURVED_PN_ARK,
                                                GL_PHONG_ARK, GL_LINEAR_INPUTS_ARK};
    const GLenum refinement = refinements.at(one_of(refinements.size()));
    const GLuint level = 1 + one_of(3);
    const GLuint pool = level + one_of(5);
    const bool welded = one_of(8) == 0;
    refine_uniformly(level, refinement);
    glARKinit(pool);
    glARKParameteriARK(GL_WELD_ARK, welded ? GL_TRUE : GL_FALSE);
    settings_ = "refinement " + std::to_string(refinement) + ", level " + std::to_string(level) + ", pool " +
                std::to_string(pool) + (welded ? ", welded" : "");
    return refinement == GL_LINEAR_INPUTS_ARK || refinement == GL_LINEAR_OUTPUTS_ARK;
  }

  void draw() const {
    for (const Mesh& mesh : meshes_) {
      glUseProgram(programs_.at(mesh.program));
      switch (mesh.way) {
        case Way::buffers:
          glBindVertexArray(mesh.array);
          draw_elements(mesh, nullptr);
          break;
        case Way::client_memory:
          glBindVertexArray(0);
          for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY}) glDisableClientState(array);
          for (const GLuint location : {0U, 1U, 2U}) glDisableVertexAttribArray(location);
          point(mesh, mesh.sheet.corners.data());
          draw_elements(mesh, mesh.sheet.indices.data());
          break;
        case Way::list:
          glBindVertexArray(0);
          glCallList(mesh.list);
          break;
      }
    }
    glBindVertexArray(0);
  }

  Picture picture() const {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw();
    return read_picture();
  }

  std::mt19937 random_;
  std::array<GLuint, 3> programs_{};
  std::vector<Mesh> meshes_;
  int scenes_ = 0;
  std::string settings_;
};

TEST(Soak, MeshesComeAndGo) {
  ASSERT_EQ(setenv("GLARK_KEEP_REFINED", kept_megabytes, 1), 0);
  const int scenes = static_cast<int>(from_environment("SOAK_SCENES", 12));
  const OsmesaContext context(Profile::compatibility);
  Soak soak(static_cast<unsigned>(from_environment("SOAK_SEED", 1)));
  std::array<double, 4> largest{};  // megabytes, of each quarter
  while (soak.scenes() < scenes) {
    double& most = largest.at(static_cast<std::size_t>(4 * soak.scenes() / scenes));
    ASSERT_NO_FATAL_FAILURE(soak.scene());
    most = std::max(most, resident_megabytes());
  }
  std::printf("megabytes at most, by quarters: %.0f %.0f %.0f %.0f\n", largest[0], largest[1], largest[2], largest[3]);
  if (scenes >= scenes_until_full) {
    EXPECT_LT(largest[3], largest[1] + most_growth);
  }
}

}  // namespace
}  // namespace glark::core::test
