// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a random program has to work with: objects whose contents make every read of every draw defined.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "conformance/random/values.h"
#include "conformance/support/program.h"

namespace glark::conformance {

// `stage`: a vertex shader that is affine in its inputs. `curved`: one that is not. `uniforms`: an affine one with uniforms of
// all types. It is apart, because an implementation may compile a program again for each format of its inputs.
// `fixed`: the fixed function.
// Refined outputs give the unrefined picture in all of them. Refined inputs, and curved triangles that are flat, do so
// where the stage is affine.
enum class WorldKind { stage, curved, uniforms, fixed, polygons };

inline constexpr int drawn_vertices = 48;   // with different places: 16 triangles side by side
inline constexpr GLsizei place_bytes = 48;  // a vertex of World::places
inline constexpr GLintptr normal_offset = 16, tag_offset = 28, byte_tag_offset = 32, short_tag_offset = 36,
                          integer_tag_offset = 40;
inline constexpr GLuint at_integers = 7, at_columns = 8, at_doubles = 10;  // the matrix has 8 and 9
inline constexpr GLuint spare_binding = 12;                                // no attribute has this number
inline constexpr std::array<GLuint, 4> float_attributes = {at_colour, at_extra, at_columns, at_columns + 1};
inline constexpr GLintptr restart_bytes = 512, short_indices = 1024, integer_indices = 2048;  // in World::elements

struct World {
  World(Test& test, WorldKind kind);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  bool is_fixed() const { return kind == WorldKind::fixed || kind == WorldKind::polygons; }
  bool is_affine() const { return kind == WorldKind::stage || kind == WorldKind::uniforms; }
  bool is_desktop() const { return !t.is_gles(); }
  GLuint any_float_attribute();
  GLuint any_buffer() { return data[values.below(data.size())]; }
  GLuint any_program() { return programs[values.below(programs.size())]; }
  // The program that is in use, by itself or as a part of the bound pipeline.
  GLuint program_in_use() const;

  Test& t;
  WorldKind kind;
  Values values{0};
  std::array<GLuint, 3> data{};       // values of inputs: floats that are also fine bytes, shorts and halves
  std::array<GLuint, 2> doubles{};    // the same as doubles
  std::array<GLuint, 2> places{};     // positions, normals and tags
  std::array<GLuint, 3> arrays{};     // vertex array objects
  std::array<GLuint, 2> programs{};   // with the same inputs and uniforms, but other colours
  std::array<GLuint, 2> pipelines{};  // of these programs
  std::array<GLuint, 2> queries{};    // with results: nothing passed, something passed
  std::array<GLuint, 2> textures{};
  GLuint blocks = 0;               // a buffer of uniform blocks
  GLuint elements = 0;             // as bytes, shorts and integers
  GLuint commands = 0;             // of indirect draws
  GLuint captured = 0;             // what feedback captures
  std::vector<float> memory = {};  // what client arrays read
  std::vector<std::uint8_t> places_memory = {};
  std::vector<GLushort> elements_memory = {};

 private:
  void make_data();
  void make_elements();
  void make_programs();
  void make_arrays();
  void make_queries();
  void make_fixed();
};

// The depth tags in the first of World::places, if the array of tags has this type; -1 for other types.
int tag_of_type(GLenum type);

// Enables the arrays of positions, normals and tags in the bound vertex array.
void point_at_places(const World& w, std::size_t which);

}  // namespace glark::conformance
