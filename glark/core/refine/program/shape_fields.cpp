// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program/shape_fields.h"

#include <algorithm>

#include "glark/core/capture/layout.h"

namespace glark::refine {
namespace {

bool is_vector(const capture::Field& field, bool of_two) {
  return !field.is_array &&
         (field.type == GL_FLOAT_VEC3 || field.type == GL_FLOAT_VEC4 || (of_two && field.type == GL_FLOAT_VEC2));
}

// Returns the field at that attribute location. Adds one if the vertex stage reads no input there. Returns -1 if there
// is no location, or if the input is not a vector that can stand for `type`.
int field_at(std::vector<capture::Field>& fields, int location, GLenum type, const char* name) {
  if (location < 0) return -1;
  const auto covers = [&](const capture::Field& field) {
    return field.location >= 0 && field.location <= location &&
           location < field.location + capture::columns_of(field.type) * field.array_size;
  };
  const auto found = std::find_if(fields.begin(), fields.end(), covers);
  if (found == fields.end()) {
    fields.push_back({.name = name, .type = type, .location = location, .unread = true});
    return static_cast<int>(fields.size()) - 1;
  }
  return is_vector(*found, type == GL_FLOAT_VEC2) ? static_cast<int>(found - fields.begin()) : -1;
}

// Fixed-function draws always have the inputs of displacement, even if the current state does not make the stage read
// them.
void add_conventional_inputs(std::vector<capture::Field>& fields) {
  const capture::Field inputs[] = {
      {.name = "gl_Normal", .type = GL_FLOAT_VEC3, .role = capture::Role::normal},
      {.name = "gl_MultiTexCoord0", .type = GL_FLOAT_VEC4, .role = capture::Role::texture_coordinate}};
  for (const capture::Field& input : inputs) {
    const bool present = std::any_of(fields.begin(), fields.end(),
                                     [&](const capture::Field& field) { return field.name == input.name; });
    if (!present) fields.push_back(input);
  }
}

// The normals of the mesh: those that another pass over it reads, or normals from positions. In the second case, a
// normal of the vertex stage is the same for all vertices.
void add_normal(std::vector<capture::Field>& fields, const core::DerivedKey& key) {
  if (key.normal_attribute == core::own_normal || key.at_corner) return;
  capture::Field normal{.name = "gl_Normal", .type = GL_FLOAT_VEC3, .role = capture::Role::normal};
  if (key.normal_attribute != core::conventional_normal) {
    normal.name = "glark_normal";
    normal.made = key.normal_attribute == core::made_normal;
    normal.location = normal.made ? -1 : key.normal_attribute;
  }
  for (capture::Field& field : fields) {
    const bool replaced = normal.made && field.role == capture::Role::normal;
    field.role = replaced ? capture::Role::other : field.role;
  }
  fields.push_back(normal);
}

int coordinate_field(std::vector<capture::Field>& fields, const core::DerivedKey& key) {
  if (!key.displaced || key.at_corner) return -1;
  if (key.coordinate_attribute >= 0) {
    return field_at(fields, key.coordinate_attribute, GL_FLOAT_VEC2, "glark_coordinate");
  }
  const auto found = std::find_if(fields.begin(), fields.end(), [](const capture::Field& field) {
    return field.role == capture::Role::texture_coordinate && is_vector(field, true);
  });
  return found != fields.end() ? static_cast<int>(found - fields.begin()) : -1;
}

}  // namespace

void add_shape_fields(std::vector<capture::Field>& fields, const core::DerivedKey& key, bool fixed_function,
                      DeriveRequest& request) {
  if (key.displaced && fixed_function) add_conventional_inputs(fields);
  add_normal(fields, key);
  request.discontinuity_field = field_at(fields, key.discontinuity_attribute, GL_FLOAT_VEC4, "glark_discontinuity");
  request.scalar_tag_field = field_at(fields, key.scalar_tag_attribute, GL_FLOAT_VEC3, "glark_scalar_tags");
  request.coordinate_field = coordinate_field(fields, key);
}

core::SurfaceWords surface_words(const capture::Layout& layout, const core::ShapeFields& fields) {
  const auto word_of = [&](int field) {
    return field >= 0 ? layout.fields[static_cast<std::size_t>(field)].offset : -1;
  };
  const capture::Field* const position = capture::find_role(layout.fields, capture::Role::position);
  core::SurfaceWords words{.position = position != nullptr ? position->offset : -1,
                           .normal = capture::normal_offset(layout.fields),
                           .discontinuity = word_of(fields.discontinuity),
                           .scalar_tags = word_of(fields.scalar_tags),
                           .coordinate = word_of(fields.coordinate)};
  for (std::size_t i = 0; i < layout.fields.size(); ++i) {
    words.unread |= std::uint64_t{layout.fields[i].unread} << i;
  }
  return words;
}

}  // namespace glark::refine
