// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program/program_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "glark/core/objects/programs/shader.h"
#include "glark/core/refine/facet_normals.h"
#include "glark/core/refine/glsl/geometry_shader.h"
#include "glark/core/refine/program/labels.h"
#include "glark/core/refine/program/shape_fields.h"
#include "glark/core/refine/program/subroutines.h"
#include "glark/core/refine/program/uniform_copy.h"
#include "glark/core/refine/program/unsound_outputs.h"
#include "glark/core/refine/program/vertex_inputs.h"
#include "glark/core/refine/refinement_log.h"
#include "glark/core/report/cause.h"
#include "glark/core/report/log.h"
#include "glark/core/report/statistics.h"

namespace glark::refine {
namespace {

std::vector<std::string> sources_of(const core::Program& program, GLenum stage) {
  std::vector<std::string> result;
  for (const core::StageSource& source : program.stages) {
    if (source.stage == stage) {
      result.push_back(*source.source);
    }
  }
  return result;
}

// Returns whether a source of that stage mentions `name`. Binaries have no sources.
bool reads(const core::Program& program, GLenum stage, std::string_view name) {
  return std::any_of(program.stages.begin(), program.stages.end(), [&](const core::StageSource& source) {
    return source.stage == stage && source.source->find(name) != std::string::npos;
  });
}

bool mentions(const core::Program& program, std::string_view name) {
  return std::any_of(program.stages.begin(), program.stages.end(),
                     [&](const core::StageSource& source) { return source.source->find(name) != std::string::npos; });
}

// Returns the cause why the program's stages, or the effects of its vertex stage, rule out refinement, if there is one.
std::optional<core::Cause> cause_of(const core::Program& program, const VertexStageTraits& traits, bool transparent) {
  if (program.has_stage(GL_TESS_CONTROL_SHADER) || program.has_stage(GL_TESS_EVALUATION_SHADER)) {
    return core::Cause::tessellation;
  }
  if (traits.has_side_effects) {
    return core::Cause::side_effects;
  }
  if (!transparent) {
    return std::nullopt;
  }
  const bool has_geometry_shader = program.has_stage(GL_GEOMETRY_SHADER);
  if (has_geometry_shader ? reads(program, GL_GEOMETRY_SHADER, "gl_PrimitiveIDIn")
                          : reads(program, GL_FRAGMENT_SHADER, "gl_PrimitiveID")) {
    return core::Cause::primitive_id;
  }
  if (traits.writes_cull_distance && (reads(program, GL_FRAGMENT_SHADER, "gl_CullDistance") ||
                                      reads(program, GL_GEOMETRY_SHADER, "gl_CullDistance"))) {
    return core::Cause::cull_distance;
  }
  if (has_geometry_shader &&
      (traits.writes_integers || makes_its_own_positions(sources_of(program, GL_GEOMETRY_SHADER)))) {
    return core::Cause::geometry_shader;
  }
  return std::nullopt;
}

void log_unsound_outputs(const core::Program& program) {
  for (const OutputVariation& output : unsound_outputs(program.traits.variation, program.input_traits.can_curve)) {
    const std::string_view reason =
        output.reason.empty() ? std::string_view("not linear, and no normal is known") : output.reason;
    core::log(core::LogLevel::info, fmt::format("{}: output {} is interpolated between the corners ({})",
                                                label(program), output.path, reason));
  }
}

void leave(core::Program& program, const std::string& reason) {
  program.cause = core::Cause::program_not_derived;
  core::note_program_problem(program.hash, reason);
  core::log(core::LogLevel::warning,
            fmt::format("{} is not refined: {}; its draws stay as they are", label(program), reason));
}

}  // namespace

// The number of attribute locations that remain for the coarse record.
int ProgramBuilder::most_chunks(bool placed) const {
  return traits_.max_vertex_attributes -
         static_cast<GLint>(placed ? traits_.first_chunk_location : traits_.patch_location);
}

// Returns whether the program can read records from a storage block. Its own blocks might use the same binding.
bool ProgramBuilder::can_store_records(const core::Program& program) const {
  GLint blocks = 0;
  gl_.GetProgramInterfaceiv(program.name, GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
  return blocks == 0 && traits_.max_vertex_storage_blocks > 0;
}

void ProgramBuilder::prepare(core::Program& program) const {
  program.prepared = true;
  program.instanced_variations.clear();
  program.cause.reset();
  program.hash = core::source_hash(program.stages);
  program.counters = &core::program_counters(program.hash);
  program.counts_primitives = mentions(program, "gl_PrimitiveID");
  program.conventional_projection = program.fixed_function || core::reads_conventional_projection(program.stages);
  show_originals(program);
  if (program.stages.empty()) {
    program.cause = program.from_binary ? core::Cause::program_binary : core::Cause::no_program;
    return;
  }
  const Inspection inspection = inspect_vertex_stage(sources_of(program, GL_VERTEX_SHADER),
                                                     traits_.language == capture::Language::es, traits_.extensions);
  program.traits = inspection.traits;
  program.traits.fragments_make_facets = computes_facet_normals(sources_of(program, GL_FRAGMENT_SHADER));
  if (!inspection.ok) {
    leave(program, inspection.error);
    return;
  }
  if (program.fixed_function) {
    program.traits.variation = {};  // glark's own shader is sound
  }
  program.cause = cause_of(program, inspection.traits, traits_.transparent);
  if (program.cause) {
    return;
  }
  read_vertex_inputs(gl_, traits_.roles, program);
  if (!program.cause) {
    check_inputs(program);
  }
}

const StageVariation& ProgramBuilder::variation(core::Program& program, std::uint32_t instanced) const {
  if (instanced == 0) {
    return program.traits.variation;
  }
  const auto [entry, missing] = program.instanced_variations.try_emplace(instanced);
  if (missing) {
    std::set<std::string> constants;
    for (const capture::Field& field : program.fields) {
      if (field.location >= 0 && (instanced >> static_cast<unsigned>(field.location) & 1U) != 0) {
        constants.insert(field.name);
      }
    }
    entry->second = inspect_vertex_stage(sources_of(program, GL_VERTEX_SHADER),
                                         traits_.language == capture::Language::es, traits_.extensions, constants)
                        .traits.variation;
  }
  return entry->second;
}

// Decides whether the inputs fit into a record.
void ProgramBuilder::check_inputs(core::Program& program) const {
  if (traits_.transparent) {
    log_unsound_outputs(program);
  }
  const capture::Layout layout = capture::make_layout(program.fields, false);
  const int free_locations = most_chunks(false);
  if (layout.fields.empty()) {
    leave(program, "its vertex stage has no inputs");
  } else if ((layout.chunk_count() > free_locations && !can_store_records(program)) ||
             layout.corner_words + 1 > traits_.max_feedback_components) {
    program.cause = core::Cause::too_many_attributes;
  }
}

// Positions need the vertex stage alone; OpenGL ES links it only beside a fragment stage, which never runs.
bool ProgramBuilder::needs_stage(GLenum stage, bool positions_only) const {
  const bool es = traits_.language == capture::Language::es;
  return positions_only ? es && stage == GL_FRAGMENT_SHADER : stage != GL_VERTEX_SHADER;
}

void ProgramBuilder::bind_inputs(GLuint name, const core::DerivedKey& key) const {
  GLuint first_chunk = 0;
  if (!key.at_corner) {
    first_chunk = key.placed ? traits_.first_chunk_location : traits_.patch_location;
    gl_.BindAttribLocation(name, traits_.lattice_location, lattice_input);
    if (key.placed) {
      gl_.BindAttribLocation(name, traits_.patch_location, patch_input);
      gl_.BindAttribLocation(name, traits_.first_chunk_location, instance_input);
    }
  }
  for (GLuint chunk = 0; first_chunk + chunk < static_cast<GLuint>(traits_.max_vertex_attributes); ++chunk) {
    gl_.BindAttribLocation(name, first_chunk + chunk, (chunk_input_prefix + std::to_string(chunk)).c_str());
  }
}

GLuint ProgramBuilder::compile_and_link(const core::Program& program, const std::vector<std::string>& vertex_stage,
                                        const core::Program* settings_of, const core::DerivedKey& key,
                                        std::string& error) const {
  const GLuint name = gl_.CreateProgram();
  std::vector<GLuint> shaders;
  for (const std::string& source : vertex_stage) {
    shaders.push_back(core::compile_shader(gl_, GL_VERTEX_SHADER, source, error));
  }
  for (const core::StageSource& stage : program.stages) {
    if (needs_stage(stage.stage, key.positions_only())) {
      shaders.push_back(core::compile_shader(gl_, stage.stage, *stage.source, error));
    }
  }
  const bool es = traits_.language == capture::Language::es;
  if (key.positions_only() && !(es && program.has_stage(GL_FRAGMENT_SHADER))) {
    shaders.push_back(core::compile_shader(gl_, GL_FRAGMENT_SHADER, core::idle_fragment_shader(es), error));
  }
  bind_inputs(name, key);
  if (key.positions_only()) {
    const char* const varying = "gl_Position";
    gl_.TransformFeedbackVaryings(name, 1, &varying, GL_INTERLEAVED_ATTRIBS);
  } else if (settings_of != nullptr) {
    copy_link_settings(gl_, *settings_of, name);
  }
  return core::link_program(gl_, name, shaders, error) ? name : 0;
}

capture::WeldedWords ProgramBuilder::welded_words(const core::Program& program,
                                                  const std::vector<capture::Field>& fields, int coordinate_field,
                                                  const core::DerivedKey& key) const {
  capture::WeldedWords words;
  if (!capture::can_curve(fields)) {
    return words;
  }
  const int most = most_chunks(key.placed);
  const auto fits = [&](capture::WeldedWords added, bool stored) {
    const capture::Layout layout = capture::make_layout(fields, key.tagged, added);
    return layout.corner_words <= traits_.max_feedback_components && (layout.chunk_count() <= most || stored);
  };
  const bool stored = can_store_records(program);
  const core::RefinementTraits& refinement = core::traits_of(key.refinement);
  const bool refines = !refinement.interpolates_outputs;
  const bool curved = key.welded && refinement.curves_positions && refines;
  const bool displaced = key.border && coordinate_field >= 0 && refines;
  words.controls = curved && fits({.controls = true}, stored);
  words.turns = key.turns && fits({words.controls, true}, stored);
  if (displaced && fits({words.controls, words.turns, coordinate_field}, stored)) {
    words.displaced_by = coordinate_field;
  }
  if (words.controls != curved || words.turns != key.turns || (displaced && words.displaced_by < 0)) {
    core::log(
        core::LogLevel::info,
        fmt::format("{}: its vertex attributes leave no room for what welded edges need; where normals or texture "
                    "coordinates differ at an edge, its triangles may part there",
                    label(program)));
  }
  return words;
}

DeriveRequest ProgramBuilder::request_for(core::Program& program, const core::DerivedKey& key) const {
  DeriveRequest request;
  request.vertex_sources = sources_of(program, GL_VERTEX_SHADER);
  request.es = traits_.language == capture::Language::es;
  request.context_glsl_version = traits_.glsl_version;
  std::vector<capture::Field> fields = program.fields;
  add_shape_fields(fields, key, program.fixed_function, request);
  request.scalar_tags = traits_.scalar_tags;
  const capture::WeldedWords welded = welded_words(program, fields, request.coordinate_field, key);
  request.layout = capture::make_layout(std::move(fields), key.tagged, welded);
  request.refinement = key.refinement;
  request.at_corner = key.at_corner;
  request.at_points = key.at_points;
  request.placed = key.placed && !key.at_points;
  request.morphing = key.morphing;
  request.creased = traits_.transparent;
  request.provoking_corner = key.provoking_corner;
  request.outputs = {key.flat_colors, key.clamp_colors, words_of_positions(sources_of(program, GL_GEOMETRY_SHADER))};
  // Where the stage runs on the corners, the refinement shader is ignored.
  if (!key.at_corner && !program.traits.corners_only()) {
    request.refinement_source = program.refinement_source;
  }
  if (traits_.transparent && request.refinement_source.empty()) {
    for (const OutputVariation& output :
         unsound_outputs(variation(program, key.instanced), program.input_traits.can_curve)) {
      request.outputs.unsound.insert(output.path);
    }
  }
  request.extensions = traits_.extensions;
  request.stored = !key.at_corner && request.layout.chunk_count() > most_chunks(key.placed);
  return request;
}

Derivation ProgramBuilder::derive_if_it_fits(const core::Program& program, const DeriveRequest& request) const {
  if (request.layout.corner_words > traits_.max_feedback_components) {
    return {false, {}, "its vertex attributes leave no room for scalar tags"};
  }
  if (request.stored && !can_store_records(program)) {
    return {false, {}, "its vertex attributes leave no room for depth tags and placement"};
  }
  return derive_vertex_stage(request);
}

void ProgramBuilder::find_uniforms(const DeriveRequest& request, core::DerivedProgram& derived) const {
  derived.shape_number = gl_.GetUniformLocation(derived.name, shape_number_uniform);
  derived.height_map = gl_.GetUniformLocation(derived.name, height_map_uniform);
  derived.height_channel = gl_.GetUniformLocation(derived.name, height_channel_uniform);
  derived.height_range = gl_.GetUniformLocation(derived.name, height_range_uniform);
  if (!request.stored) {
    return;
  }
  derived.first_word = gl_.GetUniformLocation(derived.name, first_word_uniform);
  derived.numbered = gl_.GetAttribLocation(derived.name, instance_input) >= 0;
  if (gl_.ShaderStorageBlockBinding != nullptr) {
    const GLuint block = gl_.GetProgramResourceIndex(derived.name, GL_SHADER_STORAGE_BLOCK, records_block);
    gl_.ShaderStorageBlockBinding(derived.name, block, records_binding);
  }
}

// Copies the application's uniform values to the derived program, and lets later changes reach it.
void ProgramBuilder::follow_uniforms(core::Program& program, core::Program* owner,
                                     const std::shared_ptr<core::DerivedProgram>& derived) const {
  // Programs that run at corners have no refinement shader, so they lack its uniforms.
  const auto other = std::find_if(program.derived.begin(), program.derived.end(), [&](const auto& entry) {
    return entry.second != nullptr && entry.second != derived && !entry.first.at_corner;
  });
  copy_virtual_uniforms(gl_, program.virtual_uniforms, other != program.derived.end() ? other->second.get() : nullptr,
                        *derived);
  if (owner != nullptr) {
    map_uniform_locations(gl_, owner->name, *derived);
    copy_uniform_values(gl_, owner->name, *derived, owner->handles);
    copy_block_bindings(gl_, owner->name, derived->name);
    derived->subroutines = map_subroutines(gl_, *owner, derived->name);
    owner->mirrors.push_back({derived->name, derived.get()});
  }
}

std::shared_ptr<core::DerivedProgram> ProgramBuilder::derive(core::Program& program, core::Program* owner,
                                                             const core::DerivedKey& key) const {
  const auto found = program.derived.find(key);
  if (found != program.derived.end()) {
    return found->second;
  }
  std::shared_ptr<core::DerivedProgram>& slot = program.derived[key];
  DeriveRequest request = request_for(program, key);
  const Derivation derivation = derive_if_it_fits(program, request);
  show_derived(program, key, derivation.vertex_sources);
  std::string error = derivation.error;
  const GLuint name = derivation.ok ? compile_and_link(program, derivation.vertex_sources, owner, key, error) : 0;
  error = log_for_author(error, derivation.prefix);
  program.refinement_log = error;
  if (name == 0) {
    core::note_program_problem(program.hash, error);
    ++core::statistics().programs_failed;
    core::log(core::LogLevel::warning,
              fmt::format("{} is not refined: {}; its draws stay as they are", label(program), error));
    return nullptr;
  }
  slot = std::make_shared<core::DerivedProgram>();
  static std::atomic<std::uint64_t> numbers{0};
  slot->name = name;
  slot->number = ++numbers;
  slot->refinement = key.refinement;
  slot->corner_outputs = derivation.corner_outputs;
  find_uniforms(request, *slot);
  slot->shape_fields = {request.discontinuity_field, request.scalar_tag_field, request.coordinate_field};
  slot->surface = surface_words(request.layout, slot->shape_fields);
  slot->layout = std::move(request.layout);
  follow_uniforms(program, owner, slot);
  ++core::statistics().programs_derived;
  return slot;
}

std::shared_ptr<core::Program> ProgramBuilder::generated(const std::string& source, std::string_view what,
                                                         const core::Program* fragment) const {
  auto program = std::make_shared<core::Program>();
  program->stages.push_back({GL_VERTEX_SHADER, std::make_shared<const std::string>(source)});
  // A program with only the vertex stage shows which attributes this stage reads.
  std::string error;
  program->name = compile_and_link(*program, {source}, nullptr, core::DerivedKey{.placed = false}, error);
  if (program->name == 0) {
    core::log(core::LogLevel::error, fmt::format("{} cannot be built: {}", what, error));
  }
  if (fragment != nullptr) {
    for (const core::StageSource& stage : fragment->stages) {
      program->stages.push_back(stage);
    }
  }
  return program;
}

std::shared_ptr<core::Program> ProgramBuilder::fixed_function(const FixedFunctionState& state,
                                                              const core::Program* fragment) const {
  std::shared_ptr<core::Program> program =
      generated(fixed_function_vertex_shader(state), "the fixed-function vertex stage", fragment);
  program->fixed_function = true;
  return program;
}

void ProgramBuilder::discard(core::Program& program) {
  const std::lock_guard lock(program.mutex);
  for (auto& [key, derived] : program.derived) {
    if (derived != nullptr) {
      discarded_.push_back(std::move(derived));
    }
  }
  program.derived.clear();
  program.mirrors.clear();
  program.prepared = false;
  std::erase_if(discarded_, [&](const std::shared_ptr<core::DerivedProgram>& derived) {
    const bool unused = derived.use_count() == 1;  // otherwise a draw of another context is under way with it
    if (unused) {
      gl_.DeleteProgram(derived->name);
    }
    return unused;
  });
}

}  // namespace glark::refine
