// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program_builder.h"

#include <algorithm>
#include <map>
#include <optional>

#include "glark/core/refine/geometry_shader.h"
#include "glark/core/refine/rewrite.h"
#include "glark/core/refine/shape_fields.h"
#include "glark/core/refine/subroutines.h"
#include "glark/core/refine/uniform_copy.h"
#include "glark/core/report.h"
#include "glark/core/shader.h"

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

std::vector<std::string> geometry_sources(const core::Program& program) {
  std::vector<std::string> result;
  for (const core::StageSource& stage : program.stages) {
    if (stage.stage == GL_GEOMETRY_SHADER) {
      result.push_back(*stage.source);
    }
  }
  return result;
}

std::optional<core::Cause> cause_of(const core::Program& program, const VertexStageTraits& traits) {
  if (program.has_stage(GL_TESS_CONTROL_SHADER) || program.has_stage(GL_TESS_EVALUATION_SHADER)) {
    return core::Cause::tessellation;
  }
  if (traits.has_side_effects) {
    return core::Cause::side_effects;
  }
  return std::nullopt;
}

// Without sources there is nothing to read: a binary.
bool reads(const core::Program& program, GLenum stage, std::string_view name) {
  return std::any_of(program.stages.begin(), program.stages.end(), [&](const core::StageSource& source) {
    return source.stage == stage && source.source->find(name) != std::string::npos;
  });
}

std::string label(const core::Program& program) {
  return (program.fixed_function ? std::string("fixed function") : "program " + std::to_string(program.name)) + " [" +
         core::hash_text(program.hash) + "]";
}

std::string_view stage_name(GLenum stage) {
  switch (stage) {
    case GL_VERTEX_SHADER: return "vert";
    case GL_TESS_CONTROL_SHADER: return "tesc";
    case GL_TESS_EVALUATION_SHADER: return "tese";
    case GL_GEOMETRY_SHADER: return "geom";
    case GL_FRAGMENT_SHADER: return "frag";
    default: return "comp";
  }
}

void show(const core::Program& program, GLenum stage, std::string_view kind, unsigned object,
          const std::string& source) {
  core::show_shader({program.hash, program.fixed_function ? 0 : program.name, stage_name(stage), kind, object, source});
}

void show_originals(const core::Program& program) {
  std::map<GLenum, unsigned> objects;
  for (const core::StageSource& stage : program.stages) {
    show(program, stage.stage, "original", objects[stage.stage]++, *stage.source);
  }
}

bool is_curved(core::Refinement refinement) {
  return refinement == core::Refinement::pn || refinement == core::Refinement::scalar_tagged_pn;
}

std::string kind_of(const core::DerivedKey& key, core::Refinement refinement) {
  if (key.at_corner) return "corners";
  std::string kind = refinement == core::Refinement::pn                 ? "pn"
                     : refinement == core::Refinement::scalar_tagged_pn ? "stpn"
                     : refinement == core::Refinement::linear_outputs   ? "outputs"
                                                                        : "linear";
  kind += key.displaced ? "-displaced" : "";
  kind += key.tagged ? "-tagged" : "";
  kind += key.welded && is_curved(refinement) ? "-welded" : "";
  kind += key.border ? "-border" : "";
  kind += key.placed ? "-placed" : "";
  kind += key.morphing ? "-morphing" : "";
  kind += key.flat_colors ? "-flat" : "";
  kind += key.provoking_corner == 0 ? "-first" : "";
  kind += key.clamp_colors ? "" : "-unclamped";
  return kind;
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
    const BuiltInInput* const built_in = built_in_input(field.name);
    if (built_in != nullptr && built_in->system_value) {
      continue;  // below: not every driver lists them
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
  int end = 0;
  for (const capture::Field& field : program.fields) {
    if (field.location >= 0 && field.location < end) {
      program.cause = core::Cause::program_not_derived;
      core::log(core::LogLevel::warning, label(program) + ": vertex input " + field.name +
                                             " shares a location with another; its draws stay as they are");
      return;
    }
    end = std::max(end, field.location + capture::columns_of(field.type) * field.array_size);
  }
  for (const std::string& name : program.traits.system_values) {
    program.fields.push_back({.name = name, .type = GL_INT});
  }
  capture::assign_roles(program.fields, traits_.roles);
  core::log(core::LogLevel::info, label(program) + ": " + capture::roles_text(program.fields));
}

// Attribute locations that are left for the coarse record.
int ProgramBuilder::most_chunks(bool placed) const {
  return traits_.max_vertex_attributes -
         static_cast<GLint>(placed ? traits_.first_chunk_location : traits_.patch_location);
}

// From a storage block, at a binding that the application's own blocks might have.
bool ProgramBuilder::can_store_records(const core::Program& program) const {
  GLint blocks = 0;
  gl_.GetProgramInterfaceiv(program.name, GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &blocks);
  return blocks == 0 && traits_.max_vertex_storage_blocks > 0;
}

void ProgramBuilder::prepare(core::Program& program) const {
  program.prepared = true;
  program.cause.reset();
  program.hash = core::source_hash(program.stages);
  program.counters = &core::program_counters(program.hash);
  program.conventional_projection = program.fixed_function || core::reads_conventional_projection(program.stages);
  show_originals(program);
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
  if (traits_.transparent && !program.cause &&
      (program.has_stage(GL_GEOMETRY_SHADER) ? reads(program, GL_GEOMETRY_SHADER, "gl_PrimitiveIDIn")
                                             : reads(program, GL_FRAGMENT_SHADER, "gl_PrimitiveID"))) {
    program.cause = core::Cause::primitive_id;
  }
  if (traits_.transparent && !program.cause && program.has_stage(GL_GEOMETRY_SHADER) &&
      (inspection.traits.writes_integers || makes_its_own_positions(geometry_sources(program)))) {
    program.cause = core::Cause::geometry_shader;
  }
  if (program.cause) {
    return;
  }
  read_fields(program);
  const capture::Layout layout = capture::make_layout(program.fields, false);
  const int free_locations = most_chunks(false);
  if (program.cause) {
    return;
  }
  if (layout.fields.empty()) {
    leave(program, "its vertex stage has no inputs");
  } else if ((layout.chunk_count() > free_locations && !can_store_records(program)) ||
             layout.corner_words + 1 > traits_.max_feedback_components) {
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
      gl_.BindAttribLocation(name, traits_.first_chunk_location, instance_input);
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
    shaders.push_back(core::compile_shader(gl_, GL_VERTEX_SHADER, source, error));
  }
  for (const core::StageSource& stage : program.stages) {
    if (needs_stage(stage.stage, key.at_corner)) {
      shaders.push_back(core::compile_shader(gl_, stage.stage, *stage.source, error));
    }
  }
  const bool es = traits_.language == capture::Language::es;
  if (key.at_corner && !(es && program.has_stage(GL_FRAGMENT_SHADER))) {
    shaders.push_back(core::compile_shader(gl_, GL_FRAGMENT_SHADER, core::idle_fragment_shader(es), error));
  }
  bind_inputs(name, key);
  if (key.at_corner) {
    const char* const varying = "gl_Position";
    gl_.TransformFeedbackVaryings(name, 1, &varying, GL_INTERLEAVED_ATTRIBS);
  } else if (settings_of != 0) {
    copy_link_settings(gl_, settings_of, name);
  }
  return core::link_program(gl_, name, shaders, error) ? name : 0;
}

// Integers name things (bones, layers): between corners that name others there is nothing to run the stage on. A program that
// refines by itself is told so and gets the provoking corner's.
bool ProgramBuilder::interpolates_outputs(const core::Program& program) const {
  const bool names_things = std::any_of(program.fields.begin(), program.fields.end(), [](const capture::Field& field) {
    return field.location >= 0 && capture::is_integer(field.type);
  });
  return program.traits.reads_vertex_id || program.traits.writes_cull_distance || (traits_.transparent && names_things);
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
  const bool refines = !interpolates_outputs(program) && key.refinement != core::Refinement::linear_outputs;
  const bool curved = key.welded && is_curved(key.refinement) && refines;
  const bool displaced = key.border && coordinate_field >= 0 && refines;
  words.controls = curved && fits({.controls = true}, stored);
  words.turns = key.turns && fits({words.controls, true}, stored);
  if (displaced && fits({words.controls, words.turns, coordinate_field}, stored)) {
    words.displaced_by = coordinate_field;
  }
  if (words.controls != curved || words.turns != key.turns || (displaced && words.displaced_by < 0)) {
    core::log(core::LogLevel::info,
              label(program) +
                  ": its vertex attributes leave no room for what welded edges need; where "
                  "normals or texture coordinates differ at an edge, its triangles may part there");
  }
  return words;
}

std::shared_ptr<core::DerivedProgram> ProgramBuilder::derive(core::Program& program, core::Program* owner,
                                                             const core::DerivedKey& key) const {
  const auto found = program.derived.find(key);
  if (found != program.derived.end()) {
    return found->second;
  }
  std::shared_ptr<core::DerivedProgram>& slot = program.derived[key];
  DeriveRequest request;
  request.vertex_sources = vertex_sources(program);
  request.es = traits_.language == capture::Language::es;
  request.context_glsl_version = traits_.glsl_version;
  std::vector<capture::Field> fields = program.fields;
  add_shape_fields(fields, key, program.fixed_function, request);
  request.scalar_tags = traits_.scalar_tags;
  const capture::WeldedWords welded = welded_words(program, fields, request.coordinate_field, key);
  request.layout = capture::make_layout(std::move(fields), key.tagged, welded);
  request.refinement = interpolates_outputs(program) ? core::Refinement::linear_outputs : key.refinement;
  request.at_corner = key.at_corner;
  request.placed = key.placed;
  request.morphing = key.morphing;
  request.provoking_corner = key.provoking_corner;
  request.outputs = {key.flat_colors, key.clamp_colors, words_of_positions(geometry_sources(program))};
  // There is no gl_VertexID between corners: the stage runs on these, and the refinement shader is ignored.
  if (!key.at_corner && !program.traits.reads_vertex_id) {
    request.refinement_source = program.refinement_source;
  }
  request.extensions = traits_.extensions;
  request.stored = !key.at_corner && request.layout.chunk_count() > most_chunks(key.placed);
  Derivation derivation;
  if (request.layout.corner_words > traits_.max_feedback_components) {
    derivation.error = "its vertex attributes leave no room for scalar tags";
  } else if (key.at_corner || !request.stored || can_store_records(program)) {
    derivation = derive_vertex_stage(request);
  } else {
    derivation.error = "its vertex attributes leave no room for depth tags and placement";
  }
  std::string error = derivation.error;
  for (std::size_t i = 0; i < derivation.vertex_sources.size() && core::wants_shaders(); ++i) {
    show(program, GL_VERTEX_SHADER, kind_of(key, request.refinement), static_cast<unsigned>(i),
         derivation.vertex_sources[i]);
  }
  const GLuint name = derivation.ok ? compile_and_link(program, derivation.vertex_sources,
                                                       owner != nullptr ? owner->name : 0, key, error)
                                    : 0;
  program.refinement_log = error;
  if (name == 0) {
    ++core::statistics().programs_failed;
    core::log(core::LogLevel::warning, label(program) + " is not refined: " + error + "; its draws stay as they are");
    return nullptr;
  }
  slot = std::make_shared<core::DerivedProgram>();
  slot->name = name;
  slot->layout = std::move(request.layout);
  slot->height_map = gl_.GetUniformLocation(name, height_map_uniform);
  slot->height_channel = gl_.GetUniformLocation(name, height_channel_uniform);
  slot->height_range = gl_.GetUniformLocation(name, height_range_uniform);
  if (request.stored) {
    slot->first_word = gl_.GetUniformLocation(name, first_word_uniform);
    slot->numbered = gl_.GetAttribLocation(name, instance_input) >= 0;
    if (gl_.ShaderStorageBlockBinding != nullptr) {
      gl_.ShaderStorageBlockBinding(name, gl_.GetProgramResourceIndex(name, GL_SHADER_STORAGE_BLOCK, records_block),
                                    records_binding);
    }
  }
  // Whatever runs at corners alone has no refinement shader, so none of its uniforms.
  const auto other = std::find_if(program.derived.begin(), program.derived.end(), [&](const auto& entry) {
    return entry.second != nullptr && entry.second != slot && !entry.first.at_corner;
  });
  copy_virtual_uniforms(gl_, program.virtual_uniforms, other != program.derived.end() ? other->second.get() : nullptr,
                        *slot);
  if (owner != nullptr) {
    map_uniform_locations(gl_, owner->name, *slot);
    copy_uniform_values(gl_, owner->name, *slot);
    copy_block_bindings(gl_, owner->name, name);
    slot->subroutines = map_subroutines(gl_, *owner, name);
    owner->mirrors.push_back({name, slot.get()});
  }
  ++core::statistics().programs_derived;
  return slot;
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
