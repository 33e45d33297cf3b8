// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/programs/assembly_stages.h"

#include <fmt/format.h>

#include "glark/core/report/log.h"

namespace glark::core {

const AssemblyStage& AssemblyStages::find(Program* fragment) {
  const std::shared_ptr<AssemblyProgram>& application = env_.state.programs().assembly().current();
  const Key key{application.get(), application->current_text_number(), fragment != nullptr ? fragment->name : 0,
                fixed_function_.read_state(fragment).clip_planes};
  const auto found = stages_.find(key);
  if (found != stages_.end()) {
    return found->second;
  }
  drop_old_texts();
  return stages_.emplace(key, make(application, key, fragment)).first->second;
}

AssemblyStage AssemblyStages::make(const std::shared_ptr<AssemblyProgram>& application, const Key& key,
                                   const Program* fragment) const {
  const std::string text = application->current_text();
  AssemblyStage stage{application, refine::assembly::translate(text, key.clip_planes), nullptr};
  if (stage.translation.ok) {
    stage.program = derived_.assembly(stage.translation.source, fragment);
  } else if (!text.empty()) {
    log(LogLevel::warning, fmt::format("an assembly vertex program is not refined: {}; its draws stay as they are",
                                       stage.translation.error));
  }
  return stage;
}

template <typename Condition>
void AssemblyStages::remove_if(const Condition& condition) {
  for (auto entry = stages_.begin(); entry != stages_.end();) {
    if (!condition(*entry)) {
      ++entry;
      continue;
    }
    if (entry->second.program != nullptr) {
      derived_.remove_generated(entry->first.fragment, *entry->second.program);
    }
    entry = stages_.erase(entry);
  }
}

// A stage is of no use after the application has deleted its program or has loaded another text.
void AssemblyStages::drop_old_texts() {
  remove_if([](const auto& entry) {
    AssemblyProgram& application = *entry.second.application;
    return entry.second.application.use_count() == 1 || application.current_text_number() != entry.first.text;
  });
}

void AssemblyStages::discard_derived() {
  for (auto& [key, stage] : stages_) {
    if (stage.program != nullptr) {
      derived_.discard(*stage.program);
    }
  }
}

void AssemblyStages::forget_fragment(GLuint name) {
  remove_if([name](const auto& entry) { return name != 0 && entry.first.fragment == name; });
}

void AssemblyStages::release() {
  remove_if([](const auto&) { return true; });
}

void AssemblyStages::upload(const AssemblyStage& stage, DerivedProgram& derived) const {
  AssemblyState& state = env_.state.programs().assembly();
  const refine::assembly::Translation& translation = stage.translation;
  AssemblyUniforms& uniforms = derived.assembly;
  if (!uniforms.found) {
    uniforms.found = true;
    uniforms.environment = env_.gl.GetUniformLocation(derived.name, refine::assembly::environment_uniform);
    uniforms.local = env_.gl.GetUniformLocation(derived.name, refine::assembly::local_uniform);
    for (const int matrix : translation.matrices) {
      const std::string name = refine::assembly::matrix_uniform_prefix + std::to_string(matrix);
      uniforms.matrices.push_back(env_.gl.GetUniformLocation(derived.name, name.c_str()));
    }
  }
  if (const std::uint64_t stamp = state.environment_stamp();
      uniforms.environment >= 0 && uniforms.environment_stamp != stamp) {
    const auto& [first, count] = translation.environment;
    uniforms.environment_stamp = stamp;
    env_.gl.ProgramUniform4fv(derived.name, uniforms.environment, count,
                              state.environment(static_cast<GLuint>(first), static_cast<GLuint>(count)));
  }
  if (const std::uint64_t stamp = state.local_stamp(*stage.application);
      uniforms.local >= 0 && uniforms.local_stamp != stamp) {
    const auto& [first, count] = translation.local;
    uniforms.local_stamp = stamp;
    state.with_local(*stage.application, static_cast<GLuint>(first), static_cast<GLuint>(count),
                     [&, size = count](const GLfloat* values) {
                       env_.gl.ProgramUniform4fv(derived.name, uniforms.local, size, values);
                     });
  }
  upload_matrices(stage, derived);
}

void AssemblyStages::upload_matrices(const AssemblyStage& stage, DerivedProgram& derived) const {
  AssemblyUniforms& uniforms = derived.assembly;
  const std::uint64_t stamp = env_.state.fixed_function().matrices().program_stamp();
  if (uniforms.matrices.empty() || uniforms.matrix_stamp == stamp) {
    return;
  }
  uniforms.matrix_stamp = stamp;
  for (std::size_t i = 0; i < uniforms.matrices.size(); ++i) {
    GLfloat matrix[16];
    env_.gl.MatrixMode(GL_MATRIX0_ARB + static_cast<GLenum>(stage.translation.matrices[i]));
    env_.gl.GetFloatv(GL_CURRENT_MATRIX_ARB, matrix);
    env_.gl.ProgramUniformMatrix4fv(derived.name, uniforms.matrices[i], 1, GL_FALSE, matrix);
  }
  env_.gl.MatrixMode(env_.bindings().matrix_mode);
}

}  // namespace glark::core
