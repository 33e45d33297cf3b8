// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs of shaders, and buffers. Mistakes in shaders throw std::runtime_error with the log of the compiler.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lesson {

// Compiles and links. Attribute i gets location i.
unsigned make_program(const std::string& vertex_shader, const std::string& fragment_shader,
                      const std::vector<const char*>& attributes = {});

// Gives a program a refinement shader, and throws with its log if it does not build. Program 0 is the fixed function.
void set_refinement_shader(unsigned program, const std::string& source);

// Sets a uniform of the program in use. A uniform that is not active is ignored.
void set_uniform(unsigned program, const char* name, float value);
void set_uniform(unsigned program, const char* name, float x, float y, float z);
void set_uniform_matrix(unsigned program, const char* name, const float* columns);

// Makes a buffer, binds it to the target and fills it.
unsigned make_buffer(unsigned target, const void* data, std::size_t bytes);
template <typename Value>
unsigned make_buffer(unsigned target, const std::vector<Value>& values) {
  return make_buffer(target, values.data(), values.size() * sizeof(Value));
}

}  // namespace lesson
