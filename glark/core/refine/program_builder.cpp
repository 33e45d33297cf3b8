// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program_builder.h"

#include <algorithm>
#include <array>

#include "glark/core/refine/uniform_copy.h"
#include "glark/core/report.h"

namespace glark::refine {
namespace {

std::vector<std::string> vertex_sources(const core::Program& program) {
  std::vector<std::string> result;
  for (const core::StageSource& stage : program.stages) {
    if (stage.stage == GL_VERTEX_SHADER) {
      result.push_back(*stage.source);
    }
  }
  return result;
}

GLuint compile(const gl::Dispatch& gl, GLenum stage, const std::string& source, std::string& error) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    std::array<char, 2048> log{};
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    error += log.data();
    core::log(core::LogLevel::debug, "derived shader that does not compile:\n" + source);
  }
  return shader;
}

core::Cause cause_of(const core::Program& program, const VertexStageTraits& traits) {
  if (program.has_stage(GL_TESS_CONTROL_SHADER) || program.has_stage(GL_TESS_EVALUATION_SHADER)) {
    return core::Cause::tessellation;
  }
  if (traits.has_side_effects) {
    return core::Cause::side_effects;
  }
  return core::Cause::count_;
}

// Which subroutines are chosen is state of the context that glUseProgram resets: a refined draw would lose the choice.
bool chooses_subroutines(const gl::Dispatch& gl, const core::Program& program) {
  if (program.fixed_function || gl.GetProgramStageiv == nullptr) {
    return false;
  }
  return std::any_of(program.stages.begin(), program.stages.end(), [&](const core::StageSource& stage) {
    GLint count = 0;
    gl.GetProgramStageiv(program.name, stage.stage, GL_ACTIVE_SUBROUTINE_UNIFORMS, &count);
    return count > 0;
  });
}

std::string label(const core::Program& program) {
  return program.fixed_function ? std::string("fixed function") : "program " + std::to_string(program.name);
}

void leave(core::Program& program, const std::string& reason) {
  program.cause = core::Cause::program_not_derived;
  core::log(core::LogLevel::warning, label(program) + " is not refined: " + reason + "; its draws stay as they are");
}

}  // namespace

void ProgramBuilder::read_fields(core::Program& program) const {
  GLint count = 0;
  GLint longest = 0;
  gl_.GetProgramiv(program.name, GL_ACTIVE_ATTRIBUTES, &count);
  gl_.GetProgramiv(program.name, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH, &longest);
  std::string buffer(static_cast<std::size_t>(longest) + 1, '\0');
  program.fields.clear();
  for (GLint i = 0; i < count; ++i) {
    capture::Field field;
    GLsizei length = 0;
    gl_.GetActiveAttrib(program.name, static_cast<GLuint>(i), static_cast<GLsizei>(buffer.size()), &length,
                        &field.array_size, &field.type, buffer.data());
    field.name = buffer.substr(0, static_cast<std::size_t>(length));
    if (field.name == "gl_VertexID" || field.name == "gl_InstanceID" || field.name == "gl_BaseVertex" ||
        field.name == "gl_BaseInstance" || field.name == "gl_DrawID") {
      continue;  // system values, below
    }
    if (field.name.ends_with("[0]")) {
      field.name.resize(field.name.size() - 3);
      field.is_array = true;
    }
    field.is_array = field.is_array || field.array_size > 1;
    field.location = capture::is_builtin(field) ? -1 : gl_.GetAttribLocation(program.name, field.name.c_str());
    if (capture::words_of(field.type) == 0) {
      program.cause = core::Cause::program_not_derived;
      core::log(core::LogLevel::warning, label(program) + ": vertex input " + field.name +
                                             " has a type that is not captured; its draws stay as they are");
      return;
    }
    program.fields.push_back(std::move(field));
  }
  // A fixed order: the record must not depend on the driver's enumeration, and a vec4 position is best first.
  std::sort(program.fields.begin(), program.fields.end(), [](const capture::Field& a, const capture::Field& b) {
    return a.location != b.location ? a.location < b.location : a.name > b.name;
  });
  if (program.traits.reads_vertex_id) {
    program.fields.push_back({.name = "gl_VertexID", .type = GL_INT});
  }
  if (program.traits.reads_instance_id) {
    program.fields.push_back({.name = "gl_InstanceID", .type = GL_INT});
  }
  capture::assign_roles(program.fields);
}

// Attribute locations that are left for the coarse record.
int ProgramBuilder::most_chunks(bool placed) const {
  return traits_.max_vertex_attributes -
         static_cast<GLint>(placed ? traits_.first_chunk_location : traits_.patch_location);
}

void ProgramBuilder::prepare(core::Program& program) const {
  program.prepared = true;
  program.cause = core::Cause::count_;
  if (program.stages.empty()) {
    program.cause = program.from_binary ? core::Cause::program_binary : core::Cause::no_program;
    return;
  }
  const Inspection inspection =
      inspect_vertex_stage(vertex_sources(program), traits_.language == capture::Language::es, traits_.extensions);
  program.traits = inspection.traits;
  if (!inspection.ok) {
    leave(program, inspection.error);
    return;
  }
  program.cause = cause_of(program, inspection.traits);
  if (program.cause != core::Cause::count_) {
    return;
  }
  if (inspection.traits.has_subroutines || chooses_subroutines(gl_, program)) {
    leave(program, "it has subroutine uniforms");
    return;
  }
  read_fields(program);
  const capture::Layout layout = capture::make_layout(program.fields, false);
  const int free_locations = most_chunks(false);
  if (program.cause != core::Cause::count_) {
    return;
  }
  if (layout.fields.empty()) {
    leave(program, "its vertex stage has no inputs");
  } else if (layout.chunk_count() > free_locations || layout.corner_words + 1 > traits_.max_feedback_components) {
    program.cause = core::Cause::too_many_attributes;
  }
}

// Positions need the vertex stage alone; OpenGL ES links it only beside a fragment stage, which never runs.
bool ProgramBuilder::needs_stage(GLenum stage, bool at_corner) const {
  const bool es = traits_.language == capture::Language::es;
  return at_corner ? es && stage == GL_FRAGMENT_SHADER : stage != GL_VERTEX_SHADER;
}

void ProgramBuilder::bind_inputs(GLuint name, const core::DerivedKey& key) const {
  GLuint first_chunk = 0;
  if (!key.at_corner) {
    first_chunk = key.placed ? traits_.first_chunk_location : traits_.patch_location;
    gl_.BindAttribLocation(name, traits_.lattice_location, lattice_input);
    if (key.placed) {
      gl_.BindAttribLocation(name, traits_.patch_location, patch_input);
    }
  }
  for (GLuint chunk = 0; first_chunk + chunk < static_cast<GLuint>(traits_.max_vertex_attributes); ++chunk) {
    gl_.BindAttribLocation(name, first_chunk + chunk, (chunk_input_prefix + std::to_string(chunk)).c_str());
  }
}

GLuint ProgramBuilder::compile_and_link(const core::Program& program, const std::vector<std::string>& vertex_stage,
                                        GLuint settings_of, const core::DerivedKey& key, std::string& error) const {
  const GLuint name = gl_.CreateProgram();
  std::vector<GLuint> shaders;
  for (const std::string& source : vertex_stage) {
    shaders.push_back(compile(gl_, GL_VERTEX_SHADER, source, error));
  }
  for (const core::StageSource& stage : program.stages) {
    if (needs_stage(stage.stage, key.at_corner)) {
      shaders.push_back(compile(gl_, stage.stage, *stage.source, error));
    }
  }
  for (const GLuint shader : shaders) {
    gl_.AttachShader(name, shader);
  }
  bind_inputs(name, key);
  if (key.at_corner) {
    const char* const varying = "gl_Position";
    gl_.TransformFeedbackVaryings(name, 1, &varying, GL_INTERLEAVED_ATTRIBS);
  } else if (settings_of != 0) {
    copy_link_settings(gl_, settings_of, name);
  }
  gl_.LinkProgram(name);
  GLint linked = GL_FALSE;
  gl_.GetProgramiv(name, GL_LINK_STATUS, &linked);
  for (const GLuint shader : shaders) {
    gl_.DetachShader(name, shader);
    gl_.DeleteShader(shader);
  }
  if (linked != GL_FALSE) {
    return name;
  }
  std::array<char, 2048> log{};
  gl_.GetProgramInfoLog(name, static_cast<GLsizei>(log.size()), nullptr, log.data());
  error += log.data();
  gl_.DeleteProgram(name);
  return 0;
}

core::DerivedProgram* ProgramBuilder::derive(core::Program& program, core::Program* owner,
                                             const core::DerivedKey& key) const {
  const auto found = program.derived.find(key);
  if (found != program.derived.end()) {
    return found->second.get();
  }
  std::unique_ptr<core::DerivedProgram>& slot = program.derived[key];
  DeriveRequest request;
  request.vertex_sources = vertex_sources(program);
  request.es = traits_.language == capture::Language::es;
  request.context_glsl_version = traits_.glsl_version;
  request.layout = capture::make_layout(program.fields, key.tagged);
  request.refinement = program.traits.reads_vertex_id ? core::Refinement::linear_outputs : key.refinement;
  request.at_corner = key.at_corner;
  request.placed = key.placed;
  request.provoking_corner = key.provoking_corner;
  request.flat_colors = key.flat_colors;
  request.clamp_colors = key.clamp_colors;
  if (!key.at_corner) {
    request.refinement_source = program.refinement_source;
  }
  request.extensions = traits_.extensions;
  Derivation derivation;
  if (key.at_corner || request.layout.chunk_count() <= most_chunks(key.placed)) {
    derivation = derive_vertex_stage(request);
  } else {
    derivation.error = "its vertex attributes leave no room for depth tags and placement";
  }
  std::string error = derivation.error;
  const GLuint name = derivation.ok ? compile_and_link(program, derivation.vertex_sources,
                                                       owner != nullptr ? owner->name : 0, key, error)
                                    : 0;
  program.refinement_log = error;
  if (name == 0) {
    ++core::statistics().programs_failed;
    core::log(core::LogLevel::warning, label(program) + " is not refined: " + error + "; its draws stay as they are");
    return nullptr;
  }
  slot = std::make_unique<core::DerivedProgram>();
  slot->name = name;
  slot->layout = std::move(request.layout);
  const auto other = std::find_if(program.derived.begin(), program.derived.end(),
                                  [&](const auto& entry) { return entry.second != nullptr && entry.second != slot; });
  copy_virtual_uniforms(gl_, program.virtual_uniforms, other != program.derived.end() ? other->second.get() : nullptr,
                        *slot);
  if (owner != nullptr) {
    map_uniform_locations(gl_, owner->name, *slot);
    copy_uniform_values(gl_, owner->name, *slot);
    copy_block_bindings(gl_, owner->name, name);
    owner->mirrors.push_back({name, slot.get()});
  }
  ++core::statistics().programs_derived;
  return slot.get();
}

std::shared_ptr<core::Program> ProgramBuilder::fixed_function(const FixedFunctionState& state,
                                                              const core::Program* fragment) const {
  auto program = std::make_shared<core::Program>();
  program->fixed_function = true;
  const std::string source = fixed_function_vertex_shader(state);
  program->stages.push_back({GL_VERTEX_SHADER, std::make_shared<const std::string>(source)});
  // A program of the vertex stage alone tells which attributes it reads.
  std::string error;
  program->name = compile_and_link(*program, {source}, 0, core::DerivedKey{.placed = false}, error);
  if (program->name == 0) {
    core::log(core::LogLevel::error, "fixed-function vertex stage: " + error);
  }
  if (fragment != nullptr) {
    for (const core::StageSource& stage : fragment->stages) {
      program->stages.push_back(stage);
    }
  }
  return program;
}

void ProgramBuilder::discard(core::Program& program) const {
  for (const auto& [key, derived] : program.derived) {
    if (derived != nullptr) {
      gl_.DeleteProgram(derived->name);
    }
  }
  program.derived.clear();
  program.mirrors.clear();
  program.prepared = false;
}

}  // namespace glark::refine
