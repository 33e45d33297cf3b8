// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that are repeated after a change of vertices or indices in the memory of the application. No GL command
// announces such a change.
#include <cstddef>
#include <string_view>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"
#include "conformance/reference/pattern.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr Apis client_apis = {Api::gl_compat, Api::gles};
constexpr std::size_t memory_vertices = 9;

struct MemoryVertex {
  Vec3 position;
  std::array<GLubyte, 3> colour;
  GLubyte other = 0;  // between the end of a vertex and the next one
};

// Three triangles. Draws use the last two, so the numbers of their vertices do not begin at 0.
struct Memory {
  std::array<MemoryVertex, memory_vertices> mixed;  // all arrays in one
  std::array<Vec3, memory_vertices> positions;
  std::array<std::array<GLubyte, 3>, memory_vertices> colours;
  std::array<GLubyte, 6> bytes = {3, 4, 5, 6, 7, 8};
  std::array<GLushort, 6> shorts = {3, 4, 5, 6, 7, 8};
  std::array<GLuint, 6> words = {3, 4, 5, 6, 7, 8};
  // For base vertices of 3 and -5. They name the same vertices.
  static constexpr GLint up = 3, down = -5;
  std::array<GLubyte, 6> low_bytes = {0, 1, 2, 3, 4, 5};
  std::array<GLushort, 6> low_shorts = {0, 1, 2, 3, 4, 5};
  std::array<GLuint, 6> low_words = {0, 1, 2, 3, 4, 5};
  std::array<GLushort, 6> high_shorts = {8, 9, 10, 11, 12, 13};
  std::array<GLuint, 6> high_words = {8, 9, 10, 11, 12, 13};

  Memory() {
    for (std::size_t i = 0; i < memory_vertices; ++i) {
      const auto n = static_cast<float>(i);
      const MeshVertex from = one_triangle()[i % 3];
      const bool is_second = i >= 6;
      const GLubyte blue = i % 3 == 1 ? 200 : 0;
      set(i, {0.5F * from.position[0] + (is_second ? 0.45F : -0.45F), 0.8F * from.position[1] - 0.02F * n, 0},
          {static_cast<GLubyte>(25 * i), static_cast<GLubyte>(255 - 20 * i), blue});
    }
  }
  void set(std::size_t i, const Vec3& position, const std::array<GLubyte, 3>& colour) {
    mixed[i] = {position, colour};
    positions[i] = position;
    colours[i] = colour;
  }
  void set_index(std::size_t i, GLubyte index) {
    bytes[i] = index;
    shorts[i] = index;
    words[i] = index;
    low_words[i] = low_shorts[i] = low_bytes[i] = static_cast<GLubyte>(index - up);
    high_words[i] = high_shorts[i] = static_cast<GLubyte>(index - down);
  }
};

void point_at(const Memory& memory, bool is_mixed, bool is_generic) {
  const GLsizei stride = is_mixed ? sizeof(MemoryVertex) : 0;
  const void* const positions = is_mixed ? static_cast<const void*>(&memory.mixed[0].position) : &memory.positions;
  const void* const colours = is_mixed ? static_cast<const void*>(&memory.mixed[0].colour) : &memory.colours;
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  if (is_generic) {
    gl.VertexAttribPointer(at_position, 3, GL_FLOAT, GL_FALSE, stride, positions);
    gl.VertexAttribPointer(at_colour, 3, GL_UNSIGNED_BYTE, GL_TRUE, stride, colours);
    gl.EnableVertexAttribArray(at_position);
    gl.EnableVertexAttribArray(at_colour);
  } else {
    gl.VertexPointer(3, GL_FLOAT, stride, positions);
    gl.ColorPointer(3, GL_UNSIGNED_BYTE, stride, colours);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
  }
}

struct MemoryCommand {
  const char* leaf;
  void (*draw)(const Memory& memory);
  bool has_indices = false;
  Apis apis = client_apis;
};

constexpr MemoryCommand memory_commands[] = {
    {"draw_arrays", [](const Memory&) { gl.DrawArrays(GL_TRIANGLES, 3, 6); }},
    {"draw_arrays_instanced", [](const Memory&) { gl.DrawArraysInstanced(GL_TRIANGLES, 3, 6, 2); }},
    {.leaf = "multi_draw_arrays",
     .draw =
         [](const Memory&) {
           const GLint firsts[] = {3, 6};
           const GLsizei counts[] = {3, 3};
           gl.MultiDrawArrays(GL_TRIANGLES, firsts, counts, 2);
         },
     .apis = compat_only},
    {"bytes", [](const Memory& m) { gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, m.bytes.data()); }, true},
    {"shorts", [](const Memory& m) { gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, m.shorts.data()); }, true},
    {"words", [](const Memory& m) { gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, m.words.data()); }, true},
    {"range", [](const Memory& m) { gl.DrawRangeElements(GL_TRIANGLES, 3, 8, 6, GL_UNSIGNED_SHORT, m.shorts.data()); },
     true},
    {"base_vertex",
     [](const Memory& m) { gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, m.shorts.data(), 0); }, true},
    {.leaf = "multi_draw_elements",
     .draw =
         [](const Memory& m) {
           const void* const indices[] = {&m.shorts[0], &m.shorts[3]};
           const GLsizei counts[] = {3, 3};
           gl.MultiDrawElements(GL_TRIANGLES, counts, GL_UNSIGNED_SHORT, indices, 2);
         },
     .has_indices = true,
     .apis = compat_only},
    {"base.bytes",
     [](const Memory& m) {
       gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, m.low_bytes.data(), Memory::up);
     },
     true},
    {"base.shorts",
     [](const Memory& m) {
       gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, m.high_shorts.data(), Memory::down);
     },
     true},
    {"base.words",
     [](const Memory& m) {
       gl.DrawElementsBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_INT, m.low_words.data(), Memory::up);
     },
     true},
    {"base.range",
     [](const Memory& m) {
       gl.DrawRangeElementsBaseVertex(GL_TRIANGLES, 8, 13, 6, GL_UNSIGNED_INT, m.high_words.data(), Memory::down);
     },
     true},
    {"base.instanced",
     [](const Memory& m) {
       gl.DrawElementsInstancedBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, m.low_shorts.data(), 2, Memory::up);
     },
     true},
    {.leaf = "base.instanced_base_instance",
     .draw =
         [](const Memory& m) {
           gl.DrawElementsInstancedBaseVertexBaseInstance(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, m.low_shorts.data(), 1,
                                                          Memory::up, 1);
         },
     .has_indices = true,
     .apis = compat_only},
    {.leaf = "base.multi_draw_elements",
     .draw =
         [](const Memory& m) {
           const void* const indices[] = {&m.low_shorts[0], &m.high_shorts[3]};
           const GLsizei counts[] = {3, 3};
           const GLint bases[] = {Memory::up, Memory::down};
           gl.MultiDrawElementsBaseVertex(GL_TRIANGLES, counts, GL_UNSIGNED_SHORT, indices, 2, bases);
         },
     .has_indices = true,
     .apis = compat_only},
};

// Changes one vertex at a time, and in it one byte or one component. The last bytes matter most: an implementation may
// compare one vertex too few.
void check_memory(Test& t, const MemoryCommand& command, bool is_mixed, bool is_generic) {
  gl.UseProgram(is_generic ? colour_program(t) : 0);
  Memory memory;
  point_at(memory, is_mixed, is_generic);
  for (const bool is_uniform : {true, false}) {
    is_uniform ? refine_uniformly(2) : refine_by_tags(3);
    gl.DepthTag1i(2);
    const Draw draw = [&] { command.draw(memory); };
    for (const std::size_t i : {8U, 3U, 5U}) {
      const std::string what = " of vertex " + as_text(i);
      const MemoryVertex old = memory.mixed[i];
      std::array<GLubyte, 3> colour = old.colour;
      colour[2] = colour[2] < 100 ? 255 : 0;
      expect_change(
          t, draw, [&] { memory.set(i, old.position, colour); }, "the last byte of the colour" + what, 150);
      Vec3 position = old.position;
      position[0] += is_uniform ? 0.3F : -0.3F;
      expect_change(
          t, draw, [&] { memory.set(i, position, colour); }, "the first component" + what, 150);
      position[1] *= 0.3F;
      expect_change(
          t, draw, [&] { memory.set(i, position, colour); }, "the second component" + what, 150);
      expect_change(
          t, draw, [&] { memory.set(i, old.position, old.colour); }, "the old value" + what, 150);
    }
    for (const std::size_t i : {5U, 0U, 3U}) {
      if (!command.has_indices) break;
      const GLubyte old = memory.bytes[i];
      const std::string what = "index " + as_text(i);
      expect_change(
          t, draw, [&] { memory.set_index(i, i < 3 ? 7 : 4); }, what, 150);
      expect_change(
          t, draw, [&] { memory.set_index(i, old); }, "the old " + what, 150);
    }
  }
}

// The array of depth tags is in the memory of the application, too.
void check_tags(Test& t, GLsizei stride, bool has_elements) {
  gl.UseProgram(colour_program(t));
  const Memory memory;
  point_at(memory, true, true);
  std::array<GLubyte, 64> tags{};
  gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, stride, tags.data());
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  refine_by_tags(4);
  const auto draw = [&] {
    if (has_elements)
      gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, memory.shorts.data());
    else
      gl.DrawArrays(GL_TRIANGLES, 3, 6);
  };
  const auto step = static_cast<std::size_t>(stride == 0 ? 1 : stride);
  const auto write = [&](std::size_t first, GLubyte tag) {
    for (std::size_t i = first; i < memory_vertices; ++i) tags[step * i] = tag;
  };
  const auto expect_triangles = [&](GLuint expected, const char* what) {
    t.expect_equal(count_generated(draw), expected, what);
    repeat_often(draw);
    t.expect_equal(count_generated(draw), expected, std::string(what) + ", again");
  };
  expect_triangles(2, "triangles without depth");
  write(6, 1);
  expect_triangles(5, "triangles, one of them with depths");
  write(8, 3);  // depths 1, 2 and 2
  const auto few = static_cast<GLuint>(reference::minimum_triangles({1, 2, 2}));
  gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK);
  expect_triangles(1 + few, "triangles with another tag of the last vertex");
  write(0, 2);
  expect_triangles(32, "triangles with equal tags");
  t.expect_no_error("the draws");
}

enum class Gone { deleted, unbound };

// Puts the vertices into a buffer.
void upload_mixed(const Memory& memory) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(memory.mixed), memory.mixed.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(at_position, 3, GL_FLOAT, GL_FALSE, sizeof(MemoryVertex), nullptr);
  gl.VertexAttribPointer(at_colour, 3, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(MemoryVertex),
                         reinterpret_cast<const void*>(offsetof(MemoryVertex, colour)));
  gl.EnableVertexAttribArray(at_position);
  gl.EnableVertexAttribArray(at_colour);
}

// The vertices are in a buffer, and so are the indices at first. Then the indices are in memory, and their buffer, or a new
// one with its name, has other contents.
void check_elements(Test& t, Gone how, bool is_uniform) {
  gl.UseProgram(colour_program(t));
  Memory memory;
  upload_mixed(memory);
  GLuint elements = 0;
  gl.GenBuffers(1, &elements);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);
  const GLushort indices[] = {6, 7, 8};
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  const void* place = nullptr;
  GLsizei count = 3;
  const Draw draw = [&] { gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, place); };
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  gl.DepthTag1i(2);
  const auto leave = [&] {
    if (how == Gone::deleted) gl.DeleteBuffers(1, &elements);
    if (how == Gone::unbound) gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    gl.BindBuffer(GL_ARRAY_BUFFER, elements);
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    place = memory.shorts.data();
    count = 6;
  };
  expect_change(t, draw, leave, "indices in memory");
  expect_change(
      t, draw, [&] { memory.set_index(5, 4); }, "the last index");
  expect_change(
      t, draw, [&] { memory.set_index(0, 8); }, "the first index");
}

// Colours from a buffer, and then from memory.
void check_arrays(Test& t, Gone how, bool is_uniform) {
  gl.UseProgram(colour_program(t));
  Memory memory;
  point_at(memory, false, true);
  GLuint colours = 0;
  gl.GenBuffers(1, &colours);
  gl.BindBuffer(GL_ARRAY_BUFFER, colours);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(memory.colours), memory.colours.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(at_colour, 3, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 3, 6); };
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  gl.DepthTag1i(2);
  const auto leave = [&] {
    for (auto& colour : memory.colours) colour[1] = static_cast<GLubyte>(colour[1] / 2);
    if (how == Gone::deleted) gl.DeleteBuffers(1, &colours);
    point_at(memory, false, true);
  };
  expect_change(t, draw, leave, "colours in memory");
  expect_change(
      t, draw,
      [&] {
        memory.colours[8] = {255, 0, 255};
      },
      "the last colour");
  expect_change(
      t, draw,
      [&] {
        memory.colours[3] = {0, 255, 255};
      },
      "the first colour");
}

// One array is in memory and the other one in a buffer.
void check_one_array(Test& t, bool are_positions, bool is_generic) {
  gl.UseProgram(is_generic ? colour_program(t) : 0);
  Memory memory;
  point_at(memory, false, is_generic);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  if (are_positions) {
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(memory.colours), memory.colours.data(), GL_STATIC_DRAW);
    is_generic ? gl.VertexAttribPointer(at_colour, 3, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr)
               : gl.ColorPointer(3, GL_UNSIGNED_BYTE, 0, nullptr);
  } else {
    gl.BufferData(GL_ARRAY_BUFFER, sizeof(memory.positions), memory.positions.data(), GL_STATIC_DRAW);
    is_generic ? gl.VertexAttribPointer(at_position, 3, GL_FLOAT, GL_FALSE, 0, nullptr)
               : gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  }
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 3, 6); };
  for (const bool is_uniform : {true, false}) {
    is_uniform ? refine_uniformly(2) : refine_by_tags(3);
    gl.DepthTag1i(2);
    for (const std::size_t i : {8U, 3U})
      expect_change(
          t, draw,
          [&] {
            if (are_positions)
              memory.positions[i][1] *= 0.4F;
            else
              memory.colours[i] = {static_cast<GLubyte>(is_uniform ? 255 : 0), 0, 255};
          },
          "vertex " + as_text(i) + (is_uniform ? "" : ", by tags"), 150);
  }
}

constexpr Area memory_case{.prefix = "ark.draw.again.memory.", .apis = client_apis};

}  // namespace

Cases changed_client_memory_cases() {
  Cases cases;
  const char* const wrong = "The earlier vertices or indices of the draw.";
  for (const bool is_generic : {true, false})
    for (const bool is_mixed : {false, true})
      for (const MemoryCommand& command : memory_commands) {
        if (std::string_view(command.leaf).starts_with("base.") && is_mixed != is_generic) continue;
        cases.push_back(memory_case(
            std::string(is_generic ? "" : "conventional.") + command.leaf + (is_mixed ? ".mixed" : ".apart"),
            {"10.R.2-1", "11.R.13-1"},
            "Repeat a draw from the application's memory, change one component or one index there, and repeat it.",
            wrong, [&command, is_mixed, is_generic](Test& t) { check_memory(t, command, is_mixed, is_generic); },
            is_generic ? command.apis : compat_only));
      }
  for (const bool is_generic : {true, false})
    for (const bool are_positions : {true, false})
      cases.push_back(memory_case(
          std::string(is_generic ? "" : "conventional.") + (are_positions ? "positions_alone" : "colours_alone"),
          {"10.R.2-1", "11.R.13-1"}, "Repeat a draw with one array in memory and one in a buffer. Change the former.",
          wrong, [=](Test& t) { check_one_array(t, are_positions, is_generic); },
          is_generic ? client_apis : compat_only));
  for (const GLsizei stride : {0, 5})
    for (const bool has_elements : {false, true})
      cases.push_back(memory_case(
          std::string("tags.") + (has_elements ? "elements" : "arrays") + (stride == 0 ? ".tight" : ".stride"),
          {"10.R.1-21", "11.R.13-1"},
          "Repeat a draw with depth tags in the application's memory, change some of them, and count.",
          "The earlier tags.", [stride, has_elements](Test& t) { check_tags(t, stride, has_elements); }));
  for (const bool is_uniform : {true, false})
    for (const Gone how : {Gone::deleted, Gone::unbound}) {
      const std::string end =
          std::string(how == Gone::deleted ? "deleted" : "unbound") + (is_uniform ? ".uniform" : ".tags");
      cases.push_back(memory_case(
          "elements_" + end, {"10.R.2-1", "11.R.13-1"},
          "Repeat a draw with indices in a buffer that is then deleted or unbound, then with indices in memory.", wrong,
          [how, is_uniform](Test& t) { check_elements(t, how, is_uniform); }));
      cases.push_back(memory_case(
          "arrays_" + end, {"10.R.2-1", "11.R.13-1"},
          "Repeat a draw with colours in a buffer that is then deleted or unbound, then with colours in memory.", wrong,
          [how, is_uniform](Test& t) { check_arrays(t, how, is_uniform); }));
    }
  return cases;
}

}  // namespace glark::conformance
