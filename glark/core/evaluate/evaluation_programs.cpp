// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/evaluation_programs.h"

#include <vector>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/evaluate/evaluation_source.h"
#include "glark/core/objects/shader.h"
#include "glark/core/refine/attribute_locations.h"
#include "glark/core/refine/derive.h"
#include "glark/core/report/log.h"
#include "glark/core/shape.h"

namespace glark::evaluate {
namespace {

struct Inputs {
  int chunks = 0;
  bool placed = false;
};

void bind_inputs(const gl::Dispatch& gl, GLuint program, const Inputs& inputs) {
  gl.BindAttribLocation(program, refine::lattice_location, refine::lattice_input);
  if (inputs.placed) {
    gl.BindAttribLocation(program, refine::patch_location, refine::patch_input);
  }
  const GLuint first = inputs.placed ? refine::first_chunk_location : refine::patch_location;
  for (int chunk = 0; chunk < inputs.chunks; ++chunk) {
    gl.BindAttribLocation(program, first + static_cast<GLuint>(chunk),
                          (refine::chunk_input_prefix + std::to_string(chunk)).c_str());
  }
}

GLuint link(const gl::Dispatch& gl, const EvaluationSource& source, const Inputs& inputs, bool es, std::string& error) {
  const GLuint program = gl.CreateProgram();
  const std::vector<GLuint> shaders{
      core::compile_shader(gl, GL_VERTEX_SHADER, source.vertex, error),
      core::compile_shader(gl, GL_FRAGMENT_SHADER, core::idle_fragment_shader(es), error)};
  std::vector<const char*> varyings;
  for (const std::string& varying : source.varyings) {
    varyings.push_back(varying.c_str());
  }
  bind_inputs(gl, program, inputs);
  gl.TransformFeedbackVaryings(program, static_cast<GLsizei>(varyings.size()), varyings.data(), GL_INTERLEAVED_ATTRIBS);
  return core::link_program(gl, program, shaders, error) ? program : 0;
}

}  // namespace

EvaluationProgram EvaluationPrograms::build(const core::DerivedProgram& derived, bool placed) {
  const capture::Language language = capture::language_of(env_.capabilities);
  EvaluationSource source = evaluation_source({derived, core::constant_tags(env_.options), placed, language});
  const auto found = by_source_.find(source.vertex);
  if (found != by_source_.end()) {
    return found->second;
  }
  EvaluationProgram program;
  std::string& error = source.error;
  if (error.empty()) {
    program.name =
        link(env_.gl, source, {derived.layout.chunk_count(), placed}, language == capture::Language::es, error);
  }
  if (program.name != 0) {
    program.shape_number = env_.gl.GetUniformLocation(program.name, refine::shape_number_uniform);
  } else {
    core::log(core::LogLevel::warning, "refined vertices are not kept: " + error);
  }
  by_source_.emplace(std::move(source.vertex), program);
  return program;
}

const EvaluationProgram& EvaluationPrograms::find(const std::shared_ptr<core::DerivedProgram>& derived, bool placed) {
  const auto found = of_derived_.find(derived);
  if (found != of_derived_.end()) {
    return found->second;
  }
  std::erase_if(of_derived_, [](const auto& entry) { return entry.first.expired(); });
  return of_derived_.emplace(derived, build(*derived, placed)).first->second;
}

void EvaluationPrograms::release() {
  for (const auto& [source, program] : by_source_) {
    env_.gl.DeleteProgram(program.name);
  }
  by_source_.clear();
  of_derived_.clear();
}

}  // namespace glark::evaluate
