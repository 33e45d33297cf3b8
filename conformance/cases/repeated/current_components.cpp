// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Each component of a current value, set by every command, between draws that repeat and read it.
#include <array>
#include <cstdlib>
#include <span>
#include <string>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

using Bits = std::array<bool, 4>;  // 1 or 0 for each component

struct Setter {
  const char* command;
  std::size_t components;
  void (*set)(const Bits& bits);
};

template <typename Number>
Number value(bool bit, double one) {
  return static_cast<Number>(bit ? one : 0);
}

GLuint packed(const Bits& bits) {
  return (bits[0] ? 0x3FFU : 0U) | (bits[1] ? 0xFFC00U : 0U) | (bits[2] ? 0x3FF00000U : 0U) |
         (bits[3] ? 0xC0000000U : 0U);
}

// A command whose last parameters are the values, and its twin with an array of them. `one`: what stands for 1. Further
// arguments of the macro come first.
#define VALUES1(type, one) value<type>(bits[0], one)
#define VALUES2(type, one) VALUES1(type, one), value<type>(bits[1], one)
#define VALUES3(type, one) VALUES2(type, one), value<type>(bits[2], one)
#define VALUES4(type, one) VALUES3(type, one), value<type>(bits[3], one)
#define SEPARATE(name, count, type, one, ...)                                             \
  {                                                                                       \
#name, count, [](const Bits& bits) { gl.name(__VA_ARGS__ VALUES##count(type, one)); } \
  }
#define ARRAY(name, count, type, one, ...)       \
  {                                              \
#name, count, [](const Bits& bits) {           \
      const type values[] = {VALUES4(type, one)}; \
      gl.name(__VA_ARGS__ values);               \
    } \
  }
#define BOTH(name, count, type, one, ...) \
  SEPARATE(name, count, type, one, __VA_ARGS__), ARRAY(name##v, count, type, one, __VA_ARGS__)
#define GENERIC(count)                                          \
  BOTH(VertexAttrib##count##d, count, GLdouble, 1, at_extra, ), \
      BOTH(VertexAttrib##count##s, count, GLshort, 1, at_extra, )
#define PACKED(count)                                                                              \
  {"VertexAttribP" #count "ui", count,                                                             \
   [](const Bits& bits) {                                                                          \
     gl.VertexAttribP##count##ui(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, packed(bits)); \
   }},                                                                                             \
  {                                                                                                \
    "VertexAttribP" #count "uiv", count, [](const Bits& bits) {                                    \
      const GLuint values = packed(bits);                                                          \
      gl.VertexAttribP##count##uiv(at_extra, GL_UNSIGNED_INT_2_10_10_10_REV, GL_TRUE, &values);    \
    }                                                                                              \
  }
#define COLOUR(name, count)                                                                                         \
  BOTH(name##b, count, GLbyte, 127), BOTH(name##s, count, GLshort, 32767), BOTH(name##i, count, GLint, 2147483647), \
      BOTH(name##ub, count, GLubyte, 255), BOTH(name##us, count, GLushort, 65535),                                  \
      BOTH(name##ui, count, GLuint, 4294967295), BOTH(name##f, count, GLfloat, 1), BOTH(name##d, count, GLdouble, 1)
#define NUMBERS(name, count, ...)                                                             \
  BOTH(name##s, count, GLshort, 1, __VA_ARGS__), BOTH(name##i, count, GLint, 1, __VA_ARGS__), \
      BOTH(name##f, count, GLfloat, 1, __VA_ARGS__), BOTH(name##d, count, GLdouble, 1, __VA_ARGS__)

constexpr Setter floats[] = {
    BOTH(VertexAttrib1f, 1, GLfloat, 1, at_extra, ), BOTH(VertexAttrib2f, 2, GLfloat, 1, at_extra, ),
    BOTH(VertexAttrib3f, 3, GLfloat, 1, at_extra, ), BOTH(VertexAttrib4f, 4, GLfloat, 1, at_extra, )};
constexpr Setter numbers[] = {GENERIC(1),
                              GENERIC(2),
                              GENERIC(3),
                              GENERIC(4),
                              ARRAY(VertexAttrib4bv, 4, GLbyte, 1, at_extra, ),
                              ARRAY(VertexAttrib4iv, 4, GLint, 1, at_extra, ),
                              ARRAY(VertexAttrib4ubv, 4, GLubyte, 1, at_extra, ),
                              ARRAY(VertexAttrib4usv, 4, GLushort, 1, at_extra, ),
                              ARRAY(VertexAttrib4uiv, 4, GLuint, 1, at_extra, )};
constexpr Setter normalized[] = {SEPARATE(VertexAttrib4Nub, 4, GLubyte, 255, at_extra, ),
                                 ARRAY(VertexAttrib4Nbv, 4, GLbyte, 127, at_extra, ),
                                 ARRAY(VertexAttrib4Nsv, 4, GLshort, 32767, at_extra, ),
                                 ARRAY(VertexAttrib4Niv, 4, GLint, 2147483647, at_extra, ),
                                 ARRAY(VertexAttrib4Nubv, 4, GLubyte, 255, at_extra, ),
                                 ARRAY(VertexAttrib4Nusv, 4, GLushort, 65535, at_extra, ),
                                 ARRAY(VertexAttrib4Nuiv, 4, GLuint, 4294967295, at_extra, ),
                                 PACKED(1),
                                 PACKED(2),
                                 PACKED(3),
                                 PACKED(4)};
constexpr Setter integers[] = {BOTH(VertexAttribI4i, 4, GLint, 1, at_extra, )};
constexpr Setter unsigned_integers[] = {BOTH(VertexAttribI4ui, 4, GLuint, 1, at_extra, )};
constexpr Setter more_integers[] = {
    BOTH(VertexAttribI1i, 1, GLint, 1, at_extra, ), BOTH(VertexAttribI2i, 2, GLint, 1, at_extra, ),
    BOTH(VertexAttribI3i, 3, GLint, 1, at_extra, ), ARRAY(VertexAttribI4bv, 4, GLbyte, 1, at_extra, ),
    ARRAY(VertexAttribI4sv, 4, GLshort, 1, at_extra, )};
constexpr Setter more_unsigned_integers[] = {
    BOTH(VertexAttribI1ui, 1, GLuint, 1, at_extra, ), BOTH(VertexAttribI2ui, 2, GLuint, 1, at_extra, ),
    BOTH(VertexAttribI3ui, 3, GLuint, 1, at_extra, ), ARRAY(VertexAttribI4ubv, 4, GLubyte, 1, at_extra, ),
    ARRAY(VertexAttribI4usv, 4, GLushort, 1, at_extra, )};
constexpr Setter colours[] = {COLOUR(Color3, 3), COLOUR(Color4, 4)};
constexpr Setter secondary_colours[] = {COLOUR(SecondaryColor3, 3)};
constexpr Setter normals[] = {BOTH(Normal3b, 3, GLbyte, 127), BOTH(Normal3s, 3, GLshort, 32767),
                              BOTH(Normal3i, 3, GLint, 2147483647), BOTH(Normal3f, 3, GLfloat, 1),
                              BOTH(Normal3d, 3, GLdouble, 1)};
constexpr Setter coordinates[] = {NUMBERS(TexCoord1, 1), NUMBERS(TexCoord2, 2), NUMBERS(TexCoord3, 3),
                                  NUMBERS(TexCoord4, 4)};
constexpr Setter unit_coordinates[] = {
    NUMBERS(MultiTexCoord1, 1, GL_TEXTURE1, ), NUMBERS(MultiTexCoord2, 2, GL_TEXTURE1, ),
    NUMBERS(MultiTexCoord3, 3, GL_TEXTURE1, ), NUMBERS(MultiTexCoord4, 4, GL_TEXTURE1, )};

struct Group {
  const char* leaf;
  std::span<const Setter> setters;
  const char* declaration;  // of the input
  const char* input;        // as a vec4
  Apis apis;
};

constexpr char floating[] = "layout(location = 6) in vec4 extra;";
constexpr char whole[] = "layout(location = 6) in ivec4 extra;";
constexpr char unsigned_whole[] = "layout(location = 6) in uvec4 extra;";
constexpr Group groups[] = {
    {"floats", floats, floating, "extra", every_api},
    {"numbers", numbers, floating, "extra", desktop_apis},
    {"normalized", normalized, floating, "extra", desktop_apis},
    {"integers", integers, whole, "vec4(extra)", every_api},
    {"more_integers", more_integers, whole, "vec4(extra)", desktop_apis},
    {"unsigned_integers", unsigned_integers, unsigned_whole, "vec4(extra)", every_api},
    {"more_unsigned_integers", more_unsigned_integers, unsigned_whole, "vec4(extra)", desktop_apis},
    {"colour", colours, "", "gl_Color", compat_only},
    {"secondary_colour", secondary_colours, "", "vec4(gl_SecondaryColor.rgb, 0.0)", compat_only},
    {"normal", normals, "", "vec4(gl_Normal, 0.0)", compat_only},
    {"coordinate", coordinates, "", "gl_MultiTexCoord0", compat_only},
    {"unit_coordinate", unit_coordinates, "", "gl_MultiTexCoord1", compat_only}};

using Colour = std::array<GLubyte, 4>;

// The triangle covers the pixel in one colour.
Colour drawn_colour() {
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  Colour colour{};
  gl.ReadPixels(2, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, colour.data());
  return colour;
}

Colour unrefined_colour() {
  gl.Disable(GL_ARK);
  const Colour colour = drawn_colour();
  gl.Enable(GL_ARK);
  return colour;
}

bool is_near(const Colour& a, const Colour& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(a[i] - b[i]) > 2) return false;
  return true;
}

void check_component(Test& t, const Setter& setter, std::size_t component) {
  Bits bits = {false, true, false, true};
  setter.set(bits);
  const Colour before = unrefined_colour();
  bool is_right = true;
  for (int again = 0; again < 3; ++again) is_right &= is_near(drawn_colour(), before);
  bits[component] = !bits[component];
  setter.set(bits);
  const Colour after = unrefined_colour();
  const std::string what = std::string(setter.command) + " of another component " + as_text(component);
  t.expect(!is_near(before, after), what + " shows without refinement");
  is_right &= is_near(drawn_colour(), after);
  t.expect(is_right, what + ": the colour is that of the unrefined draw");
}

void check_group(Test& t, const Group& group, bool is_uniform) {
  gl.UseProgram(build_program(t, {.vertex = std::string("layout(location = 0) in vec4 position; out vec4 colour;\n") +
                                            group.declaration + "\nvoid main() { vec4 value = " + group.input +
                                            ";\n  colour = vec4(0.5 * value.xyz + 0.4 * value.w, 1.0);\n"
                                            "  gl_Position = position; }\n"}));
  upload(one_triangle({1, 1, 1}));
  gl.DisableVertexAttribArray(at_extra);
  is_uniform ? refine_uniformly(1) : refine_by_tags(2);
  clear_surface();
  gl.Viewport(0, 0, 8, 8);
  for (const Setter& setter : group.setters)
    for (std::size_t component = 0; component < setter.components; ++component) check_component(t, setter, component);
  t.expect_no_error("the commands");
}

}  // namespace

Cases current_components_cases() {
  Cases cases;
  for (const Group& group : groups)
    for (const bool is_uniform : {true, false})
      cases.push_back({.name = std::string("ark.change.component.") + group.leaf + (is_uniform ? ".uniform" : ".tags"),
                       .clauses = {"11.R.6-4", "11.R.13-1"},
                       .plan = "Repeat a draw whose vertices inherit a current value, and set it by each command: only "
                               "one component is another one.",
                       .wrong = "The earlier value: the last component, or one beyond some size, is not compared.",
                       .apis = group.apis,
                       .check = [&group, is_uniform](Test& t) { check_group(t, group, is_uniform); }});
  return cases;
}

}  // namespace glark::conformance
