// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace glark::core {

// A shader of the application, or one derived from it, for the shader sink.
struct ShownShader {
  std::uint64_t hash = 0;  // names the application's program
  unsigned program = 0;    // its name in GL; 0: fixed function
  std::string_view stage;  // "vert", "frag" ...
  std::string_view kind;   // "original", "linear", "pn-tagged" ...
  unsigned object = 0;     // number of the shader object in its stage
  std::string_view source;
};
using ShaderSink = void (*)(const ShownShader& shader);
void set_shader_sink(ShaderSink sink);
bool wants_shaders();
void show_shader(const ShownShader& shader);

}  // namespace glark::core
