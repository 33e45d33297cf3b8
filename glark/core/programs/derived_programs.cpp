// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/programs/derived_programs.h"

#include <algorithm>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/capture/feedback_aside.h"
#include "glark/core/refine/attribute_locations.h"
#include "glark/core/refine/program/uniform_copy.h"
#include "glark/core/shape.h"

namespace glark::core {
namespace {

refine::BuilderTraits builder_traits(const Capabilities& capabilities, const ContextOptions& options) {
  refine::BuilderTraits traits;
  traits.language = capture::language_of(capabilities);
  traits.roles = options.roles;
  traits.scalar_tags = constant_tags(options);
  traits.transparent = options.transparent;
  traits.glsl_version = capabilities.version * 10;
  traits.extensions = capabilities.extensions;
  traits.max_vertex_attributes = capabilities.max_vertex_attributes;
  traits.max_feedback_components = capabilities.max_feedback_components;
  traits.max_vertex_storage_blocks = capabilities.max_vertex_storage_blocks;
  traits.lattice_location = refine::lattice_location;
  traits.patch_location = refine::patch_location;
  traits.first_chunk_location = refine::first_chunk_location;
  return traits;
}

}  // namespace

DerivedPrograms::DerivedPrograms(const Environment& environment, capture::CaptureStage& stage)
    : env_(environment),
      stage_(stage),
      builder_(environment.gl, builder_traits(environment.capabilities, environment.options)) {}

void DerivedPrograms::prepare(Program& program) const {
  if (program.prepared) {
    return;
  }
  ErrorScope errors(env_.errors);
  builder_.prepare(program);
  const auto& left = env_.options.left_shaders;
  program.left_alone = std::find(left.begin(), left.end(), program.hash) != left.end();
}

std::shared_ptr<DerivedProgram> DerivedPrograms::find(Program& program, Program* owner, const DerivedKey& key) const {
  const auto found = program.derived.find(key);
  if (found != program.derived.end()) {
    return found->second;
  }
  if (!env_.compilation.may_begin(&program)) {
    return nullptr;
  }
  const Compilation::Step step(env_.compilation);
  ErrorScope errors(env_.errors);
  const capture::FeedbackAside aside(env_.gl, stage_, env_.bindings());
  std::shared_ptr<DerivedProgram> derived = builder_.derive(program, owner, key);
  env_.state.programs().mirror_from_now_on();
  return derived;
}

std::shared_ptr<Program> DerivedPrograms::fixed_function(const refine::FixedFunctionState& state,
                                                         const Program* fragment) const {
  const Compilation::Step step(env_.compilation);
  ErrorScope errors(env_.errors);
  return builder_.fixed_function(state, fragment);
}

std::shared_ptr<Program> DerivedPrograms::assembly(const std::string& source, const Program* fragment) const {
  const Compilation::Step step(env_.compilation);
  ErrorScope errors(env_.errors);
  std::shared_ptr<Program> program = builder_.generated(source, "the GLSL of an assembly program", fragment);
  program->assembly = true;
  return program->name != 0 ? program : nullptr;
}

void DerivedPrograms::copy_stale_uniforms(Program& owner) const {
  const std::lock_guard lock(owner.mutex);
  if (!owner.uniforms_stale) {
    return;
  }
  ErrorScope errors(env_.errors);
  for (const UniformMirror& mirror : owner.mirrors) {
    refine::copy_uniform_values(env_.gl, owner.name, *mirror.derived, owner.handles);
  }
  owner.uniforms_stale = false;
}

void DerivedPrograms::discard(Program& program) {
  env_.share.program_epoch.fetch_add(1, std::memory_order_relaxed);
  builder_.discard(program);
}

// Another context may still use the fragment program. Its uniforms must no longer be mirrored to deleted derived
// programs.
void DerivedPrograms::remove_generated(GLuint fragment, Program& program) {
  if (const std::shared_ptr<Program> owner = env_.state.programs().find(fragment)) {
    const std::lock_guard lock(owner->mutex);
    std::erase_if(owner->mirrors, [&](const UniformMirror& mirror) {
      return std::any_of(program.derived.begin(), program.derived.end(),
                         [&](const auto& entry) { return entry.second.get() == mirror.derived; });
    });
  }
  builder_.discard(program);
  env_.gl.DeleteProgram(program.name);
}

}  // namespace glark::core
