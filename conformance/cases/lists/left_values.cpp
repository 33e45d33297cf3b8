// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every current value that a list of triangles leaves behind, at the first call and after many: an implementation that
// keeps the list's triangles need not execute its commands again, but has to set what they set.
#include <fmt/core.h>

#include <array>
#include <functional>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr GLuint leaving_list = 61;
constexpr GLuint calling_list = 62;
constexpr GLuint outer_calling_list = 63;

// A command that sets a current value: 0 to 3 are different values.
struct LeftValue {
  const char* leaf;
  void (*set)(int turn);
  std::vector<float> (*read)();
  bool shows = true;  // in the picture of draw_after()
};

float part_of(int turn, int component) { return static_cast<float>((3 * turn + 2 * component + 1) % 8) / 8; }
GLubyte byte_of(int turn, int component) { return static_cast<GLubyte>(32 * ((3 * turn + 2 * component + 1) % 8)); }

template <GLenum name, std::size_t count>
std::vector<float> floats_of() {
  std::vector<float> values(count);
  gl.GetFloatv(name, values.data());
  return values;
}

template <GLuint unit>
std::vector<float> coordinates_of() {
  std::vector<float> values(4);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, values.data());
  gl.ActiveTexture(GL_TEXTURE0);
  return values;
}

template <GLuint unit>
LeftValue left_coordinate(const char* leaf) {
  return {
      leaf,
      [](int turn) { gl.MultiTexCoord3f(GL_TEXTURE0 + unit, part_of(turn, 0), part_of(turn, 1), part_of(turn, 2)); },
      coordinates_of<unit>};
}

template <GLuint attribute>
std::vector<float> attribute_of() {
  return current_value(attribute);
}

template <GLenum face, GLenum parameter, std::size_t count>
LeftValue left_material(const char* leaf) {
  return {leaf,
          [](int turn) {
            const GLfloat value[] = {part_of(turn, 0) * (count == 1 ? 64 : 1), part_of(turn, 1), part_of(turn, 2), 1};
            gl.Materialfv(face, parameter, value);
          },
          [] {
            std::vector<float> values(4 * count);
            gl.GetMaterialfv(face == GL_BACK ? GL_BACK : GL_FRONT,
                             parameter == GL_AMBIENT_AND_DIFFUSE ? GL_DIFFUSE : parameter, values.data());
            return values;
          }};
}

std::vector<LeftValue> left_colours() {
  return {
      {"color", [](int turn) { gl.Color3f(part_of(turn, 0), part_of(turn, 1), part_of(turn, 2)); },
       floats_of<GL_CURRENT_COLOR, 4>},
      {"color_4ub", [](int turn) { gl.Color4ub(byte_of(turn, 0), byte_of(turn, 1), byte_of(turn, 2), 255); },
       floats_of<GL_CURRENT_COLOR, 4>},
      {"secondary_color", [](int turn) { gl.SecondaryColor3f(part_of(turn, 0), part_of(turn, 1), part_of(turn, 2)); },
       floats_of<GL_CURRENT_SECONDARY_COLOR, 4>},
      {"secondary_color_3ub",
       [](int turn) { gl.SecondaryColor3ub(byte_of(turn, 0), byte_of(turn, 1), byte_of(turn, 2)); },
       floats_of<GL_CURRENT_SECONDARY_COLOR, 4>},
      {"fog_coordinate", [](int turn) { gl.FogCoordf(part_of(turn, 0)); }, floats_of<GL_CURRENT_FOG_COORD, 1>},
      {"fog_coordinate_d", [](int turn) { gl.FogCoordd(part_of(turn, 0)); }, floats_of<GL_CURRENT_FOG_COORD, 1>},
      {"normal", [](int turn) { gl.Normal3f(part_of(turn, 0), part_of(turn, 1), part_of(turn, 2)); },
       floats_of<GL_CURRENT_NORMAL, 3>},
      {"normal_3b",
       [](int turn) {
         gl.Normal3b(static_cast<GLbyte>(byte_of(turn, 0) / 2), static_cast<GLbyte>(byte_of(turn, 1) / 2), 12);
       },
       floats_of<GL_CURRENT_NORMAL, 3>},
      {"edge_flag", [](int turn) { gl.EdgeFlag(turn % 2 == 0 ? GL_TRUE : GL_FALSE); }, floats_of<GL_EDGE_FLAG, 1>,
       false},
      {"index", [](int turn) { gl.Indexf(static_cast<GLfloat>(turn + 2)); }, floats_of<GL_CURRENT_INDEX, 1>, false},
  };
}

std::vector<LeftValue> left_coordinates() {
  return {
      {"coordinate",
       [](int turn) { gl.TexCoord4f(part_of(turn, 0), part_of(turn, 1), part_of(turn, 2), part_of(turn, 3)); },
       coordinates_of<0>},
      {"coordinate_1", [](int turn) { gl.TexCoord1f(part_of(turn, 0)); }, coordinates_of<0>},
      left_coordinate<1>("coordinate_of_unit_1"),
      left_coordinate<2>("coordinate_of_unit_2"),
      left_coordinate<3>("coordinate_of_unit_3"),
      left_coordinate<4>("coordinate_of_unit_4"),
      left_coordinate<5>("coordinate_of_unit_5"),
      left_coordinate<6>("coordinate_of_unit_6"),
      left_coordinate<7>("coordinate_of_unit_7"),
  };
}

std::vector<LeftValue> left_attributes() {
  return {
      {"attribute_1f", [](int turn) { gl.VertexAttrib1f(6, part_of(turn, 0)); }, attribute_of<6>},
      {"attribute_4f",
       [](int turn) { gl.VertexAttrib4f(6, part_of(turn, 0), part_of(turn, 1), part_of(turn, 2), part_of(turn, 3)); },
       attribute_of<6>},
      {"attribute_4nub",
       [](int turn) { gl.VertexAttrib4Nub(7, byte_of(turn, 0), byte_of(turn, 1), byte_of(turn, 2), 255); },
       attribute_of<7>},
      {"attribute_2s",
       [](int turn) { gl.VertexAttrib2s(7, static_cast<GLshort>(turn % 2), static_cast<GLshort>(turn / 2)); },
       attribute_of<7>},
      {"unread_attribute", [](int turn) { gl.VertexAttrib3f(12, part_of(turn, 0), part_of(turn, 1), 2); },
       attribute_of<12>, false},
      {"depth_tag", [](int turn) { gl.DepthTag1i(static_cast<GLuint>(turn)); }, [] { return current_value(15); },
       false},
  };
}

std::vector<LeftValue> left_materials() {
  return {
      left_material<GL_FRONT, GL_AMBIENT, 1>("front_ambient"),
      left_material<GL_BACK, GL_DIFFUSE, 1>("back_diffuse"),
      left_material<GL_FRONT_AND_BACK, GL_SPECULAR, 1>("specular"),
      left_material<GL_FRONT, GL_EMISSION, 1>("front_emission"),
      left_material<GL_BACK, GL_SHININESS, 1>("back_shininess"),
      left_material<GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, 1>("ambient_and_diffuse"),
  };
}

void corner_of_list(int i) { gl.Vertex2f(i == 1 ? 0.6F : -0.6F, i == 2 ? 0.6F : -0.5F); }

// Where the list sets the value, and what it leaves: one of the values 1 to 3. Mesa 22.3 loses what a list sets between the
// last vertex and End.
struct LeavingPlace {
  const char* name;
  int left;
  void (*commands)(const LeftValue& value);
};

template <typename Before>
void list_triangle(Before before_corner) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    before_corner(i);
    corner_of_list(i);
  }
  gl.End();
}

constexpr LeavingPlace leaving_places[] = {
    {"for each vertex", 3, [](const LeftValue& v) { list_triangle([&](int i) { v.set(i + 1); }); }},
    {"for the first vertex", 2,
     [](const LeftValue& v) {
       list_triangle([&](int i) {
         if (i == 0) v.set(2);
       });
     }},
    {"for the second vertex", 1,
     [](const LeftValue& v) {
       list_triangle([&](int i) {
         if (i == 1) v.set(1);
       });
     }},
    {"before Begin", 2,
     [](const LeftValue& v) {
       v.set(2);
       list_triangle([](int) {});
     }},
    {"after End", 3,
     [](const LeftValue& v) {
       list_triangle([&](int i) { v.set(2 - i % 2); });
       v.set(3);
     }},
    {"in the first of two", 2,
     [](const LeftValue& v) {
       list_triangle([&](int i) { v.set(i == 2 ? 2 : 3); });
       list_triangle([](int) {});
     }},
};

// A program whose picture shows the current values.
GLuint value_program(Test& t) {
  return build_program(
      t, {.vertex = "layout(location = 6) in vec4 sixth; layout(location = 7) in vec4 seventh; out vec4 colour;\n"
                    "void main() { vec3 sum = gl_Color.rgb + gl_SecondaryColor.rgb + 0.5 * gl_Normal\n"
                    "  + vec3(gl_FogCoord, 0.0, 0.0) + sixth.rgb + seventh.rgb;\n"
                    "  sum += gl_MultiTexCoord0.rgb + gl_MultiTexCoord1.rgb + gl_MultiTexCoord2.rgb;\n"
                    "  sum += gl_MultiTexCoord3.rgb + gl_MultiTexCoord4.rgb + gl_MultiTexCoord5.rgb;\n"
                    "  sum += gl_MultiTexCoord6.rgb + gl_MultiTexCoord7.rgb;\n"
                    "  colour = vec4(sum / 3.0, 1.0); gl_Position = gl_Vertex; }\n"});
}

// The fixed function, whose picture shows materials and normals.
void use_lights() {
  gl.UseProgram(0);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
}

// Arrays give it vertices alone.
void draw_after() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// An implementation knows only the values that it has seen.
void set_all_values() {
  gl.Color3f(1, 1, 1);
  gl.SecondaryColor3f(0, 0, 0);
  gl.FogCoordf(0);
  gl.Normal3f(0, 0, 1);
  for (GLenum unit = 0; unit < 8; ++unit) gl.MultiTexCoord2f(GL_TEXTURE0 + unit, 0, 0);
  for (const GLuint attribute : {6U, 7U}) gl.VertexAttrib4f(attribute, 0, 0, 0, 1);
  gl.DepthTag1i(1);
}

struct LeavingCall {
  const char* name;
  void (*call)();
};
constexpr LeavingCall leaving_calls[] = {{"CallList", [] { gl.CallList(leaving_list); }},
                                         {"CallLists",
                                          [] {
                                            const GLubyte names[] = {leaving_list};
                                            gl.CallLists(1, GL_UNSIGNED_BYTE, names);
                                          }},
                                         {"a list", [] { gl.CallList(calling_list); }},
                                         {"a list of lists", [] { gl.CallList(outer_calling_list); }}};

void compile_leaving_lists(const LeftValue& value, const LeavingPlace& place) {
  const GLuint name = calling_list;
  gl.NewList(leaving_list, GL_COMPILE);
  place.commands(value);
  gl.EndList();
  gl.NewList(calling_list, GL_COMPILE);
  gl.CallList(leaving_list);
  gl.EndList();
  gl.NewList(outer_calling_list, GL_COMPILE);
  gl.CallLists(1, GL_UNSIGNED_INT, &name);
  gl.EndList();
}

// What the value and the picture are where the application sets it.
struct LeftExpected {
  std::vector<float> value;
  Picture picture;
};

LeftExpected set_without_list(const LeftValue& value, int turn) {
  gl.Disable(GL_ARK);
  value.set(turn);
  LeftExpected expected{value.read(), picture_of(draw_after)};
  gl.Enable(GL_ARK);
  return expected;
}

void expect_left(Test& t, const LeftValue& value, const LeftExpected& expected, const std::function<void()>& call,
                 const std::string& what) {
  // Nothing is asked at first: an implementation may learn from it.
  for (int again = 0; again < 4; ++again) {
    value.set(0);
    call();
    if (value.shows)
      t.expect_same_picture(picture_of(draw_after), expected.picture, what + ": the draw after it", 2, 40);
    if (again == 1) repeat_often(call);
  }
  for (int again = 0; again < 2; ++again) {
    value.set(0);
    call();
    t.expect(value.read() == expected.value, what + ": the value that is left");
  }
}

void check_left_value(Test& t, const LeftValue& value) {
  gl.UseProgram(value_program(t));
  const GLfloat places[] = {-0.75F, -0.5F, 0.75F, -0.75F, 0.25F, 0.75F};
  gl.VertexPointer(2, GL_FLOAT, 0, places);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.ARKinit(3);
  gl.Enable(GL_ARK);
  std::size_t turn = 0;
  for (const bool is_fixed : {false, true}) {
    if (is_fixed) use_lights();
    for (const LeavingPlace& place : leaving_places) {
      const LeftExpected expected = set_without_list(value, place.left);
      compile_leaving_lists(value, place);
      set_all_values();
      for (const std::size_t next : {turn % 4, (turn + 2) % 4})
        expect_left(t, value, expected, leaving_calls[next].call,
                    fmt::format("set {}, called by {}", place.name, leaving_calls[next].name));
      ++turn;
    }
  }
  gl.NewList(leaving_list, GL_COMPILE_AND_EXECUTE);
  leaving_places[0].commands(value);
  gl.EndList();
  const std::vector<float> left = value.read();
  t.expect(left == set_without_list(value, leaving_places[0].left).value, "the value that COMPILE_AND_EXECUTE leaves");
  t.expect_no_error("the calls");
}

}  // namespace

Cases left_values_cases() {
  static const std::array<std::vector<LeftValue>, 4> tables = {left_colours(), left_coordinates(), left_attributes(),
                                                               left_materials()};
  Cases cases;
  for (const std::vector<LeftValue>& table : tables)
    for (const LeftValue& value : table)
      cases.push_back({.name = fmt::format("ark.list.left.{}", value.leaf),
                       .clauses = {"10.R.2-1", "11.R.13-1", "chapter-21-2"},
                       .plan =
                           "A list of triangles sets this current value before, between or after its vertices. Call "
                           "it once and often, in several ways: each call leaves the last value.",
                       .wrong = "A list whose triangles are kept leaves the value from before the call.",
                       .apis = compat_only,
                       .check = [&value](Test& t) { check_left_value(t, value); }});
  return cases;
}

}  // namespace glark::conformance
