// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/evaluation_programs.h"

#include <vector>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/evaluate/evaluation_source.h"
#include "glark/core/objects/programs/shader.h"
#include "glark/core/refine/attribute_locations.h"
#include "glark/core/refine/derive.h"
#include "glark/core/refine/program/uniform_copy.h"
#include "glark/core/report/log.h"

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

EvaluationProgram EvaluationPrograms::build(const Request& request) {
  const core::DerivedProgram& derived = *request.derived;
  const capture::Language language = capture::language_of(env_.capabilities);
  EvaluationSource source = evaluation_source({derived, core::constant_tags(env_.options), request.placed,
                                               request.refinement_source, language, env_.options.transparent});
  const auto found = by_source_.find(source.vertex);
  if (found != by_source_.end() && source.error.empty()) {
    return found->second;
  }
  const core::Compilation::Step step(env_.compilation);
  EvaluationProgram program;
  std::string& error = source.error;
  if (error.empty()) {
    const Inputs inputs{derived.layout.chunk_count(), request.placed};
    program.name = link(env_.gl, source, inputs, language == capture::Language::es, error);
  }
  if (program.name != 0) {
    find_uniforms(program, error);
  }
  if (program.name == 0) {
    const bool own = !request.refinement_source.empty();
    core::log(own ? core::LogLevel::info : core::LogLevel::warning, "refined vertices are not kept: " + error);
  }
  by_source_.emplace(std::move(source.vertex), program);
  return program;
}

// Uniforms that are neither ours nor numbers may change unseen: a program with such a uniform is dropped.
void EvaluationPrograms::find_uniforms(EvaluationProgram& program, std::string& error) const {
  const auto location = [&](const char* name) { return env_.gl.GetUniformLocation(program.name, name); };
  program.shape_number = location(refine::shape_number_uniform);
  program.displacement = {location(refine::height_map_uniform), location(refine::height_channel_uniform),
                          location(refine::height_range_uniform)};
  std::optional<std::vector<std::string>> uniforms =
      refine::plain_uniforms(env_.gl, program.name, refine::height_map_uniform);
  if (!uniforms) {
    error = "the refinement shader has textures, blocks or built-in uniforms";
    env_.gl.DeleteProgram(program.name);
    program = {};
    return;
  }
  std::erase_if(*uniforms, [](const std::string& name) { return name.starts_with("glark_"); });
  program.uniforms = std::move(*uniforms);
}

const EvaluationProgram& EvaluationPrograms::find(const Request& request) {
  const auto found = of_derived_.find(request.derived);
  if (found != of_derived_.end()) {
    return found->second;
  }
  std::erase_if(of_derived_, [](const auto& entry) { return entry.first.expired(); });
  return of_derived_.emplace(request.derived, build(request)).first->second;
}

void EvaluationPrograms::release() {
  for (const auto& [source, program] : by_source_) {
    env_.gl.DeleteProgram(program.name);
  }
  by_source_.clear();
  of_derived_.clear();
}

}  // namespace glark::evaluate
