// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/programs/compute_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "glark/core/objects/programs/shader.h"

namespace glark::core {
namespace {

constexpr std::uint32_t most_groups = 65535;  // the least GL_MAX_COMPUTE_WORK_GROUP_COUNT that GL and ES allow

std::string full_source(const ComputeText& text) {
  std::string source = text.es ? "#version 320 es\nprecision highp float;\nprecision highp int;\n" : "#version 430\n";
  for (const ComputeText::Define& define : text.defines) {
    source += fmt::format("#define {} {}\n", define.name, define.value);
  }
  return source.append(text.source);
}

}  // namespace

bool ComputePass::build(const gl::Dispatch& gl, const ComputeText& text, std::span<const char* const> uniforms) {
  std::string error;
  const GLuint program = gl.CreateProgram();
  const GLuint shader = compile_shader(gl, GL_COMPUTE_SHADER, full_source(text), error);
  if (!link_program(gl, program, {&shader, 1}, error)) {
    failed_ = true;
    log(text.failure, fmt::format("{} cannot be built: {}", text.what, error));
    return false;
  }
  program_ = program;
  locations_.clear();
  integers_.assign(uniforms.size(), 0);  // as GL initialises uniforms
  for (const char* name : uniforms) {
    locations_.push_back(gl.GetUniformLocation(program, name));
  }
  return true;
}

void ComputePass::release(const gl::Dispatch& gl) {
  gl.DeleteProgram(program_);
  program_ = 0;
  failed_ = false;
  locations_.clear();
}

void ComputePass::set_integers(const gl::Dispatch& gl, std::span<const GLint> values) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (locations_[i] >= 0 && integers_[i] != values[i]) {
      gl.Uniform1i(locations_[i], values[i]);
      integers_[i] = values[i];
    }
  }
}

void ComputePass::dispatch(const gl::Dispatch& gl, std::uint32_t invocations) {
  const std::uint32_t groups = (invocations + group_size - 1) / group_size;
  gl.DispatchCompute(std::min(groups, most_groups), (groups + most_groups - 1) / most_groups, 1);
}

}  // namespace glark::core
