// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Program pipeline objects of the application, and ours: the same stages, with the derived program in place of the vertex stage.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "glark/gl/dispatch.h"

namespace glark::core {

// The stages before the fragments, in their order; the first is the vertex stage.
inline constexpr std::array<GLenum, 5> pipeline_stages = {
    GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER};

struct PipelineObject {
  std::array<GLuint, pipeline_stages.size()> programs{};  // by stage as above; 0: none
  GLuint active = 0;                                      // that glUniform* sets
  GLuint vertex() const { return programs.front(); }
  GLuint tessellation() const { return programs[1] != 0 ? programs[1] : programs[2]; }
};

class ProgramPipelines {
 public:
  explicit ProgramPipelines(const gl::Dispatch& gl) : gl_(gl) {}

  // What the application's pipeline holds; asked of GL after each change of it only.
  const PipelineObject& object(GLuint pipeline);
  void changed(GLuint pipeline) { objects_.erase(pipeline); }

  // A pipeline of ours like `of`, with `derived` for every stage that its vertex program gives. `epoch` tells when programs were
  // linked or deleted: what was made before then is dropped. 0 if GL refuses.
  GLuint with_derived(const PipelineObject& of, GLuint derived, std::uint64_t epoch);
  void release();

 private:
  struct Key {
    std::array<GLuint, pipeline_stages.size()> programs{};
    GLuint derived = 0;
    auto operator<=>(const Key&) const = default;
  };

  const gl::Dispatch& gl_;
  std::unordered_map<GLuint, PipelineObject> objects_;
  std::map<Key, GLuint> own_;
  std::uint64_t epoch_ = 0;
};

}  // namespace glark::core
