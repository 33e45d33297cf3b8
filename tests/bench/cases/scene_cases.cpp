// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Frames of many draws that do not change. Compares a scene with the same scene refined beforehand. Measures what
// refinement adds to each of many small draws, for all ways in which programs repeat draws.
#include <algorithm>
#include <memory>

#include "tests/bench/cases/case.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/same_picture.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

// Objects stand side by side.
struct Grid {
  int columns = 20;
  int rows = 10;
  int objects() const { return columns * rows; }
};
constexpr Grid few;
constexpr Grid many{40, 25};
constexpr unsigned pool_level = 6;

Mesh placed(Mesh mesh, const Grid& grid, int object) {
  const float width = 2.0F / static_cast<float>(grid.columns);
  const float height = 2.0F / static_cast<float>(grid.rows);
  const float x = width * (static_cast<float>(object % grid.columns) - 0.5F * static_cast<float>(grid.columns - 1));
  const int row = object / grid.columns;
  const float y = height * (static_cast<float>(row) - 0.5F * static_cast<float>(grid.rows - 1));
  for (Vertex& vertex : mesh.vertices) {
    for (float& coordinate : vertex.position) coordinate *= 0.5F * width;
    vertex.position[0] += x;
    vertex.position[1] += y;
  }
  return mesh;
}

enum class Way { arrays, pointers, lists };

GLuint compile_list(const Mesh& mesh) {
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  for (const std::uint32_t index : mesh.indices) {
    const Vertex& vertex = mesh.vertices[index];
    glNormal3fv(vertex.normal);
    glTexCoord2fv(vertex.uv);
    glVertex3fv(vertex.position);
  }
  glEnd();
  glEndList();
  return list;
}

class Scene {
 public:
  struct Objects {
    Grid grid = few;
    int triangles = 0;   // of each
    unsigned level = 0;  // they are refined beforehand
    bool tagged = false;
  };
  Scene(const Objects& what, Shading shading, View view, Way way) : shading_(shading), view_(view), way_(way) {
    const int triangles = what.triangles;
    const Mesh sphere = triangles >= 20 ? make_sphere(triangles)
                                        : first_triangles(make_sphere(20), static_cast<std::size_t>(triangles));
    for (int object = 0; object < what.grid.objects(); ++object) {
      const Mesh mesh = refine(placed(sphere, what.grid, object), what.level);
      if (way == Way::lists) {
        lists_.push_back(compile_list(mesh));
      } else {
        std::vector<std::uint8_t> tags(what.tagged ? mesh.vertices.size() : 0);
        for (std::size_t i = 0; i < tags.size(); ++i) tags[i] = static_cast<std::uint8_t>(1 + i % 3);
        subjects_.push_back(std::make_unique<Subject>(mesh, shading, view, tags));
      }
    }
  }
  ~Scene() {
    for (const GLuint list : lists_) glDeleteLists(list, 1);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  Competitor as_is() const { return frame(false, GL_UNIFORM_DEPTH_ARK, 0); }
  Competitor refined(unsigned level) const { return frame(true, GL_UNIFORM_DEPTH_ARK, level); }
  Competitor tagged() const { return frame(true, GL_DEPTH_TAG_ARK, 0); }

 private:
  Competitor frame(bool ark, GLenum source, unsigned level) const {
    return {[this, ark, source, level] {
              use_shading(shading_, view_);
              glARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
              glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, static_cast<GLint>(level));
              ark ? glEnable(GL_ARK) : glDisable(GL_ARK);
            },
            [this] { draw(); }};
  }
  void draw() const {
    const std::size_t objects = std::max(subjects_.size(), lists_.size());
    for (std::size_t number = 0; number < objects; ++number) {
      if (shading_ == Shading::fixed_function)
        glColor3f(1, 0.5F, static_cast<float>(number) / static_cast<float>(objects));
      switch (way_) {
        case Way::arrays: subjects_[number]->draw_by_array(); break;
        case Way::pointers: subjects_[number]->draw_by_pointers(); break;
        case Way::lists: glCallList(lists_[number]); break;
      }
    }
  }

  Shading shading_;
  View view_;
  Way way_;
  std::vector<std::unique_ptr<Subject>> subjects_;
  std::vector<GLuint> lists_;
};

std::string name_of(Shading shading, Way way) {
  constexpr const char* ways[] = {"arrays", "pointers", "lists"};
  return std::string(shading == Shading::glsl ? "glsl/" : "fixed/") + ways[static_cast<int>(way)];
}

struct StaticScene {
  const char* prefix;
  Grid grid;
  int triangles;  // of each object
  double goal;

  std::string name(Shading shading, Way way, unsigned level) const {
    return prefix + name_of(shading, way) + "/level" + std::to_string(level);
  }
};
constexpr StaticScene large_objects{"scene/", few, 100, like_static};
constexpr StaticScene small_objects{"scene/many/", many, 12, 1 / 1.15};

// Compares a frame of objects with a frame of the refined objects.
void run_static(const StaticScene& scene, Shading shading, Way way, unsigned level, Report& report,
                const Effort& effort) {
  glARKinit(pool_level);
  const Scene coarse({scene.grid, scene.triangles}, shading, View::sphere, way);
  const Scene fine({scene.grid, scene.triangles, level}, shading, View::sphere, way);
  const std::string name = scene.name(shading, way, level);
  expect_same(name, coarse.refined(level), fine.as_is());
  Effort longer = effort;
  longer.total_seconds *= 2;
  const auto times = interleave({coarse.refined(level), fine.as_is()}, longer);
  report.add({name + "/static",
              "",
              Goal::at_least,
              scene.goal,
              speed_ratio(times[1], times[0]),
              "x",
              {{"refined_ms", times[0].median() * 1e3},
               {"static_ms", times[1].median() * 1e3},
               {"ratio_of_least", times[1].least() / times[0].least()}}});
}

// Each draw has two culled triangles, so only the cost of the draw itself remains.
void run_small(Shading shading, Way way, bool tagged, Report& report, const Effort& effort) {
  glARKinit(pool_level);
  const Scene scene({.triangles = 2, .tagged = tagged}, shading, View::culled, way);
  const auto times = interleave({tagged ? scene.tagged() : scene.refined(1), scene.as_is()}, effort);
  constexpr double most = 15;
  const double us = 1e6 / few.objects();
  report.add({"scene/small/" + name_of(shading, way) + (tagged ? "/adaptive" : "") + "/added",
              "",
              Goal::at_most,
              most,
              least_combination(times, {1, -1}) * us,
              "us/draw",
              {{"refined_us", times[0].least() * us}, {"as_is_us", times[1].least() * us}}});
}

}  // namespace

void add_scene_cases(std::vector<Case>& cases) {
  const auto add_static = [&](const StaticScene& scene, Shading shading, Way way, unsigned level) {
    cases.push_back({scene.name(shading, way, level), [=, &scene](Report& report, const Effort& effort) {
                       run_static(scene, shading, way, level, report, effort);
                     }});
  };
  const auto add_small = [&](Shading shading, Way way, bool tagged) {
    cases.push_back({"scene/small/" + name_of(shading, way) + (tagged ? "/adaptive" : ""),
                     [=](Report& report, const Effort& effort) { run_small(shading, way, tagged, report, effort); }});
  };
  for (const unsigned level : {2U, 3U}) {
    add_static(large_objects, Shading::glsl, Way::arrays, level);
    add_static(large_objects, Shading::fixed_function, Way::arrays, level);
    add_static(large_objects, Shading::fixed_function, Way::lists, level);
  }
  for (const Way way : {Way::arrays, Way::pointers}) {
    add_static(small_objects, Shading::glsl, way, 2);
    add_static(small_objects, Shading::fixed_function, way, 2);
  }
  add_static(small_objects, Shading::fixed_function, Way::lists, 2);
  for (const Shading shading : {Shading::glsl, Shading::fixed_function}) {
    add_small(shading, Way::arrays, false);
    add_small(shading, Way::pointers, false);
    add_small(shading, Way::arrays, true);
  }
  add_small(Shading::fixed_function, Way::lists, false);
}

}  // namespace glark::bench
