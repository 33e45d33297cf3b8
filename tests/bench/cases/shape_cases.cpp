// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures the cost of a shape. Spheres are refined linearly, by curved triangles, by scalar-tagged triangles, by depth
// tags, and displaced. Each is compared with the same number of triangles refined beforehand.
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/bench/cases/case.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/same_picture.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

struct Shape {
  const char* name;
  GLenum refinement;
  bool displaced;
  bool tagged = false;  // the level comes from an array of depth tags
};

constexpr Shape shapes[] = {
    {"linear", GL_LINEAR_INPUTS_ARK, false},  {"pn", GL_CURVED_PN_ARK, false},
    {"stpn", GL_SCALAR_TAGGED_PN_ARK, false}, {"linear-displaced", GL_LINEAR_INPUTS_ARK, true},
    {"pn-displaced", GL_CURVED_PN_ARK, true}, {"depth-tags", GL_LINEAR_INPUTS_ARK, false, true}};
constexpr int height_unit = 5;

void upload_waves() {
  constexpr int size = 256;
  std::vector<float> heights;
  for (int i = 0; i < size * size; ++i) heights.push_back(std::sin(static_cast<float>(i % size) * 0.2F));
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0 + height_unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, size, size, 0, GL_RED, GL_FLOAT, heights.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glActiveTexture(GL_TEXTURE0);
}

void choose(const Shape& shape) {
  glARKParameteriARK(GL_REFINEMENT_ARK, static_cast<GLint>(shape.refinement));
  glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, shape.displaced ? height_unit : -1);
  glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.01F);
}

void run(const std::string& name, const Shape& shape, unsigned level, Report& report, const Effort& effort) {
  constexpr unsigned pool_level = 6;
  glARKinit(pool_level);
  if (shape.displaced) upload_waves();
  const Mesh mesh = make_sphere(1246);
  const std::vector<std::uint8_t> tags(shape.tagged ? mesh.vertices.size() : 0, static_cast<std::uint8_t>(level));
  const Subject coarse(mesh, Shading::glsl, View::sphere, tags);
  const Subject fine(refine(mesh, level), Shading::glsl, View::sphere);
  Competitor shaped = shape.tagged ? coarse.tagged() : coarse.refined(level);
  shaped.prepare = [prepare = shaped.prepare, shape] {
    prepare();
    choose(shape);
  };
  const auto times = interleave({shaped, fine.as_is()}, effort);
  // After the timing, the refined vertices are kept.
  if (shape.refinement == GL_LINEAR_INPUTS_ARK && !shape.displaced) expect_same(name, shaped, fine.as_is());
  Row row{name, "", Goal::at_least, like_static, 0, "", {}};
  row.measured = speed_ratio(times[1], times[0]);
  row.unit = "x";
  row.detail = {{"refined_ms", times[0].median() * 1e3},
                {"static_ms", times[1].median() * 1e3},
                {"ratio_of_least", times[1].least() / times[0].least()}};
  report.add(std::move(row));
  choose({"", GL_LINEAR_INPUTS_ARK, false});
}

}  // namespace

void add_shape_cases(std::vector<Case>& cases) {
  for (const Shape& shape : shapes) {
    for (const unsigned level : {3U, 5U}) {
      const std::string name = std::string("shape/") + shape.name + "/level" + std::to_string(level);
      cases.push_back({name, [=](Report& report, const Effort& effort) { run(name, shape, level, report, effort); }});
    }
  }
}

}  // namespace glark::bench
