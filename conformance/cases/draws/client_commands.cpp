// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Indirect draws whose commands are in the memory of the application: the compatibility profile has them while no buffer
// is bound to DRAW_INDIRECT_BUFFER (GL 4.6c, 10.4).
#include <fmt/core.h>

#include <algorithm>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"
#include "conformance/cases/repeated/expect_change.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

enum class ClientKind { arrays, elements };
constexpr GLsizei words_of(ClientKind kind) { return kind == ClientKind::arrays ? 4 : 5; }

// A command for triangle `place` (0 to 3), with so many vertices and instances.
std::vector<GLuint> command_of(ClientKind kind, GLuint place, GLuint count, GLuint instances) {
  if (kind == ClientKind::arrays) return {count, instances, 3 * place, 0};
  // The indices begin with those of triangle 1; base vertices lead to the others.
  return {count, instances, 0, 3 * place - 3, 0};
}

struct ClientRecord {
  GLuint place;
  GLuint count;
  GLuint instances;
};

// `gap`: further words after each command. They would draw too much if they were read.
std::vector<GLuint> memory_of(ClientKind kind, const std::vector<ClientRecord>& records, GLsizei gap) {
  std::vector<GLuint> words;
  for (const ClientRecord& record : records) {
    const std::vector<GLuint> command = command_of(kind, record.place, record.count, record.instances);
    words.insert(words.end(), command.begin(), command.end());
    for (GLsizei i = 0; i < gap; ++i) words.push_back(i % 2 == 0 ? 3 : 2);
  }
  return words;
}

void draw_several(ClientKind kind, const std::vector<GLuint>& words, GLsizei count, GLsizei gap, bool has_stride) {
  const GLsizei stride = has_stride ? 4 * (words_of(kind) + gap) : 0;
  if (kind == ClientKind::arrays)
    gl.MultiDrawArraysIndirect(GL_TRIANGLES, words.data(), count, stride);
  else
    gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_BYTE, words.data(), count, stride);
}

void draw_one(ClientKind kind, const GLuint* words) {
  if (kind == ClientKind::arrays)
    gl.DrawArraysIndirect(GL_TRIANGLES, words);
  else
    gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_BYTE, words);
}

void set_up_client_commands(Test& t) {
  set_up_four_triangles(t);
  const GLubyte indices[] = {3, 4, 5, 6, 7, 8};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void set_command_depths(bool is_uniform) {
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  gl.DepthTag1i(2);
}

const std::vector<std::vector<ClientRecord>>& record_lists() {
  static const std::vector<std::vector<ClientRecord>> all = {{{1, 3, 1}},
                                                             {{1, 3, 1}, {3, 3, 1}},
                                                             {{1, 3, 1}, {2, 3, 2}, {1, 3, 1}},
                                                             {{2, 3, 1}, {0, 0, 1}, {3, 3, 0}, {1, 6, 1}},
                                                             {{3, 3, 3}, {1, 3, 1}, {2, 3, 1}, {1, 3, 2}, {3, 3, 1}}};
  return all;
}

GLuint triangles_of_records(const std::vector<ClientRecord>& records) {
  GLuint triangles = 0;
  for (const ClientRecord& record : records) triangles += record.count / 3 * record.instances;
  return triangles;
}

bool has_empty_command(const std::vector<ClientRecord>& records) {
  return std::any_of(records.begin(), records.end(), [](const ClientRecord& record) { return record.count == 0; });
}

// Every stride: 0, that of the commands alone, and greater ones.
void check_command_strides(Test& t, ClientKind kind, bool is_uniform) {
  set_up_client_commands(t);
  set_command_depths(is_uniform);
  for (const std::vector<ClientRecord>& records : record_lists())
    for (const GLsizei gap : {0, 1, 2, 4, 11})
      for (const bool has_stride : {true, false}) {
        if (!has_stride && gap != 0) continue;
        const std::vector<GLuint> words = memory_of(kind, records, gap);
        const auto draw = [&] { draw_several(kind, words, static_cast<GLsizei>(records.size()), gap, has_stride); };
        const std::string what =
            fmt::format("{} commands, {} words apart{}", records.size(), gap, has_stride ? "" : ", with a stride of 0");
        gl.Disable(GL_ARK);
        const GLuint unrefined = count_generated(draw);
        if (unrefined != triangles_of_records(records) && has_empty_command(records))
          continue;  // Mesa 25 loses the rest
        t.expect_equal(unrefined, triangles_of_records(records), what + ": unrefined triangles");
        gl.Enable(GL_ARK);
        for (int again = 0; again < 2; ++again)
          t.expect_equal(count_generated(draw), 16 * triangles_of_records(records), what + ": triangles");
        expect_as_unrefined(t, draw, what);
      }
  t.expect_no_error("the draws");
}

// One word of a command changes in memory. No GL command announces it.
void check_changed_commands(Test& t, ClientKind kind, bool is_uniform) {
  set_up_client_commands(t);
  set_command_depths(is_uniform);
  constexpr GLsizei gap = 2;
  std::vector<ClientRecord> records = {{1, 3, 1}, {2, 3, 1}};
  std::vector<GLuint> words = memory_of(kind, records, gap);
  const auto write = [&] {
    const std::vector<GLuint> next = memory_of(kind, records, gap);
    std::copy(next.begin(), next.end(), words.begin());
  };
  const Draw several = [&] { draw_several(kind, words, 2, gap, true); };
  const Draw second = [&] { draw_one(kind, &words[static_cast<std::size_t>(words_of(kind)) + std::size_t{gap}]); };
  for (const auto& [what, draw] : {std::pair<const char*, Draw>{"two commands", several}, {"the second", second}})
    for (const ClientRecord next :
         {ClientRecord{0, 3, 1}, ClientRecord{1, 6, 1}, ClientRecord{3, 3, 1}, ClientRecord{2, 3, 1}})
      expect_change(
          t, draw,
          [&] {
            records[1] = next;
            write();
          },
          fmt::format("{}, place {} with {} vertices", what, next.place, next.count), 150);
}

// Vertices are in memory, too, and no vertex array object is bound.
void check_commands_and_arrays(Test& t, ClientKind kind) {
  set_up_client_commands(t);
  GLint elements = 0;
  gl.GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &elements);
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(elements));
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  Mesh mesh = four_triangles();
  gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), &mesh[0].position);
  gl.VertexAttribPointer(at_colour, 4, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), &mesh[0].colour);
  gl.EnableVertexAttribArray(at_position);
  gl.EnableVertexAttribArray(at_colour);
  set_command_depths(true);
  constexpr GLsizei gap = 3;
  const std::vector<GLuint> words = memory_of(kind, {{1, 3, 1}, {3, 3, 1}}, gap);
  const Draw draw = [&] { draw_several(kind, words, 2, gap, true); };
  t.expect_equal(count_generated(draw), 32U, "triangles");
  for (const std::size_t i : {3U, 9U, 11U})
    expect_change(
        t, draw, [&] { mesh[i].position[0] -= 0.3F; }, fmt::format("vertex {}", i), 60);
}

}  // namespace

Cases client_commands_cases() {
  Cases cases;
  const char* const wrong = "The stride is ignored; the memory is read as an offset; earlier commands are drawn.";
  for (const ClientKind kind : {ClientKind::arrays, ClientKind::elements}) {
    const std::string leaf = kind == ClientKind::arrays ? "arrays" : "elements";
    for (const bool is_uniform : {true, false}) {
      const std::string end = is_uniform ? ".uniform" : ".tags";
      cases.push_back({.name = "ark.draw.client_commands.stride." + leaf + end,
                       .clauses = {"10.R.2-2"},
                       .plan = "Indirect commands in memory, with every kind of stride.",
                       .wrong = wrong,
                       .apis = compat_only,
                       .check = [kind, is_uniform](Test& t) { check_command_strides(t, kind, is_uniform); }});
      cases.push_back({.name = "ark.draw.client_commands.changed." + leaf + end,
                       .clauses = {"10.R.2-2", "11.R.13-1"},
                       .plan = "Repeat a draw of indirect commands in memory; change one, and repeat it.",
                       .wrong = wrong,
                       .apis = compat_only,
                       .check = [kind, is_uniform](Test& t) { check_changed_commands(t, kind, is_uniform); }});
    }
    cases.push_back({.name = "ark.draw.client_commands.vertices." + leaf,
                     .clauses = {"10.R.2-2", "11.R.13-1"},
                     .plan = "Indirect commands and vertices are in memory; change a vertex.",
                     .wrong = wrong,
                     .apis = compat_only,
                     .check = [kind](Test& t) { check_commands_and_arrays(t, kind); }});
  }
  return cases;
}

}  // namespace glark::conformance
