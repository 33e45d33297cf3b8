// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Packed vertex attributes (GL 4.6 compatibility profile, 10.3.4): as vertices, as attributes of vertices, as current
// values of array draws, and in lists that are called often.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"

namespace glark::conformance {
namespace {

constexpr GLuint packed_list = 42;
constexpr GLenum packed_types[] = {GL_INT_2_10_10_10_REV, GL_UNSIGNED_INT_2_10_10_10_REV};

using SetPacked = void (*)(GLenum type, GLuint value);

struct PackedCommand {
  const char* leaf;
  SetPacked set;
  const char* value = nullptr;  // in the vertex stage, from 0 to 1; null: the command gives a vertex
  GLenum current = GL_NONE;     // its current value
};

#define GLARK_PACKED(command)                                                        \
  {#command "ui", [](GLenum type, GLuint value) { gl.command##ui(type, value); }}, { \
#command "uiv", [](GLenum type, GLuint value) { gl.command##uiv(type, &value); } \
  }
#define GLARK_PACKED_VALUE(command, value_of, current)                                                  \
  {#command "ui", [](GLenum type, GLuint value) { gl.command##ui(type, value); }, value_of, current}, { \
#command "uiv", [](GLenum type, GLuint value) { gl.command##uiv(type, &value); }, value_of, current \
  }
#define GLARK_PACKED_COORDINATE(n)                                                                                  \
  {"MultiTexCoordP" #n "ui", [](GLenum type, GLuint value) { gl.MultiTexCoordP##n##ui(GL_TEXTURE1, type, value); }, \
   "gl_MultiTexCoord1 / 1024.0", GL_TEXTURE1},                                                                      \
  {                                                                                                                 \
    "MultiTexCoordP" #n "uiv",                                                                                      \
        [](GLenum type, GLuint value) { gl.MultiTexCoordP##n##uiv(GL_TEXTURE1, type, &value); },                    \
        "gl_MultiTexCoord1 / 1024.0", GL_TEXTURE1                                                                   \
  }

constexpr PackedCommand packed_commands[] = {
    GLARK_PACKED(VertexP2),
    GLARK_PACKED(VertexP3),
    GLARK_PACKED(VertexP4),
    GLARK_PACKED_VALUE(ColorP3, "gl_Color", GL_CURRENT_COLOR),
    GLARK_PACKED_VALUE(ColorP4, "gl_Color", GL_CURRENT_COLOR),
    GLARK_PACKED_VALUE(NormalP3, "vec4(gl_Normal, 0.0)", GL_CURRENT_NORMAL),
    GLARK_PACKED_VALUE(SecondaryColorP3, "gl_SecondaryColor", GL_CURRENT_SECONDARY_COLOR),
    GLARK_PACKED_VALUE(TexCoordP1, "gl_MultiTexCoord0 / 1024.0", GL_TEXTURE0),
    GLARK_PACKED_VALUE(TexCoordP2, "gl_MultiTexCoord0 / 1024.0", GL_TEXTURE0),
    GLARK_PACKED_VALUE(TexCoordP3, "gl_MultiTexCoord0 / 1024.0", GL_TEXTURE0),
    GLARK_PACKED_VALUE(TexCoordP4, "gl_MultiTexCoord0 / 1024.0", GL_TEXTURE0),
    GLARK_PACKED_COORDINATE(1),
    GLARK_PACKED_COORDINATE(2),
    GLARK_PACKED_COORDINATE(3),
    GLARK_PACKED_COORDINATE(4),
};

#undef GLARK_PACKED
#undef GLARK_PACKED_VALUE
#undef GLARK_PACKED_COORDINATE

// Components are words of ten bits, and w is 1.
GLuint packed_of(int x, int y, int z) {
  const auto word = [](int value) { return static_cast<GLuint>(value) & 1023U; };
  return word(x) | word(y) << 10 | word(z) << 20 | 1U << 30;
}

GLuint packed_turn(int turn) { return packed_of(40 + 113 * turn, 480 - 97 * turn, 130 + 71 * ((turn * 3) % 5)); }

std::vector<float> packed_current(GLenum name) {
  std::vector<float> values(4);
  if (name == GL_TEXTURE0 || name == GL_TEXTURE1) {
    gl.ActiveTexture(name);
    gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, values.data());
    gl.ActiveTexture(GL_TEXTURE0);
  } else {
    gl.GetFloatv(name, values.data());
  }
  return values;
}

void compile_packed(const std::function<void()>& commands) {
  gl.NewList(packed_list, GL_COMPILE);
  commands();
  gl.EndList();
}

void call_packed() { gl.CallList(packed_list); }

// Vertices lie from 0 to 511, which both types have.
void check_packed_vertices(Test& t, const PackedCommand& command) {
  constexpr int corners[8][2] = {{30, 20},  {60, 480},  {200, 40}, {220, 500},
                                 {330, 10}, {350, 460}, {490, 60}, {505, 440}};
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(-1, -1, 0);
  gl.Scalef(1.0F / 256, 1.0F / 256, 1.0F / 1024);
  for (const GLenum type : packed_types)
    for (const GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUAD_STRIP, GL_TRIANGLE_FAN}) {
      const auto draw = [&] {
        gl.Begin(mode);
        for (int i = 0; i < 8; ++i) {
          gl.Color3f(static_cast<float>(i) / 8, 0.4F, 1 - static_cast<float>(i % 3) / 4);
          command.set(type, packed_of(corners[i][0], corners[i][1], 90 * (i % 3)));
        }
        gl.End();
      };
      const std::string what = fmt::format("type 0x{:x}, mode {}", type, mode);
      const GLuint coarse = mode == GL_TRIANGLES ? 2 : 6;
      const PlainDraw plain = plain_draw(draw);
      expect_as_plain(t, plain, draw, what, {.coarse = coarse});
      compile_packed(draw);
      expect_as_plain(t, plain, call_packed, what + ", a list", {.coarse = coarse, .is_often = true});
    }
}

GLuint packed_program(Test& t, const PackedCommand& command) {
  return build_program(
      t, {.vertex = std::string("out vec4 colour; void main() { gl_Position = gl_Vertex;\n"
                                "  vec4 value = ") +
                    command.value + ";\n  colour = vec4(0.1 + 0.8 * abs(value.rgb) + 0.1 * value.a, 1.0); }\n"});
}

void packed_triangle(const PackedCommand& command, GLenum type, int turn, bool is_each) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    if (is_each || i == 1) command.set(type, packed_turn((turn + i) % 4));
    gl.Vertex2f(i == 1 ? 0.8F : -0.8F + 0.1F * static_cast<float>(turn), i == 2 ? 0.7F : -0.6F);
  }
  gl.End();
}

// Each vertex, or only the second, has its own value. The last one is current afterwards.
void expect_packed_within(Test& t, const PackedCommand& command, GLenum type, bool has_late_values) {
  for (const bool is_each : {true, false})
    for (int turn = 0; turn < 2; ++turn) {
      const auto draw = [&] {
        command.set(type, packed_turn(3));
        packed_triangle(command, type, turn, is_each);
      };
      const std::string what =
          fmt::format("type 0x{:x}, {}, {}", type, is_each ? "each vertex" : "the second vertex", turn);
      const PlainDraw plain = plain_draw(draw);
      const std::vector<float> left = packed_current(command.current);
      expect_as_plain(t, plain, draw, what);
      t.expect(packed_current(command.current) == left, what + ": the value that is left");
      compile_packed(draw);
      if (!is_each && !has_late_values) continue;
      expect_as_plain(t, plain, call_packed, what + ", a list", {.is_often = true});
      command.set(type, packed_turn(0));
      gl.CallList(packed_list);
      t.expect(packed_current(command.current) == left, what + ": the value that a list leaves");
    }
}

// Array draws that repeat while the current value changes, by the command itself and by a list of it.
void expect_packed_current(Test& t, const PackedCommand& command, GLenum type) {
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (int turn = 0; turn < 8; ++turn) {
    const auto set = [&command, type, turn] { command.set(type, packed_turn(turn % 4)); };
    const std::string what = fmt::format("type 0x{:x}, the current value {}", type, turn);
    set();
    const PlainDraw plain = plain_draw(draw);
    const std::vector<float> value = packed_current(command.current);
    command.set(type, packed_turn((turn + 1) % 4));
    expect_as_plain(t, plain_draw(draw), draw, what + ", before it changes", {.is_often = true});
    compile_packed(set);
    turn % 2 == 0 ? set() : call_packed();
    expect_as_plain(t, plain, draw, what);
    t.expect(packed_current(command.current) == value, what + ": the value that is read");
  }
}

// A list that has vertices alone takes the current values of each call.
void expect_packed_inherited(Test& t, const PackedCommand& command, GLenum type) {
  compile_packed([] {
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) gl.Vertex2f(i == 1 ? 0.8F : -0.8F, i == 2 ? 0.7F : -0.6F);
    gl.End();
  });
  for (int turn = 0; turn < 4; ++turn) {
    command.set(type, packed_turn(turn));
    expect_as_plain(t, plain_draw(call_packed), call_packed, fmt::format("type 0x{:x}, inherited {}", type, turn),
                    {.is_often = turn == 1});
  }
}

// Whether GL draws a list right in which a value first changes before the second vertex. Mesa 25 does not. Call it
// before ARKinit, so that GL answers, not the implementation.
bool draws_late_values(const PackedCommand& command) {
  compile_packed([&] {
    command.set(packed_types[0], packed_turn(3));
    packed_triangle(command, packed_types[0], 0, false);
  });
  return count_generated(call_packed) == 1;
}

void check_packed(Test& t, const PackedCommand& command) {
  const bool has_late_values = command.value == nullptr || draws_late_values(command);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  if (command.value == nullptr) {
    check_packed_vertices(t, command);
  } else {
    const GLfloat places[] = {-0.75F, -0.5F, 0.75F, -0.75F, 0.25F, 0.75F};
    gl.UseProgram(packed_program(t, command));
    gl.VertexPointer(2, GL_FLOAT, 0, places);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    for (const GLenum type : packed_types) {
      expect_packed_within(t, command, type, has_late_values);
      expect_packed_current(t, command, type);
      expect_packed_inherited(t, command, type);
    }
  }
  t.expect_no_error("the packed values");
}

}  // namespace

Cases packed_values_cases() {
  Cases cases;
  for (const PackedCommand& command : packed_commands)
    cases.push_back({.name = fmt::format("ark.command.packed.{}", leaf_of_command(command.leaf)),
                     .clauses = {"10.R.2-1", "11.R.13-1"},
                     .plan =
                         "Give vertices, their attributes and current values by this command, with both packed types, "
                         "directly and in lists. Compare pictures, counts and current values with the unrefined ones.",
                     .wrong = "A vertex is not counted; a draw that repeats keeps an earlier value.",
                     .apis = compat_only,
                     .check = [&command](Test& t) { check_packed(t, command); }});
  return cases;
}

}  // namespace glark::conformance
