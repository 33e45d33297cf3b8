// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every drawing command in every mode that has triangles (10.R.2). The unrefined result determines the refined one.
#include <fmt/core.h>
#include <cstring>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/triangle_modes.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLsizei vertex_count = 24;
constexpr GLenum index_types[] = {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT};

// Coordinates are eighths, so that no sum is rounded. No two vertices are alike, and no three that draw together are
// collinear.
Mesh draw_mesh() {
  Mesh mesh(vertex_count);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto n = static_cast<float>(i);
    const auto row = static_cast<float>(i % 2);
    mesh[i].position = {-0.875F + 0.0625F * n, row * 0.75F - 0.5F + 0.03125F * static_cast<float>((i * 5) % 7), 0, 1};
    mesh[i].colour = {n / 32, 1 - n / 32, static_cast<float>((i * 7) % 4) / 4, 1};
    mesh[i].tag = static_cast<float>((i * 3 + i / 5) % 4);
    mesh[i].triangle = n;
  }
  return mesh;
}

// The commands' input: bound buffers, and offsets into them.
struct Input {
  GLenum mode = GL_TRIANGLES;
  GLenum index_type = GL_UNSIGNED_SHORT;
  std::size_t index_size = 2;

  const void* index(std::size_t at) const { return reinterpret_cast<const void*>(at * index_size); }
};

struct Command {
  const char* name;
  bool is_indexed;
  Apis apis;
  void (*draw)(const Input& input);
};

const void* indirect(std::size_t at) { return reinterpret_cast<const void*>(at * sizeof(GLuint)); }

void draw_multi_arrays(const Input& in) {
  const GLint first[] = {2, 0, 12};
  const GLsizei count[] = {7, 0, 8};
  gl.MultiDrawArrays(in.mode, first, count, 3);
}

void draw_multi_elements(const Input& in) {
  const void* const at[] = {in.index(1), in.index(0), in.index(9)};
  const GLsizei count[] = {6, 0, 8};
  gl.MultiDrawElements(in.mode, count, in.index_type, at, 3);
}

void draw_multi_base_vertex(const Input& in) {
  const void* const at[] = {in.index(1), in.index(9)};
  const GLsizei count[] = {6, 8};
  const GLint base[] = {5, -1};
  gl.MultiDrawElementsBaseVertex(in.mode, count, in.index_type, at, 2, base);
}

// Offsets of the records of indirect draws, in numbers of four or five to a record; see indirect_records().
constexpr std::size_t arrays_record = 3;
constexpr std::size_t elements_record = 11;

std::vector<GLuint> indirect_records(bool has_base_instance) {
  const GLuint base = has_base_instance ? 2 : 0;
  return {99, 99, 99,                                       // so that an offset of 0 is wrong
          7,  2,  4,  base, 8,    1, 12, 0,                 // count, instances, first, base instance
          8,  2,  1,  3,    base, 6, 1,  5, 9U, base, 99};  // count, instances, first index, base vertex, base instance
}

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      {"arrays", false, every_api, [](const Input& in) { gl.DrawArrays(in.mode, 3, 8); }},
      {"arrays_instanced", false, every_api, [](const Input& in) { gl.DrawArraysInstanced(in.mode, 3, 8, 3); }},
      {"arrays_base_instance", false, desktop_apis,
       [](const Input& in) { gl.DrawArraysInstancedBaseInstance(in.mode, 3, 8, 2, 3); }},
      {"multi_arrays", false, desktop_apis, draw_multi_arrays},
      {"arrays_indirect", false, every_api,
       [](const Input& in) { gl.DrawArraysIndirect(in.mode, indirect(arrays_record)); }},
      {"multi_arrays_indirect", false, desktop_apis,
       [](const Input& in) { gl.MultiDrawArraysIndirect(in.mode, indirect(arrays_record), 2, 0); }},
      {"elements", true, every_api, [](const Input& in) { gl.DrawElements(in.mode, 8, in.index_type, in.index(3)); }},
      {"range_elements", true, every_api,
       [](const Input& in) { gl.DrawRangeElements(in.mode, 0, 23, 8, in.index_type, in.index(3)); }},
      {"elements_base_vertex", true, every_api,
       [](const Input& in) { gl.DrawElementsBaseVertex(in.mode, 8, in.index_type, in.index(3), 7); }},
      {"range_elements_base_vertex", true, every_api,
       [](const Input& in) { gl.DrawRangeElementsBaseVertex(in.mode, 0, 15, 8, in.index_type, in.index(3), 7); }},
      {"elements_instanced", true, every_api,
       [](const Input& in) { gl.DrawElementsInstanced(in.mode, 8, in.index_type, in.index(3), 3); }},
      {"elements_instanced_base_vertex", true, every_api,
       [](const Input& in) { gl.DrawElementsInstancedBaseVertex(in.mode, 8, in.index_type, in.index(3), 2, 6); }},
      {"elements_base_instance", true, desktop_apis,
       [](const Input& in) { gl.DrawElementsInstancedBaseInstance(in.mode, 8, in.index_type, in.index(3), 2, 3); }},
      {"elements_base_vertex_base_instance", true, desktop_apis,
       [](const Input& in) {
         gl.DrawElementsInstancedBaseVertexBaseInstance(in.mode, 8, in.index_type, in.index(3), 2, 6, 3);
       }},
      {"multi_elements", true, desktop_apis, draw_multi_elements},
      {"multi_elements_base_vertex", true, desktop_apis, draw_multi_base_vertex},
      {"elements_indirect", true, every_api,
       [](const Input& in) { gl.DrawElementsIndirect(in.mode, in.index_type, indirect(elements_record)); }},
      {"multi_elements_indirect", true, desktop_apis,
       [](const Input& in) { gl.MultiDrawElementsIndirect(in.mode, in.index_type, indirect(elements_record), 2, 0); }},
  };
  return all;
}

template <typename Index>
void fill_indices() {
  std::vector<Index> indices;
  for (unsigned i = 0; i < 20; ++i) indices.push_back(static_cast<Index>((i * 5 + i / 4 + 1) % 16));
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(Index)), indices.data(),
                GL_STATIC_DRAW);
}

void bind_indices(GLenum type) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  if (type == GL_UNSIGNED_BYTE) fill_indices<GLubyte>();
  if (type == GL_UNSIGNED_SHORT) fill_indices<GLushort>();
  if (type == GL_UNSIGNED_INT) fill_indices<GLuint>();
}

void bind_records(const Test& t) {
  const std::vector<GLuint> records = indirect_records(!t.is_gles());
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
  gl.BufferData(GL_DRAW_INDIRECT_BUFFER, static_cast<GLsizeiptr>(records.size() * sizeof(GLuint)), records.data(),
                GL_STATIC_DRAW);
}

void set_up(Test& t) {
  use_readable_tags();
  gl.UseProgram(draw_program(t));
  upload(draw_mesh());
  gl.VertexAttribDivisor(at_extra, 1);  // per instance, and starting at the base instance
  bind_records(t);
}

void refine_at(int uniform_level) {
  refine_by_tags(3);
  if (uniform_level < 0) return;
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, uniform_level);
}

Input input_of(GLenum mode, GLenum type) {
  return {mode, type, type == GL_UNSIGNED_BYTE ? 1U : type == GL_UNSIGNED_SHORT ? 2U : 4U};
}

// Runs before ARKinit: later unrefined draws may take the code path of refined draws.
std::vector<Picture> plain_pictures(const Command& command, GLenum mode) {
  std::vector<Picture> pictures;
  for (const GLenum type : index_types) {
    if (command.is_indexed) bind_indices(type);
    pictures.push_back(picture_of([&] { command.draw(input_of(mode, type)); }));
  }
  return pictures;
}

void check_command(Test& t, const Command& command, GLenum mode) {
  set_up(t);
  const std::vector<Picture> plain = plain_pictures(command, mode);
  for (std::size_t i = 0; i < std::size(index_types); ++i) {
    if (!command.is_indexed && i > 0) break;
    if (command.is_indexed) bind_indices(index_types[i]);
    const Input input = input_of(mode, index_types[i]);
    for (const int level : {-1, 0, 1, 2}) {
      refine_at(level);
      const std::string what = (command.is_indexed ? fmt::format("{} bits, ", 8 * input.index_size) : std::string()) +
                               (level < 0 ? std::string("tags") : fmt::format("uniform depth {}", level));
      expect_refined(
          t, {.uniform_level = level}, [&] { command.draw(input); }, what);
      // A quadrilateral that crosses itself may be cut in another way when it is captured.
      if (level != 1 && mode != GL_QUADS)
        t.expect_same_picture(picture_of([&] { command.draw(input); }), plain[i], what, 3, 60);
    }
  }
}

void control_command(Test& t, const Command& command, GLenum mode) {
  gl.UseProgram(draw_program(t));
  upload(draw_mesh(), false);
  bind_records(t);
  if (command.is_indexed) bind_indices(GL_UNSIGNED_SHORT);
  const auto vertices = capture_as<DrawVertex>(t, 1000, [&] { command.draw({mode}); });
  t.expect(!vertices.empty(), "the unrefined command gives triangles");
}

Case command_case(const Command& command, const TriangleMode& mode) {
  return {.name = std::string("ark.draw.") + command.name + "." + mode.name,
          .clauses = mode.is_legacy
                         ? std::vector<std::string>{"10.R.2-1", "10.R.2-2", "11.R.3-1", "11.R.3-5", "11.R.4-2"}
                         : std::vector<std::string>{"10.R.2-1", "10.R.2-2", "11.R.3-1", "11.R.4-1", "11.R.4-2"},
          .plan =
              "Capture the command unrefined, and refined by tags and at uniform depths 0 to 2, with every index "
              "type: number, vertices and area of the triangles follow from the coarse ones.",
          .wrong =
              "Unrefined; wrong vertices where the first vertex, the base vertex or the base instance is ignored; "
              "missing triangles of the last draw or instance; flipped triangles of a strip.",
          .apis = mode.is_legacy ? compat_only : command.apis,
          .control = [&command, mode](Test& t) { control_command(t, command, mode.mode); },
          .check = [&command, mode](Test& t) { check_command(t, command, mode.mode); }};
}

// Repeats one command, then another that differs in one argument. Each gives its unrefined picture.
void check_alternating(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(draw_mesh());
  const GLushort indices[] = {0, 1, 2, 4, 3, 5, 7, 6, 2};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  const Input in;
  const std::function<void()> draws[] = {
      [&] { gl.DrawElements(GL_TRIANGLES, 6, in.index_type, nullptr); },
      [&] { gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, in.index_type, nullptr, 5); },
      [&] { gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, in.index_type, nullptr, 14); },
      [&] { gl.DrawElements(GL_TRIANGLES, 6, in.index_type, in.index(3)); },
      [&] { gl.DrawElements(GL_TRIANGLES, 3, in.index_type, nullptr); },
      [&] { gl.DrawElements(GL_TRIANGLE_STRIP, 6, in.index_type, nullptr); },
      [&] { gl.DrawArrays(GL_TRIANGLES, 0, 6); },
      [&] { gl.DrawArrays(GL_TRIANGLES, 7, 6); },
  };
  const auto picture = [](const std::function<void()>& draw) {
    clear_surface();
    draw();
    return read_picture(surface_size, surface_size);
  };
  std::vector<Picture> expected;
  for (const auto& draw : draws) expected.push_back(picture(draw));
  for (const bool is_uniform : {false, true}) {
    if (is_uniform)
      refine_uniformly(2);
    else
      refine_by_tags(3);
    for (std::size_t i = 0; i < std::size(draws); ++i)
      for (int again = 0; again < 4; ++again)
        t.expect_same_picture(picture(draws[i]), expected[i], fmt::format("command {}", i), 3, 60);
    for (std::size_t i = 0; i < std::size(draws); ++i)
      t.expect_same_picture(picture(draws[i]), expected[i], fmt::format("command {} in turn", i), 3, 60);
  }
}

// The buffer of the tags changes between repeated draws, by every way to write to it.
void check_changed_tags(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle(), false);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_DYNAMIC_DRAW);
  gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  refine_by_tags(4);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (GLubyte round = 0; round < 9; ++round) {
    const GLubyte tags[4] = {static_cast<GLubyte>(round % 4), static_cast<GLubyte>((round + 1) % 5), 2, 0};
    if (round % 3 == 0) gl.BufferSubData(GL_ARRAY_BUFFER, 0, sizeof(tags), tags);
    if (round % 3 == 1) gl.BufferData(GL_ARRAY_BUFFER, sizeof(tags), tags, GL_DYNAMIC_DRAW);
    if (round % 3 == 2) {
      void* const mapped = gl.MapBufferRange(GL_ARRAY_BUFFER, 0, sizeof(tags), GL_MAP_WRITE_BIT);
      t.require(mapped != nullptr, "the buffer can be mapped");
      std::memcpy(mapped, tags, sizeof(tags));
      gl.UnmapBuffer(GL_ARRAY_BUFFER);
    }
    const auto expected = reference::minimum_triangles(reference::edge_depths({tags[0], tags[1], tags[2]}));
    for (int again = 0; again < 4; ++again) {
      draw();
      t.expect_equal(std::int64_t{count_generated(draw)}, std::int64_t{expected}, "triangles with the current tags");
    }
  }
}

}  // namespace

Cases draw_modes_cases() {
  Cases cases = {{.name = "ark.draw.again.other_command",
                  .clauses = {"10.R.2-2", "11.R.13-1"},
                  .plan = "Repeat commands that differ in one argument, one after the other and in turn, by tags and "
                          "uniformly: the pictures are the unrefined ones.",
                  .wrong = "Data of one command is used for another with another base vertex, offset, count or mode.",
                  .check = check_alternating},
                 {.name = "ark.draw.again.other_tags",
                  .clauses = {"10.R.1-18", "11.R.13-1"},
                  .plan = "Repeat a draw, and write other tags to its buffer in three ways.",
                  .wrong = "The tags that the buffer held before.",
                  .check = check_changed_tags}};
  for (const Command& command : commands())
    for (const TriangleMode& mode : triangle_modes) cases.push_back(command_case(command, mode));
  return cases;
}

}  // namespace glark::conformance
