// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program that was derived from a program of the application, to draw refined triangles in its place.
#pragma once

#include <atomic>
#include <compare>
#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/refinement.h"
#include "glark/gl/types.h"

namespace glark::core {

// Uniform locations from this one on are ours: they name uniforms that only the application's refinement shader
// declares.
inline constexpr GLint virtual_location_base = 0x40000000;

// Values of DerivedKey::normal_attribute besides locations.
inline constexpr int own_normal = -1;           // the input with that role
inline constexpr int conventional_normal = -2;  // glNormal and glNormalPointer, which the stage does not read
inline constexpr int made_normal = -3;          // from positions: weld/geometry_normals.h

// Selects one of the programs that are derived from a program of the application.
struct DerivedKey {
  Refinement refinement = Refinement::linear_inputs;
  int provoking_corner = 2;
  bool flat_colors = false;
  bool clamp_colors = false;
  bool tagged = false;
  bool at_corner = false;             // no refinement: gives the position of each captured corner, for measured depths
  bool at_points = false;             // gives the position of some refined vertices, for measured depths
  int discontinuity_attribute = -1;   // location of the tags; -1: vertices carry none
  int scalar_tag_attribute = -1;      // location of the tags; -1: vertices carry none
  int normal_attribute = own_normal;  // location of normals that the stage does not read
  std::uint32_t instanced = 0;        // bit i: the attribute at location i is the same at all corners of a triangle
  bool displaced = false;
  int coordinate_attribute = -1;  // of the displacement; -1: the input with that role
  bool morphing = false;          // vertices move between levels
  // Welded by position. Where there is room, the record then has:
  bool welded = false;  // the control points of curved edges
  bool border = false;  // the normals and texture coordinates that displacement takes on edges
  bool turns = false;   // the greatest turn of the normals along each edge, of all its sides
  bool placed = true;   // pieces have a placement (patch); only a uniform level of one piece a triangle needs none
  bool positions_only() const { return at_corner || at_points; }
  auto operator<=>(const DerivedKey&) const = default;
};

// The subroutines that one stage of the program in use has chosen, by the locations of its subroutine uniforms.
struct StageSubroutines {
  GLenum stage = 0;
  std::vector<GLuint> chosen;
};
using SubroutineChoice = std::vector<StageSubroutines>;

// Translates the numbers of the application's subroutines to those of a derived program.
struct SubroutineTable {
  GLenum stage = 0;
  std::vector<GLint> location_from;  // by our location: the application's location
  std::vector<GLuint> index_to;      // by the application's index: our index
};

// Where the parameters of an assembly program are in a derived program, and which of their values it has.
struct AssemblyUniforms {
  bool found = false;  // the locations are valid
  GLint environment = -1;
  GLint local = -1;
  std::vector<GLint> matrices;
  std::uint64_t environment_stamp = 0;
  std::uint64_t local_stamp = 0;
  std::uint64_t matrix_stamp = 0;
};

// Fields of a layout that shape the surface besides the position and the normal, by number. -1: there is none.
struct ShapeFields {
  int discontinuity = -1;
  int scalar_tags = -1;
  int coordinate = -1;  // of the displacement
};

// The same as first words in a corner record, for comparison. `unread` has bit i if the vertex stage does not read
// field i.
struct SurfaceWords {
  int position = -1;
  int normal = -1;
  int discontinuity = -1;
  int scalar_tags = -1;
  int coordinate = -1;
  std::uint64_t unread = 0;
  bool operator==(const SurfaceWords&) const = default;
};

// The uniforms of the application's refinement shader, and how often they were changed. Guarded by the program's mutex,
// but for the count.
struct ShapeUniforms {
  std::set<GLint> locations;  // of the application, where its program declares them, too
  std::atomic<std::uint64_t> changes{0};

  void note(GLint location) {
    if (location >= virtual_location_base || locations.contains(location)) {
      changes.fetch_add(1, std::memory_order_relaxed);
    }
  }
};

struct DerivedProgram {
  bool drawn = false;  // at the first draw, drivers compile what depends on the state
  GLuint name = 0;
  Refinement refinement = Refinement::linear_inputs;
  capture::Layout layout;
  ShapeFields shape_fields;  // of the layout
  SurfaceWords surface;      // the same
  GLint shape_number = -1;   // location of the uniform with ShapeNumber's value
  GLint height_map = -1;     // locations of the uniforms of displacement
  GLint height_channel = -1;
  GLint height_range = -1;
  GLint first_word = -1;        // location of its uniform; -1: the program reads no records from the storage block
  bool corner_outputs = false;  // some outputs come from the corners of the coarse triangle: flat or interpolated ones
  bool numbered = false;        // it reads records, and an attribute numbers its instances
  std::vector<GLint> location_of;          // by the application's location: ours, or -1
  std::vector<GLint> virtual_location_of;  // by location - virtual_location_base
  std::vector<SubroutineTable> subroutines;
  AssemblyUniforms assembly;
  std::uint64_t number = 0;                       // tells programs apart that have the same name one after the other
  std::unique_ptr<ShapeUniforms> shape_uniforms;  // null: nobody asks for their changes

  bool stored() const { return first_word >= 0; }
};

// A derived program that glUniform* calls of the application must reach, too.
struct UniformMirror {
  GLuint program = 0;
  const DerivedProgram* derived = nullptr;

  GLint location(GLint application) const {
    const auto& table = application >= virtual_location_base ? derived->virtual_location_of : derived->location_of;
    const auto index = static_cast<std::size_t>(
        application >= virtual_location_base ? application - virtual_location_base : application);
    return application >= 0 && index < table.size() ? table[index] : -1;
  }
  // The same; the application changes the uniform.
  GLint changed(GLint application) const {
    if (derived->shape_uniforms != nullptr) {
      derived->shape_uniforms->note(application);
    }
    return location(application);
  }
};

}  // namespace glark::core
