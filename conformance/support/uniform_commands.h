// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// All commands that set a uniform, as a table: Uniform* and ProgramUniform* for each type, single values and arrays.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

inline constexpr std::size_t elements_of_array = 3;    // of each array
inline constexpr std::size_t numbers_of_element = 16;  // room for an element
using UniformNumbers = std::array<double, elements_of_array * numbers_of_element>;

struct UniformCommand {
  const char* name;  // "ProgramUniformMatrix3x2fv"
  std::string type;  // "mat3x2"
  int columns;       // 1 if it is no matrix
  int rows;
  bool takes_count;
  // Sets `count` elements from `location` to the numbers, which have no gaps.
  void (*set)(GLuint program, GLint location, GLsizei count, const double* numbers);

  int components() const { return columns * rows; }
  // A component of an element in GLSL: "value[1][0][2]".
  std::string component(const std::string& element, int number) const;
};

const std::vector<UniformCommand>& uniform_commands();
// The names of all types, each once.
std::vector<std::string> types_of_uniforms();
bool is_double_type(const std::string& type);

}  // namespace glark::conformance
