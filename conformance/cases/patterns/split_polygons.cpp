// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the coarse triangles of polygons that are split at their centroids (POLYGON_CENTROID_ARK, 11.R.3), for every
// drawing command.
#include <fmt/core.h>
#include <cmath>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLsizei most_vertices = 9;
constexpr GLint first = 2;

// One part of a command, or the whole command: `count` vertices from `first` on, `instances` times.
struct Part {
  GLsizei count = 0;
  GLsizei instances = 1;
};
using Parts = std::vector<Part>;

const void* index_at(GLint index) { return reinterpret_cast<const void*>(std::uintptr_t{2} * index); }

std::vector<GLsizei> counts_of(const Parts& parts) {
  std::vector<GLsizei> counts;
  for (const Part& part : parts) counts.push_back(part.count);
  return counts;
}

void bind_commands(const Parts& parts, bool is_indexed) {
  std::vector<GLuint> words;
  for (const Part& part : parts) {
    words.push_back(static_cast<GLuint>(part.count));
    words.push_back(static_cast<GLuint>(part.instances));
    words.push_back(static_cast<GLuint>(first));
    words.push_back(0);
    if (is_indexed) words.push_back(0);
  }
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, static_cast<GLsizeiptr>(words.size() * sizeof(GLuint)), words.data(),
                GL_STATIC_DRAW);
}

struct SplitCommand {
  const char* leaf;
  void (*draw)(GLenum mode, const Parts& parts);
  bool has_parts = false;
  bool has_instances = false;
};

constexpr SplitCommand split_commands[] = {
    {"draw_arrays", [](GLenum mode, const Parts& p) { gl.DrawArrays(mode, first, p[0].count); }},
    {.leaf = "draw_arrays_instanced",
     .draw = [](GLenum mode, const Parts& p) { gl.DrawArraysInstanced(mode, first, p[0].count, p[0].instances); },
     .has_instances = true},
    {.leaf = "multi_draw_arrays",
     .draw =
         [](GLenum mode, const Parts& p) {
           const std::vector<GLint> firsts(p.size(), first);
           gl.MultiDrawArrays(mode, firsts.data(), counts_of(p).data(), static_cast<GLsizei>(p.size()));
         },
     .has_parts = true},
    {"draw_elements",
     [](GLenum mode, const Parts& p) { gl.DrawElements(mode, p[0].count, GL_UNSIGNED_SHORT, index_at(first)); }},
    {.leaf = "draw_elements_instanced",
     .draw =
         [](GLenum mode, const Parts& p) {
           gl.DrawElementsInstanced(mode, p[0].count, GL_UNSIGNED_SHORT, index_at(first), p[0].instances);
         },
     .has_instances = true},
    {.leaf = "multi_draw_elements",
     .draw =
         [](GLenum mode, const Parts& p) {
           const std::vector<const void*> places(p.size(), index_at(first));
           gl.MultiDrawElements(mode, counts_of(p).data(), GL_UNSIGNED_SHORT, places.data(),
                                static_cast<GLsizei>(p.size()));
         },
     .has_parts = true},
    {.leaf = "draw_arrays_indirect",
     .draw =
         [](GLenum mode, const Parts& p) {
           bind_commands(p, false);
           gl.DrawArraysIndirect(mode, nullptr);
         },
     .has_instances = true},
    {.leaf = "draw_elements_indirect",
     .draw =
         [](GLenum mode, const Parts& p) {
           bind_commands(p, true);
           gl.DrawElementsIndirect(mode, GL_UNSIGNED_SHORT, nullptr);
         },
     .has_instances = true},
    {.leaf = "multi_draw_arrays_indirect",
     .draw =
         [](GLenum mode, const Parts& p) {
           bind_commands(p, false);
           gl.MultiDrawArraysIndirect(mode, nullptr, static_cast<GLsizei>(p.size()), 0);
         },
     .has_parts = true,
     .has_instances = true},
    {.leaf = "multi_draw_elements_indirect",
     .draw =
         [](GLenum mode, const Parts& p) {
           bind_commands(p, true);
           gl.MultiDrawElementsIndirect(mode, GL_UNSIGNED_SHORT, nullptr, static_cast<GLsizei>(p.size()), 0);
         },
     .has_parts = true,
     .has_instances = true},
};

// The vertices of a regular polygon, or of a strip across it.
Mesh round_mesh(GLenum mode) {
  Mesh mesh(first + most_vertices);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const float step = 0.5F * static_cast<float>(i);
    const float angle = mode != GL_QUAD_STRIP ? step : i % 2 == 0 ? 0.5F * step : -0.5F * step - 0.25F;
    mesh[i].position = {0.8F * std::cos(angle), 0.8F * std::sin(angle), 0, 1};
  }
  return mesh;
}

GLuint coarse_triangles(GLenum mode, const Parts& parts) {
  GLsizei sum = 0;
  for (const auto& [count, instances] : parts) {
    const GLsizei of_one = mode == GL_POLYGON ? (count < 3 ? 0 : count)
                           : mode == GL_QUADS ? count / 4 * 4
                           : count < 4        ? 0
                                              : (count - 2) / 2 * 4;
    sum += of_one * instances;
  }
  return static_cast<GLuint>(sum);
}

void check_split(Test& t, const SplitCommand& command, GLenum mode) {
  gl.UseProgram(colour_program(t));
  upload(round_mesh(mode));
  GLuint buffers[2] = {0, 0};
  gl.GenBuffers(2, buffers);
  std::vector<GLushort> indices;
  for (GLushort i = 0; i < first + most_vertices; ++i) indices.push_back(i);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(2 * indices.size()), indices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers[1]);
  refine_uniformly(1);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  std::vector<Parts> all;
  for (GLsizei count = 0; count <= most_vertices; ++count) {
    all.push_back({{count}});
    if (command.has_instances) all.push_back({{count, 3}});
    if (command.has_parts) {
      all.push_back({{3}, {count}, {5}});  // Mesa 22 draws nothing unrefined if the first part is empty
      all.push_back({{4}, {count}});
    }
    if (command.has_parts && command.has_instances) all.push_back({{3, 2}, {count, 3}, {2, 2}});
  }
  for (const Parts& parts : all) {
    std::string what = "triangles of";
    for (const auto& [count, instances] : parts) what += fmt::format(" {} vertices {} times", count, instances);
    const auto draw = [&] { command.draw(mode, parts); };
    t.expect_equal(count_generated(draw), 4 * coarse_triangles(mode, parts), what);
    // A convex primitive covers the same pixels, however it is split.
    const Picture refined = picture_of(draw);
    gl.Disable(GL_ARK);
    t.expect_same_picture(refined, picture_of(draw), what, 3, 60);
    gl.Enable(GL_ARK);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases split_polygons_cases() {
  Cases cases;
  for (const SplitCommand& command : split_commands)
    for (const auto& [leaf, mode] :
         {std::pair<const char*, GLenum>{"polygon", GL_POLYGON}, {"quads", GL_QUADS}, {"quad_strip", GL_QUAD_STRIP}})
      cases.push_back({.name = fmt::format("ark.coarse.split.{}.{}", leaf, command.leaf),
                       .clauses = {"11.R.3-6", "11.R.3-7"},
                       .plan = "Count the triangles of primitives of 0 to 9 vertices, split at their centroids.",
                       .wrong = "A polygon of three vertices is not split; the parts of a command have one count.",
                       .apis = compat_only,
                       .check = [&command, mode = mode](Test& t) { check_split(t, command, mode); }});
  return cases;
}

}  // namespace glark::conformance
