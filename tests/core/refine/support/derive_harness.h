// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Runs derived vertex stages in a real GL: compiles, links, feeds hand-made coarse records, reads the outputs back.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "glark/core/refine/derive.h"

namespace glark::refine::test {

enum class Api { compatibility, core, es };

// Provided by derive_osmesa.cpp or derive_egl.cpp. Makes a context current; false when there is none.
bool make_current(Api api);
void* get_proc(const char* name);

// "" when the sources compile and link (with `varyings` captured); otherwise the compiler's or linker's log.
std::string link_error(const std::vector<std::string>& sources, const std::vector<std::string>& varyings = {});

// One field of a record under construction: its values at corners 0, 1, 2, `words` each.
struct FieldValues {
  std::string name;
  GLenum type = GL_FLOAT;
  std::array<std::vector<float>, 3> corners;
  capture::Role role = capture::Role::other;
  int array_size = 1;
  bool is_array = false;
};
float bits(std::int32_t value);  // an integer as a word of the record

struct Record {
  capture::Layout layout;
  std::vector<float> words;
};
Record make_record(const std::vector<FieldValues>& fields);

struct Refined {
  std::string error;                       // of derivation or GL
  std::vector<std::vector<float>> values;  // per refined vertex: the captured varyings one after the other
};

struct Experiment {
  DeriveRequest request;  // the layout is taken from the record
  Record record;
  std::vector<std::string> varyings;
  int captured_words = 4;  // per refined vertex
  std::vector<std::array<float, 2>> lattice = {{0, 0}, {1, 0}, {0, 1}, {0.5F, 0.25F}};
  std::array<float, 4> patch = {0, 0, 1, 0};
  float shape_number = 0;  // value of the uniform
};
Refined run(const Experiment& experiment);

}  // namespace glark::refine::test
