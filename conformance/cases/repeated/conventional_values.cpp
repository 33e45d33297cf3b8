// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every command that sets a conventional current value, between draws that repeat and read it.
#include <span>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"

namespace glark::conformance {
namespace {

struct Setter {
  const char* command;
  void (*set)();
};

// A command with one, two, three or four equal values, and its twin with an array.
#define SETTER(command, ...)                  \
  {                                           \
#command, [] { gl.command(__VA_ARGS__); } \
  }
#define ARRAY(command, type, value)                          \
  {                                                          \
#command, [] {                                             \
     const type values[4] = {value, value, value, value};     \
     gl.command(values);                                      \
   } \
  }
#define UNIT_ARRAY(command, type, value)                     \
  {                                                          \
#command, [] {                                             \
     const type values[4] = {value, value, value, value};     \
     gl.command(GL_TEXTURE1, values);                         \
   } \
  }
#define ONE(name, v) SETTER(name, v)
#define TWO(name, v) SETTER(name, v, v)
#define THREE(name, v) SETTER(name, v, v, v)
#define FOUR(name, v) SETTER(name, v, v, v, v)
#define COLOURS(name, count)                                                                                    \
  count(name##b, 100), count(name##s, 30000), count(name##i, 2000000000), count(name##ub, 200),                 \
      count(name##us, 50000), count(name##ui, 3500000000U), count(name##f, 0.75F), count(name##d, 0.75),        \
      ARRAY(name##bv, GLbyte, 100), ARRAY(name##sv, GLshort, 30000), ARRAY(name##iv, GLint, 2000000000),        \
      ARRAY(name##ubv, GLubyte, 200), ARRAY(name##usv, GLushort, 50000), ARRAY(name##uiv, GLuint, 3500000000U), \
      ARRAY(name##fv, GLfloat, 0.75F), ARRAY(name##dv, GLdouble, 0.75)
#define NUMBERS(name, count)                                                                                    \
  count(name##s, 2), count(name##i, 2), count(name##f, 1.5F), count(name##d, 1.5), ARRAY(name##sv, GLshort, 2), \
      ARRAY(name##iv, GLint, 2), ARRAY(name##fv, GLfloat, 1.5F), ARRAY(name##dv, GLdouble, 1.5)
#define UNIT_ONE(name, v) SETTER(name, GL_TEXTURE1, v)
#define UNIT_TWO(name, v) SETTER(name, GL_TEXTURE1, v, v)
#define UNIT_THREE(name, v) SETTER(name, GL_TEXTURE1, v, v, v)
#define UNIT_FOUR(name, v) SETTER(name, GL_TEXTURE1, v, v, v, v)
#define UNIT_NUMBERS(name, count)                                                                                    \
  count(name##s, 2), count(name##i, 2), count(name##f, 1.5F), count(name##d, 1.5), UNIT_ARRAY(name##sv, GLshort, 2), \
      UNIT_ARRAY(name##iv, GLint, 2), UNIT_ARRAY(name##fv, GLfloat, 1.5F), UNIT_ARRAY(name##dv, GLdouble, 1.5)

constexpr Setter colours[] = {COLOURS(Color3, THREE), COLOURS(Color4, FOUR)};
constexpr Setter secondary_colours[] = {COLOURS(SecondaryColor3, THREE)};
constexpr Setter normals[] = {THREE(Normal3b, 100),
                              THREE(Normal3s, 30000),
                              THREE(Normal3i, 2000000000),
                              THREE(Normal3f, 0.75F),
                              THREE(Normal3d, 0.75),
                              ARRAY(Normal3bv, GLbyte, 100),
                              ARRAY(Normal3sv, GLshort, 30000),
                              ARRAY(Normal3iv, GLint, 2000000000),
                              ARRAY(Normal3fv, GLfloat, 0.75F),
                              ARRAY(Normal3dv, GLdouble, 0.75)};
constexpr Setter coordinates[] = {NUMBERS(TexCoord1, ONE), NUMBERS(TexCoord2, TWO), NUMBERS(TexCoord3, THREE),
                                  NUMBERS(TexCoord4, FOUR)};
constexpr Setter unit_coordinates[] = {UNIT_NUMBERS(MultiTexCoord1, UNIT_ONE), UNIT_NUMBERS(MultiTexCoord2, UNIT_TWO),
                                       UNIT_NUMBERS(MultiTexCoord3, UNIT_THREE),
                                       UNIT_NUMBERS(MultiTexCoord4, UNIT_FOUR)};
constexpr Setter fog_coordinates[] = {ONE(FogCoordf, 0.75F), ONE(FogCoordd, 0.75), ARRAY(FogCoordfv, GLfloat, 0.75F),
                                      ARRAY(FogCoorddv, GLdouble, 0.75)};

void reset() {
  gl.Color4f(0, 0, 0, 1);
  gl.SecondaryColor3f(0, 0, 0);
  gl.Normal3f(0, 0, 0);
  gl.TexCoord4f(0, 0, 0, 1);
  gl.MultiTexCoord4f(GL_TEXTURE1, 0, 0, 0, 1);
  gl.FogCoordf(0);
}

void check_setters(Test& t, std::span<const Setter> setters, bool is_uniform) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; out vec4 colour;\n"
                    "void main() {\n"
                    "  vec3 sum = gl_Color.rgb + gl_SecondaryColor.rgb + gl_Normal + gl_MultiTexCoord0.xyz +\n"
                    "    gl_MultiTexCoord1.xyz + vec3(gl_FogCoord);\n"
                    "  colour = vec4(0.1 + 0.4 * abs(sum), 1.0); gl_Position = position; }\n"}));
  upload(one_triangle({2, 2, 2}));
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (const Setter& setter : setters) {
    reset();
    expect_change(t, draw, setter.set, setter.command);
  }
}

}  // namespace

Cases conventional_values_cases() {
  struct Group {
    const char* leaf;
    std::span<const Setter> setters;
  };
  Cases cases;
  for (const Group& group : {Group{"colour", colours},
                             {"secondary_colour", secondary_colours},
                             {"normal", normals},
                             {"texture_coordinate", coordinates},
                             {"unit_coordinate", unit_coordinates},
                             {"fog_coordinate", fog_coordinates}})
    for (const bool is_uniform : {true, false})
      cases.push_back(
          {.name = std::string("ark.change.conventional.") + group.leaf + (is_uniform ? ".uniform" : ".tags"),
           .clauses = {"11.R.10-1", "11.R.13-1"},
           .plan = "Repeat a draw whose vertices inherit a current value, and set it by each command.",
           .wrong = "The earlier value.",
           .apis = compat_only,
           .check = [group, is_uniform](Test& t) { check_setters(t, group.setters, is_uniform); }});
  return cases;
}

}  // namespace glark::conformance
