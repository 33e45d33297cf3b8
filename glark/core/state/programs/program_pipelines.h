// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Program pipeline objects of the application and ours. Ours have the same stages, but the derived program as the
// vertex stage.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "glark/gl/dispatch.h"

namespace glark::core {

// The graphics stages in their order; the first is the vertex stage.
inline constexpr std::array<GLenum, 5> pipeline_stages = {
    GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER};

struct PipelineObject {
  std::array<GLuint, pipeline_stages.size()> programs{};  // in the order of pipeline_stages; 0: none
  GLuint active = 0;                                      // glUniform* sets its uniforms
  GLuint vertex() const { return programs.front(); }
  GLuint geometry() const { return programs[3]; }
  GLuint tessellation() const { return programs[1] != 0 ? programs[1] : programs[2]; }
};

class ProgramPipelines {
 public:
  explicit ProgramPipelines(const gl::Dispatch& gl) : gl_(gl) {}

  // The stages of the application's pipeline. GL is asked only after a change.
  const PipelineObject& object(GLuint pipeline);
  void changed(GLuint pipeline) { objects_.erase(pipeline); }

  // A pipeline of ours with the stages of `of`. `derived` replaces its vertex program in every stage that this program
  // provides. 0: GL refuses it. When `epoch` changes (a program was linked or deleted), all our pipelines are made
  // again.
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
