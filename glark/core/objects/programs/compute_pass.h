// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A compute program with its uniforms.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "glark/core/report/log.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

struct ComputeText {
  struct Define {
    std::string_view name;
    std::uint64_t value = 0;
  };

  std::string_view what;    // names the pass in the log: "a binning pass"
  std::string_view source;  // GLSL without #version
  bool es = false;          // for an OpenGL ES context
  std::vector<Define> defines = {};
  LogLevel failure = LogLevel::error;  // the level of the log line if the pass cannot be built
};

class ComputePass {
 public:
  static constexpr std::uint32_t group_size = 64;  // local_size_x of every shader that dispatch() runs

  // Compiles and links, and looks up `uniforms`. Returns false and logs the program's log if that fails. Rare path:
  // wrap in an ErrorScope.
  bool build(const gl::Dispatch& gl, const ComputeText& text, std::span<const char* const> uniforms);
  bool built() const { return program_ != 0; }
  bool failed() const { return failed_; }  // the last build()
  void release(const gl::Dispatch& gl);

  void use(const gl::Dispatch& gl) const { gl.UseProgram(program_); }
  // -1: the linker has removed the uniform.
  GLint location(std::size_t uniform) const { return locations_[uniform]; }
  // Sets the first uniforms, which are integers, where they differ from the last values. The pass must be in use.
  void set_integers(const gl::Dispatch& gl, std::span<const GLint> values) const;

  // Dispatches at least `invocations` in groups of group_size. Groups beyond the guaranteed limit go to the second
  // dimension.
  static void dispatch(const gl::Dispatch& gl, std::uint32_t invocations);

 private:
  GLuint program_ = 0;
  bool failed_ = false;
  std::vector<GLint> locations_;
  mutable std::vector<GLint> integers_;  // the values that GL has
};

}  // namespace glark::core
