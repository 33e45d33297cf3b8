// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Primitive restart: it cuts refined draws where it cuts unrefined ones (11.R.3).
#include <fmt/core.h>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLsizei index_count = 18;

// Coordinates are eighths and sixteenths, so that no sum is rounded. No two vertices are alike.
Mesh restart_mesh() {
  Mesh mesh(24);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto n = static_cast<float>(i);
    mesh[i].position = {-0.875F + 0.0625F * n,
                        static_cast<float>(i % 2) * 0.75F - 0.5F + 0.03125F * static_cast<float>((i * 5) % 7), 0, 1};
    mesh[i].colour = {n / 32, 1 - n / 32, static_cast<float>((i * 7) % 4) / 4, 1};
    mesh[i].tag = static_cast<float>((i * 3 + i / 5) % 4);
    mesh[i].triangle = n;
  }
  return mesh;
}

struct Restart {
  const char* leaf;
  bool is_fixed;      // PRIMITIVE_RESTART_FIXED_INDEX
  GLuint index;       // if `is_fixed`, the greatest index of each type
  bool is_on = true;  // off: the restart index is an ordinary vertex
};

constexpr GLenum index_types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};

// Runs of 4, 5, 0 and 6 vertices: no run is a whole number of triangles and of quadrilaterals.
template <typename Index>
void fill_indices(const Restart& restart) {
  const auto r = restart.is_fixed ? static_cast<Index>(~Index{0}) : static_cast<Index>(restart.index);
  const Index indices[index_count] = {0, 1, 2, 4, r, 3, 6, 7, 8, 9, r, r, 10, 13, 11, 14, 12, 15};
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
}

void bind_indices(GLenum type, const Restart& restart) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  if (type == GL_UNSIGNED_BYTE) fill_indices<GLubyte>(restart);
  if (type == GL_UNSIGNED_SHORT) fill_indices<GLushort>(restart);
  if (type == GL_UNSIGNED_INT) fill_indices<GLuint>(restart);
}

struct Command {
  const char* leaf;
  void (*draw)(GLenum mode, GLenum type);
};

// The index is compared with the restart index before the base vertex is added.
const Command commands[] = {
    {"elements", [](GLenum mode, GLenum type) { gl.DrawElements(mode, index_count, type, nullptr); }},
    {"base_vertex", [](GLenum mode, GLenum type) { gl.DrawElementsBaseVertex(mode, index_count, type, nullptr, 7); }},
    {"instanced",
     [](GLenum mode, GLenum type) { gl.DrawElementsInstancedBaseVertex(mode, index_count, type, nullptr, 2, 3); }},
};

void check_restart(Test& t, const Restart& restart, GLenum mode) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  upload(restart_mesh());
  gl.VertexAttribDivisor(at_extra, 1);
  const GLenum name = restart.is_fixed ? GL_PRIMITIVE_RESTART_FIXED_INDEX : GL_PRIMITIVE_RESTART;
  if (restart.is_on) gl.Enable(name);
  if (!restart.is_fixed) gl.PrimitiveRestartIndex(restart.index);
  for (const GLenum type : index_types) {
    bind_indices(type, restart);
    for (const Command& command : commands)
      for (const int level : {-1, 1}) {
        refine_by_tags(3);
        if (level >= 0) {
          gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
          gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
        }
        expect_refined(
            t, {.uniform_level = level}, [&] { command.draw(mode, type); },
            fmt::format("{}{}{}", command.leaf, (level < 0 ? ", tags, type " : ", uniform, type "),
                        type - GL_UNSIGNED_BYTE));
      }
  }
}

void control_restart(Test& t, const Restart& restart, GLenum mode) {
  gl.UseProgram(draw_program(t));
  upload(restart_mesh(), false);
  bind_indices(GL_UNSIGNED_SHORT, restart);
  const GLenum name = restart.is_fixed ? GL_PRIMITIVE_RESTART_FIXED_INDEX : GL_PRIMITIVE_RESTART;
  if (restart.is_on) gl.Enable(name);
  if (!restart.is_fixed) gl.PrimitiveRestartIndex(restart.index);
  const auto count = [&] {
    return capture_as<DrawVertex>(t, 1000, [&] { gl.DrawElements(mode, index_count, GL_UNSIGNED_SHORT, nullptr); })
               .size() /
           3;
  };
  std::size_t expected = 1 + 1 + 2;
  if (mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN) expected = 2 + 3 + 4;
  if (mode == GL_QUADS) expected = 2 + 2 + 2;
  if (mode == GL_QUAD_STRIP) expected = 2 + 2 + 4;
  if (restart.is_on) t.expect_equal(count(), expected, "unrefined triangles, restarted");
  t.expect(count() > 0, "the unrefined command gives triangles");
}

struct Mode {
  const char* name;
  GLenum mode;
};

}  // namespace

Cases primitive_restart_cases() {
  const Restart restarts[] = {
      {"index", false, 0xFE}, {"vertex_index", false, 5}, {"fixed", true, 0}, {"off", false, 5, false}};
  const Mode modes[] = {{"triangles", GL_TRIANGLES},
                        {"triangle_strip", GL_TRIANGLE_STRIP},
                        {"triangle_fan", GL_TRIANGLE_FAN},
                        {"quads", GL_QUADS},
                        {"quad_strip", GL_QUAD_STRIP}};
  Cases cases;
  for (const Restart& restart : restarts)
    for (const Mode& mode : modes) {
      const bool is_legacy = mode.mode == GL_QUADS || mode.mode == GL_QUAD_STRIP;
      cases.push_back({.name = std::string("ark.restart.") + restart.leaf + "." + mode.name,
                       .clauses = {"10.R.2-1", "11.R.3-1"},
                       .plan = "Draw indices in runs of 4, 5, 0 and 6 vertices, with every index type, a base vertex "
                               "and instances: the refined triangles are those of the unrefined draw.",
                       .wrong = "The restart index counts as a vertex; it is compared after the base vertex is added; "
                                "a triangle across a restart; strips keep their parity.",
                       .control = [restart, mode](Test& t) { control_restart(t, restart, mode.mode); },
                       .check = [restart, mode](Test& t) { check_restart(t, restart, mode.mode); }});
      if (is_legacy)
        cases.back().apis = compat_only;
      else if (!restart.is_fixed)
        cases.back().apis = desktop_apis;
    }
  return cases;
}

}  // namespace glark::conformance
