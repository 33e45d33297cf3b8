// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Arrays of texture coordinates of the units beyond 0, which the client's active unit or an argument names.
#include <fmt/core.h>

#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"

namespace glark::conformance {
namespace {

constexpr GLuint coordinate_units = 8;
constexpr std::size_t coordinate_sets = 3;

// The places of a triangle, and coordinates of three sets for each unit.
struct CoordinateData {
  std::array<Vec3, 3> places = {{{-0.45F, -0.4F, 0}, {0.5F, -0.35F, 0}, {-0.1F, 0.5F, 0}}};
  std::array<std::array<std::array<Vec2, 3>, coordinate_sets>, coordinate_units> sets{};
  std::array<std::array<std::array<float, 5>, 3>, coordinate_units> interleaved{};  // T2F_V3F
};

CoordinateData coordinate_data() {
  CoordinateData data;
  constexpr float corners[3][3][2] = {
      {{0, 0}, {1, 0}, {0, 1}}, {{1, 0.1F}, {0.9F, 1}, {0.1F, 0.2F}}, {{0.1F, 1}, {0.2F, 0}, {1, 0.9F}}};
  for (std::size_t unit = 0; unit < coordinate_units; ++unit)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t set = 0; set < coordinate_sets; ++set)
        for (std::size_t k = 0; k < 2; ++k)
          data.sets[unit][set][corner][k] = 0.2F + 0.6F * corners[(set + unit) % 3][corner][k];
      const Vec2& third = data.sets[unit][2][corner];
      const Vec3& place = data.places[corner];
      data.interleaved[unit][corner] = {third[0], third[1], place[0], place[1], place[2]};
    }
  return data;
}

struct CoordinateScene {
  CoordinateData data = coordinate_data();
  GLuint buffer = 0;
  GLuint arrays = 0;  // a vertex array object
  bool is_in_memory = false;

  const void* address(const void* of) const {
    if (is_in_memory) return of;
    return reinterpret_cast<const void*>(static_cast<const char*>(of) - reinterpret_cast<const char*>(&data));
  }
  const void* set(GLuint unit, std::size_t number) const { return address(&data.sets[unit][number]); }
  GLintptr offset(GLuint unit, std::size_t number) const {
    return reinterpret_cast<const char*>(&data.sets[unit][number]) - reinterpret_cast<const char*>(&data);
  }
};

// All arrays of the bound vertex array object.
void reset_coordinates(const CoordinateScene& s) {
  gl.BindBuffer(GL_ARRAY_BUFFER, s.is_in_memory ? 0 : s.buffer);
  gl.VertexPointer(3, GL_FLOAT, 0, s.address(&s.data.places));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  for (GLuint unit = 0; unit < coordinate_units; ++unit) {
    gl.ClientActiveTexture(GL_TEXTURE0 + unit);
    gl.TexCoordPointer(2, GL_FLOAT, 0, s.set(unit, 0));
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.MultiTexCoord2f(GL_TEXTURE0 + unit, 0.75F, unit % 2 == 0 ? 0.8F : 0.25F);
  }
  gl.ClientActiveTexture(GL_TEXTURE0);
}

struct CoordinateStep {
  void (*change)(const CoordinateScene& s, GLuint unit);
  bool shows = true;
};

struct CoordinateChange {
  const char* leaf;
  std::vector<CoordinateStep> steps;
  bool is_direct = false;     // by EXT_direct_state_access
  bool needs_buffer = false;  // the command takes no client memory
};

using Scenery = const CoordinateScene&;
void select_unit(GLuint unit) { gl.ClientActiveTexture(GL_TEXTURE0 + unit); }
void disable_unit(Scenery, GLuint unit) {
  select_unit(unit);
  gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
}
void enable_unit(Scenery, GLuint unit) {
  select_unit(unit);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
}
void point_unit(Scenery s, GLuint unit) {
  select_unit(unit);
  gl.TexCoordPointer(2, GL_FLOAT, 0, s.set(unit, 1));
}

std::vector<CoordinateChange> client_coordinate_changes() {
  return {
      {"client_state", {{disable_unit}, {enable_unit}}},
      {"client_state_elsewhere",
       {{[](Scenery s, GLuint unit) {
          disable_unit(s, unit);
          select_unit((unit + 3) % coordinate_units);
        }},
        {[](Scenery s, GLuint unit) {
          enable_unit(s, unit);
          select_unit((unit + 5) % coordinate_units);
        }}}},
      {"pointer", {{point_unit}}},
      {"pointer_of_three", {{[](Scenery s, GLuint unit) {
         select_unit(unit);
         gl.TexCoordPointer(2, GL_FLOAT, 20, s.address(&s.data.interleaved[unit]));
       }}}},
      {"current_value",
       {{disable_unit},
        {[](Scenery, GLuint unit) { gl.MultiTexCoord2f(GL_TEXTURE0 + unit, 0.3F, 0.55F); }},
        {[](Scenery, GLuint unit) { gl.MultiTexCoord4f(GL_TEXTURE0 + unit, 0.8F, 0.3F, 0, 1); }}}},
      {"interleaved_arrays", {{[](Scenery s, GLuint unit) {
         select_unit(unit);
         gl.InterleavedArrays(GL_T2F_V3F, 0, s.address(&s.data.interleaved[unit]));
       }}}},
      {"interleaved_enables", {{disable_unit}, {[](Scenery s, GLuint unit) {
                                 select_unit(unit);
                                 gl.InterleavedArrays(GL_T2F_V3F, 0, s.address(&s.data.interleaved[unit]));
                               }}}},
      {"interleaved_disables", {{[](Scenery s, GLuint unit) {
         select_unit(unit);
         gl.InterleavedArrays(GL_V3F, 0, s.address(&s.data.places));
       }}}},
      {"pop_pointer",
       {{[](Scenery s, GLuint unit) {
          gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
          point_unit(s, unit);
        }},
        {[](Scenery, GLuint) { gl.PopClientAttrib(); }}}},
      {"pop_client_state",
       {{[](Scenery s, GLuint unit) {
          gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
          disable_unit(s, unit);
        }},
        {[](Scenery, GLuint) { gl.PopClientAttrib(); }}}},
      // PopClientAttrib restores the active unit, too.
      {"pop_active_unit",
       {{[](Scenery, GLuint unit) {
           select_unit(unit);
           gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
           select_unit((unit + 1) % coordinate_units);
         },
         false},
        {[](Scenery, GLuint) { gl.PopClientAttrib(); }, false},
        {[](Scenery, GLuint) { gl.DisableClientState(GL_TEXTURE_COORD_ARRAY); }}}},
      {"vertex_array_object",
       {{[](Scenery s, GLuint unit) {
          gl.BindVertexArray(s.arrays);
          reset_coordinates(s);
          point_unit(s, unit);
        }},
        {[](Scenery, GLuint) { gl.BindVertexArray(0); }}},
       false,
       true},
  };
}

// Commands that name the unit or the object.
std::vector<CoordinateChange> direct_coordinate_changes() {
  const auto change_of_object = [](void (*change)(Scenery, GLuint)) {
    return std::vector<CoordinateStep>{{[](Scenery s, GLuint) {
                                          gl.BindVertexArray(s.arrays);
                                          reset_coordinates(s);
                                        },
                                        false},
                                       {change}};
  };
  return {
      {"client_state_i",
       {{[](Scenery, GLuint unit) { gl.DisableClientStateiEXT(GL_TEXTURE_COORD_ARRAY, unit); }},
        {[](Scenery, GLuint unit) { gl.EnableClientStateiEXT(GL_TEXTURE_COORD_ARRAY, unit); }}},
       true},
      {"client_state_indexed",
       {{[](Scenery, GLuint unit) { gl.DisableClientStateIndexedEXT(GL_TEXTURE_COORD_ARRAY, unit); }},
        {[](Scenery, GLuint unit) { gl.EnableClientStateIndexedEXT(GL_TEXTURE_COORD_ARRAY, unit); }}},
       true},
      {"multi_pointer",
       {{[](Scenery s, GLuint unit) {
         gl.MultiTexCoordPointerEXT(GL_TEXTURE0 + unit, 2, GL_FLOAT, 0, s.set(unit, 1));
       }}},
       true},
      {"object_multi_offset", change_of_object([](Scenery s, GLuint unit) {
         gl.VertexArrayMultiTexCoordOffsetEXT(s.arrays, s.buffer, GL_TEXTURE0 + unit, 2, GL_FLOAT, 0,
                                              s.offset(unit, 1));
       }),
       true, true},
      {"object_offset", change_of_object([](Scenery s, GLuint unit) {
         select_unit(unit);
         gl.VertexArrayTexCoordOffsetEXT(s.arrays, s.buffer, 2, GL_FLOAT, 0, s.offset(unit, 1));
       }),
       true, true},
      {"object_state", change_of_object([](Scenery s, GLuint unit) {
         select_unit(unit);
         gl.DisableVertexArrayEXT(s.arrays, GL_TEXTURE_COORD_ARRAY);
       }),
       true, true},
      {"object_state_of_unit",
       change_of_object([](Scenery s, GLuint unit) { gl.DisableVertexArrayEXT(s.arrays, GL_TEXTURE0 + unit); }), true,
       true},
      {"default_attributes",
       {{[](Scenery s, GLuint) {
          gl.PushClientAttribDefaultEXT(GL_CLIENT_VERTEX_ARRAY_BIT);
          gl.BindBuffer(GL_ARRAY_BUFFER, s.is_in_memory ? 0 : s.buffer);
          gl.VertexPointer(3, GL_FLOAT, 0, s.address(&s.data.places));
          gl.EnableClientState(GL_VERTEX_ARRAY);
        }},
        {[](Scenery, GLuint) { gl.PopClientAttrib(); }}},
       true},
  };
}

// A texture whose colours change along both coordinates, added up for all units.
void use_fixed_function() {
  constexpr GLubyte texels[16] = {0, 20, 60, 255, 60, 0, 20, 255, 0, 60, 0, 255, 60, 60, 10, 255};
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  for (GLuint unit = 0; unit < coordinate_units; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    if (unit == 0) gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.Color4f(0, 0, 0, 1);
}

void use_coordinate_program(Test& t) {
  std::string sum;
  for (GLuint unit = 0; unit < coordinate_units; ++unit)
    sum += fmt::format("  colour += 0.15 * vec4(gl_MultiTexCoord{0}.st, 1.0 - gl_MultiTexCoord{0}.s, 0.0);\n", unit);
  gl.UseProgram(build_program(t, {.vertex = "out vec4 colour;\nvoid main() { colour = vec4(-0.1, -0.1, -0.1, 1.0);\n" +
                                            sum + "  gl_Position = gl_Vertex; }\n"}));
}

void check_coordinates(Test& t, const CoordinateChange& change, bool is_program) {
  if (change.is_direct && !t.has_extension("GL_EXT_direct_state_access"))
    t.not_supported("no GL_EXT_direct_state_access");
  is_program ? use_coordinate_program(t) : use_fixed_function();
  CoordinateScene s;
  gl.GenBuffers(1, &s.buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, s.buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(s.data), &s.data, GL_STATIC_DRAW);
  gl.GenVertexArrays(1, &s.arrays);
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (GLuint unit = is_program ? 2 : 1; unit < coordinate_units; unit += 2) {  // each change meets all units
    s.is_in_memory = unit % 4 < 2 && !change.needs_buffer;
    refine_uniformly(2, unit % 3 == 0 ? GL_LINEAR_INPUTS_ARK : GL_LINEAR_OUTPUTS_ARK);
    gl.BindVertexArray(0);
    reset_coordinates(s);
    Picture last = expect_as_unrefined(t, draw, fmt::format("unit {}", unit));
    for (std::size_t i = 0; i < change.steps.size(); ++i) {
      change.steps[i].change(s, unit);
      const std::string what = fmt::format("unit {} after step {}", unit, i);
      Picture next = expect_as_unrefined(t, draw, what);
      if (change.steps[i].shows) t.expect(count_different(last, next, 8) > 100, what + " shows");
      last = std::move(next);
    }
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases coordinate_arrays_cases() {
  Cases cases;
  static const auto client = client_coordinate_changes();
  static const auto direct = direct_coordinate_changes();
  for (const auto* changes : {&client, &direct})
    for (const CoordinateChange& change : *changes)
      for (const bool is_program : {false, true})
        cases.push_back(
            {.name = fmt::format("ark.draw.again.coordinates.{}.{}", change.leaf, is_program ? "program" : "fixed"),
             .clauses = {"11.R.13-1", "11.R.6-4", "10.R.2-1"},
             .plan = "Repeat a draw, change the array of texture coordinates of each unit beyond 0 in this "
                     "way, and compare with the unrefined draw.",
             .wrong = "The array of unit 0, or of the active unit, is taken for that of another unit.",
             .apis = compat_only,
             .is_optional = change.is_direct,
             .check = [&change, is_program](Test& t) { check_coordinates(t, change, is_program); }});
  return cases;
}

}  // namespace glark::conformance
