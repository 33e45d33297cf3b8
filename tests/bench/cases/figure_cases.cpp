// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Figures 7.13 and 7.14 of Boubekeur 2007: adaptive and uniform refinement with segments of at most the same length on
// the screen; a million refined triangles from coarse meshes of different sizes; and the time of every depth.
#include <algorithm>
#include <array>
#include <cmath>

#include <glark/depth.h>

#include "tests/bench/cases/case.h"
#include "tests/bench/cases/figure_meshes.h"
#include "tests/bench/offscreen.h"
#include "tests/bench/subject/subject.h"

namespace glark::bench {
namespace {

constexpr unsigned deepest = 11;                           // so large that the level does not limit tags
constexpr std::array<float, 3> eye_of_sphere{0, 0, 3.2F};  // the eye of View::sphere
constexpr std::array<float, 3> eye_of_plane{0, 7.91F, 19.1F};
constexpr float pixels_at_one = 0.5F * picture_size / 0.35F;

// Computes tags from the length of edges on the screen.
class ScreenTags {
 public:
  ScreenTags(const Mesh& mesh, const depth::View& view)
      : tagger_(mesh.vertices.size(), mesh.indices, deepest), view_(view), tags_(mesh.vertices.size()) {
    for (const Vertex& vertex : mesh.vertices) {
      positions_.insert(positions_.end(), std::begin(vertex.position), std::end(vertex.position));
    }
  }
  // Sets tags so that no segment is longer than `pixels`.
  std::vector<std::uint8_t> tags(float pixels) {
    tagger_.by_edge_length(positions_, view_, pixels, tags_);
    for (float& tag : tags_) tag = std::ceil(tag - 1e-4F);
    triangles_ = static_cast<double>(tagger_.refined_triangles(tags_));
    return {tags_.begin(), tags_.end()};
  }
  // Returns the length of the longest edge in pixels.
  float longest() {
    tagger_.by_edge_length(positions_, view_, 1, tags_);
    return std::exp2(*std::max_element(tags_.begin(), tags_.end()));
  }
  double triangles() const { return triangles_; }  // for the last tags

 private:
  depth::Tagger tagger_;
  depth::View view_;
  std::vector<float> positions_;
  std::vector<float> tags_;
  double triangles_ = 0;
};

void compare(Report& report, const Effort& effort, const std::string& name, const Mesh& mesh, View view) {
  glARKinit(deepest);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  const Subject subject(mesh, Shading::glsl, view);
  ScreenTags by_screen(mesh,
                       {.eye = view == View::plane ? eye_of_plane : eye_of_sphere, .pixels_at_one = pixels_at_one});
  for (const unsigned level : {2U, 3U, 4U}) {
    const float segment = by_screen.longest() / static_cast<float>(1U << level);
    const std::vector<std::uint8_t> tags = by_screen.tags(segment);
    const Subject tagged(mesh, Shading::glsl, view, tags);
    const auto times = interleave({tagged.tagged(), subject.refined(level)}, effort);
    const auto uniform = static_cast<double>(mesh.triangles() << (2 * level));
    report.add({"fig7.13/" + name + "/level" + std::to_string(level),
                "thesis 2.5x to 4.6x",
                Goal::none,
                0,
                speed_ratio(times[1], times[0]),
                "x",
                {{"coarse_triangles", static_cast<double>(mesh.triangles())},
                 {"uniform_triangles", uniform},
                 {"adaptive_triangles", by_screen.triangles()},
                 {"longest_segment_pixels", static_cast<double>(segment)},
                 {"uniform_ms", times[1].median() * 1e3},
                 {"adaptive_ms", times[0].median() * 1e3}}});
  }
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_INPUTS_ARK);
}

void run_figure_7_13(Report& report, const Effort& effort) {
  for_each_figure_mesh(report, "fig7.13", [&](const std::string& name, const Mesh& mesh, View view) {
    compare(report, effort, name, mesh, view);
  });
}

void run_figure_7_14(Report& report, const Effort& effort) {
  constexpr int million = 1 << 20;
  glARKinit(8);
  for (unsigned depth = 0; depth <= 8; ++depth) {
    const Mesh mesh = make_sphere(std::max(million >> (2 * depth), 20));
    const Subject subject(mesh, Shading::glsl, View::sphere);
    const auto kept = interleave({subject.refined(depth), subject.touched(subject.refined(depth))}, effort);
    const auto refined = static_cast<double>(mesh.triangles() << (2 * depth));
    report.add(
        {"fig7.14/depth" + std::to_string(depth),
         "",
         Goal::none,
         0,
         refined / kept[0].median() * 1e-6,
         "M triangles/s",
         {{"depth", static_cast<double>(depth)},
          {"coarse_triangles", static_cast<double>(mesh.triangles())},
          {"refined_triangles", refined},
          {"ms", kept[0].median() * 1e3},
          {"ms_of_a_mesh_that_changes", kept[1].median() * 1e3},
          {"coarse_bytes", static_cast<double>(mesh.vertices.size() * sizeof(Vertex) + 4 * mesh.indices.size())}}});
  }
}

void run_depth_sweep(Report& report, const Effort& effort) {
  glARKinit(11);
  const Mesh mesh = first_triangles(make_sphere(20), 4);
  const Subject subject(mesh, Shading::glsl, View::sphere);
  for (unsigned depth = 1; depth <= 11; ++depth) {
    const auto times = interleave({subject.refined(depth)}, effort);
    const auto refined = static_cast<double>(mesh.triangles() << (2 * depth));
    report.add(
        {"sweep/depth" + std::to_string(depth),
         "",
         Goal::none,
         0,
         refined / times[0].median() * 1e-6,
         "M triangles/s",
         {{"depth", static_cast<double>(depth)}, {"refined_triangles", refined}, {"ms", times[0].median() * 1e3}}});
  }
}

}  // namespace

void add_figure_cases(std::vector<Case>& cases) {
  cases.push_back({"fig7.13", run_figure_7_13});
  cases.push_back({"fig7.14", run_figure_7_14});
  cases.push_back({"sweep", run_depth_sweep});
}

}  // namespace glark::bench
