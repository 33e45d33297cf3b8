// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Types of GLSL, as far as the analysis of a vertex stage needs them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glark::refine {

enum class BasicType { none, floating, integer, opaque, structure };  // truth values are integers
enum class StorageClass { local, global, input, output, inout, uniform, buffer };

struct TypeMember;

struct Type {
  BasicType basic = BasicType::none;
  StorageClass storage = StorageClass::local;
  std::size_t vector_size = 0;  // 0 unless it is a vector
  bool matrix = false;
  bool array = false;
  std::vector<TypeMember> members;  // of a structure or a block

  bool is_structure() const { return basic == BasicType::structure; }
  bool is_vector() const { return vector_size > 0; }
  // The components of a vector can be told apart, unless the vector is an element of an array.
  bool has_components() const { return is_vector() && !array; }
  std::optional<std::size_t> member(std::string_view name) const;
};

struct TypeMember {
  std::string name;
  Type type;
};

// Reads a type as glslang writes it: " smooth out 4-component vector of float".
Type read_type(std::string_view text);

}  // namespace glark::refine
