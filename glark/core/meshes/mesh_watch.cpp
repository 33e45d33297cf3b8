// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/mesh_watch.h"

#include <algorithm>

#include "glark/core/capture/layout.h"
#include "glark/core/meshes/buffer_points.h"
#include "glark/core/meshes/directions.h"
#include "glark/core/state/lists/display_list.h"
#include "glark/core/state/programs/derived_program.h"

namespace glark::core {
namespace {

int slot_of(const capture::Field& field) {
  return field.location >= 0         ? generic_slot(static_cast<GLuint>(field.location))
         : field.name == "gl_Vertex" ? static_cast<int>(vertex_slot)
         : field.name == "gl_Normal" ? static_cast<int>(normal_slot)
                                     : static_cast<int>(no_slot);
}

// May hold positions in a program whose position glark could not guess.
bool is_float_vector(const capture::Field& field) {
  return field.location >= 0 && !field.is_array &&
         (field.type == GL_FLOAT_VEC2 || field.type == GL_FLOAT_VEC3 || field.type == GL_FLOAT_VEC4);
}

Cause cause_of(MeshVerdict verdict) {
  return verdict == MeshVerdict::waits  ? Cause::mesh_waits
         : verdict == MeshVerdict::flat ? Cause::mesh_flat
                                        : Cause::unknown_partner;
}

bool has_made_normals(const std::vector<capture::Field>* fields) {
  const capture::Field* normal = fields != nullptr ? capture::find_role(*fields, capture::Role::normal) : nullptr;
  return normal != nullptr && normal->made;
}

// A polygon that glBegin..glEnd draws alone. Its neighbours are other draws, so nothing says whether it is a part of a
// smooth surface or the panel of a body whose edges would come apart. A display list draws each polygon apart, too.
bool is_lone_polygon(const DrawCall& call) {
  const bool polygon = call.mode == GL_POLYGON ? call.whole_polygons : is_one_polygon(call.triangles);
  return !call.from_arrays && call.exact && polygon;
}

bool is_position_vector(const capture::Field* position) {
  return position != nullptr && !position->is_array &&
         (position->type == GL_FLOAT_VEC3 || position->type == GL_FLOAT_VEC4);
}

}  // namespace

bool may_make_normals(const ContextOptions& options, const std::vector<capture::Field>& fields) {
  return options.geometry_normals && options.weld &&
         is_position_vector(capture::find_role(fields, capture::Role::position));
}

std::optional<Cause> MeshWatch::judge(const DrawCall& call, const Inputs& inputs, std::optional<Cause> cause) {
  const bool lone_polygon = is_lone_polygon(call);
  const bool may_curve = !cause || cause == Cause::compiling;
  if (may_curve && (lone_polygon || (!cause && (!has_normals(call, inputs) || is_moved_by_offsets(call, inputs))))) {
    cause = Cause::no_surface;
  }
  Framebuffers& framebuffers = env_.state.framebuffers();
  std::optional<MeshPass> pass = mesh_pass({.bindings = env_.bindings(),
                                            .depth_buffer = framebuffers.bound_has_depth(env_.gl, env_.errors),
                                            .color_buffer = framebuffers.bound_has_colors(env_.gl, env_.errors),
                                            .triangles = call.triangles,
                                            .framebuffer = framebuffers.bound_name(),
                                            .stencil = framebuffers.bound_stencil(env_.gl, env_.errors),
                                            .fragment_depth = computes_depth(call)},
                                           cause);
  const bool matters = pass && (pass->curves || pass->uses_depth || pass->must_meet());
  if (!matters) {
    return cause;
  }
  pass->made = pass->curves && has_made_normals(inputs.fields);
  pass->lone = lone_polygon;
  pass->open = call.triangles == 0;
  note_overlay(call, *pass);
  return call.list_segment != 0 ? ask(mesh_of_list(call.list_segment), *pass, cause)
         : call.from_arrays     ? judge_arrays(inputs, *pass, cause)
                                : judge_loose(*pass, cause);
}

// Only asked for quads without colours: it reads the source.
bool MeshWatch::computes_depth(const DrawCall& call) const {
  const Program* current = env_.state.programs().current().get();
  const bool shows = env_.bindings().color_writes && env_.state.framebuffers().bound_has_colors(env_.gl, env_.errors);
  const bool quad = call.triangles > 0 && call.triangles <= 2;
  return !shows && quad && current != nullptr &&
         std::any_of(current->stages.begin(), current->stages.end(), [](const StageSource& source) {
           return source.stage == GL_FRAGMENT_SHADER && source.source->find("gl_FragDepth") != std::string::npos;
         });
}

std::optional<Cause> MeshWatch::judge_loose(const MeshPass& pass, std::optional<Cause> cause) {
  if (pass.curves && !pass.made) {
    table_.set_normals(loose_mesh, {loose_mesh, GL_FLOAT});
  }
  return cause == Cause::not_triangles ? cause : ask(loose_mesh, pass, cause);
}

std::optional<Cause> MeshWatch::judge_arrays(const Inputs& inputs, MeshPass pass, std::optional<Cause> cause) {
  const std::vector<capture::Field>* fields = inputs.fields != nullptr ? inputs.fields : known_fields();
  const capture::Field* position = fields != nullptr ? capture::find_role(*fields, capture::Role::position) : nullptr;
  if (position != nullptr || fields == nullptr) {
    const int slot = position != nullptr ? slot_of(*position) : vertex_slot_in_use();
    const MeshKey mesh = key_of(slot);
    if (pass.curves && !inputs.lent_normal && !pass.made) {
      note_normals(mesh, slot, *fields);
    }
    pass.lacks_normal = cause == Cause::no_surface;
    if (pass.curves && is_overlaid(mesh, slot)) {
      table_.keep_flat(mesh);
    }
    return ask(mesh, pass, cause);
  }
  for (const capture::Field& field : *fields) {
    if (is_float_vector(field)) {
      cause = ask(key_of(slot_of(field)), pass, cause);
    }
  }
  return cause;
}

// The stage moves vertices by the normal, and this one is an offset.
bool MeshWatch::is_moved_by_offsets(const DrawCall& call, const Inputs& inputs) {
  const Program* current = env_.state.programs().current().get();
  const refine::OutputVariation* position = current != nullptr ? current->traits.variation.position() : nullptr;
  const capture::Field* normal = capture::find_role(*inputs.fields, capture::Role::normal);
  if (position == nullptr || normal == nullptr || !position->inputs.contains(normal->name) || !call.from_arrays ||
      slot_of(*normal) == no_slot) {
    return false;
  }
  const AttributeSource& source = env_.state.arrays().attribute_source(slot_of(*normal));
  if (!has_points(source)) {
    return false;
  }
  const MeshKey key = mesh_of(source, packed_stride(source.size, source.type));
  const auto known = moves_by_offsets_.find(key);
  if (known != moves_by_offsets_.end() || moves_by_offsets_.size() == Overlays::most_sources) {
    return known != moves_by_offsets_.end() && known->second;
  }
  const bool moves = !are_directions(read_points(env_.gl, env_.errors, source));
  moves_by_offsets_.emplace(key, moves);
  return moves;
}

// The vertex stage does more than to transform positions. So it makes quads of thick lines.
bool MeshWatch::places_vertices_itself() const {
  const Program* current = env_.state.programs().current().get();
  const refine::OutputVariation* position = current != nullptr ? current->traits.variation.position() : nullptr;
  return position != nullptr && position->variation > refine::Variation::affine;
}

// Lines may lie on a mesh, also those that are drawn as quads. Thick lines have two arrays with points, one for each end.
void MeshWatch::note_overlay(const DrawCall& call, const MeshPass& pass) {
  const bool may_lie_on_meshes =
      pass.shows && pass.uses_depth && !pass.curves && !pass.compiles && (pass.lines || places_vertices_itself());
  if (!may_lie_on_meshes || !call.from_arrays || call.list_segment != 0 || call.mode == GL_POINTS) {
    return;
  }
  const int count = std::min(env_.capabilities.max_vertex_attributes, generic_slots);
  for (int slot = 0; slot < count; ++slot) {
    note_overlay_array(slot);
  }
  if (env_.capabilities.is_compatibility()) {
    note_overlay_array(vertex_slot);
  }
}

void MeshWatch::note_overlay_array(int slot) {
  const AttributeSource& source = env_.state.arrays().attribute_source(slot);
  if (has_points(source)) {
    const MeshKey key = mesh_of(source, packed_stride(source.size, source.type));
    if (overlays_.wants_overlay(key)) {
      overlays_.add_overlay(key, read_points(env_.gl, env_.errors, source));
    }
  }
}

bool MeshWatch::is_overlaid(const MeshKey& mesh, int position_slot) {
  const int slot = slot_in_use(position_slot);
  if (slot == no_slot) {
    return false;
  }
  const AttributeSource& source = env_.state.arrays().attribute_source(slot);
  if (has_points(source) && overlays_.wants_mesh(mesh)) {
    overlays_.add_mesh(mesh, read_points(env_.gl, env_.errors, source));
  }
  return overlays_.covers(mesh);
}

std::optional<Cause> MeshWatch::ask(const MeshKey& key, const MeshPass& pass, std::optional<Cause> cause) {
  const MeshVerdict verdict = table_.draw(key, pass);
  return cause || verdict == MeshVerdict::curved ? cause : cause_of(verdict);
}

namespace {

NormalSource normals_of(const AttributeSource& source) {
  const GLint size = source.size != 0 ? source.size : 3;  // GL gives no size for glNormalPointer
  return {mesh_of(source, packed_stride(size, source.type)), source.type, source.normalized};
}

bool reads(const std::vector<capture::Field>& fields, int location) {
  return std::any_of(fields.begin(), fields.end(), [location](const capture::Field& field) {
    return field.location >= 0 && location >= field.location &&
           location < field.location + capture::columns_of(field.type) * field.array_size;
  });
}

}  // namespace

void MeshWatch::note_normals(const MeshKey& mesh, int position_slot, const std::vector<capture::Field>& fields) {
  const capture::Field* normal = capture::find_role(fields, capture::Role::normal);
  ArrayState& arrays = env_.state.arrays();
  const AttributeSource& normals = arrays.attribute_source(slot_of(*normal));
  table_.set_normals(mesh, normals_of(normals));
  const int slot = slot_in_use(position_slot);
  if (slot != no_slot) {
    NormalsBeside& beside = table_.normals_beside(mesh);
    const AttributeSource& lender = beside.lender();
    const bool lives = env_.share.buffers.generation(lender.buffer) == lender.generation;
    beside.note(arrays.attribute_source(slot), normals, lives);
  }
}

MeshWatch::ChosenNormal MeshWatch::unread_normal(const DrawCall& call,
                                                 const std::vector<capture::Field>& fields) const {
  const capture::Field* position = capture::find_role(fields, capture::Role::position);
  if (!is_position_vector(position) || capture::find_role(fields, capture::Role::normal) != nullptr) {
    return {};
  }
  const bool conventional = position->name == "gl_Vertex";
  if (call.segment != nullptr) {
    const bool sets_normals = (call.segment->effects.set & slot_bit(normal_slot)) != 0;
    return {.attribute = conventional && sets_normals ? conventional_normal : own_normal};
  }
  if (!call.from_arrays) {
    return {};
  }
  const MeshKey mesh = key_of(slot_of(*position));
  const NormalSource& wanted = table_.normals(mesh);
  const int enabled = wanted.type != 0 ? find_array(wanted, fields) : own_normal;
  return enabled != own_normal ? ChosenNormal{.attribute = enabled} : find_lender(mesh, slot_of(*position), fields);
}

// The application has not enabled the normals for this pass.
MeshWatch::ChosenNormal MeshWatch::find_lender(const MeshKey& mesh, int position_slot,
                                               const std::vector<capture::Field>& fields) const {
  const int slot = slot_in_use(position_slot);
  if (mesh == loose_mesh || slot == no_slot) {
    return {};
  }
  const std::optional<AttributeSource> lent =
      table_.normals_beside(mesh).find(env_.state.arrays().attribute_source(slot));
  if (!lent || env_.share.buffers.generation(lent->buffer) != lent->generation) {
    return {};
  }
  const int location = free_location(fields);
  return location != own_normal ? ChosenNormal{location, lent} : ChosenNormal{};
}

// The tags of the extension take the last three attributes.
int MeshWatch::free_location(const std::vector<capture::Field>& fields) const {
  const auto tags = static_cast<int>(env_.ark.scalar_tag_attribute);
  for (int location = std::min(tags, generic_slots) - 1; location > 0; --location) {
    if (!reads(fields, location) &&
        is_initial(env_.state.arrays().attribute_source(location), static_cast<GLuint>(location))) {
      return location;
    }
  }
  return own_normal;
}

// Returns whether glark makes normals for the draw, because no pass has any. A pass without colours only gets them if
// another pass shows the same mesh: a shadow volume is no surface.
bool MeshWatch::makes_normals(const DrawCall& call, const std::vector<capture::Field>& fields) const {
  if (!may_make_normals(env_.options, fields) || has_normals(call, {.fields = &fields})) {
    return false;
  }
  const MeshKey mesh = mesh_of_draw(call, fields);
  const bool colors = env_.bindings().color_writes && env_.state.framebuffers().bound_has_colors(env_.gl, env_.errors);
  const bool shows = colors || (!(mesh == loose_mesh) && table_.shown(mesh));
  return shows && table_.normals(mesh).type == 0;
}

MeshWatch::ChosenNormal MeshWatch::choose_normal(const DrawCall& call,
                                                 const std::vector<capture::Field>& fields) const {
  if (!env_.options.smooth) {
    const bool made = may_make_normals(env_.options, fields) && capture::normal_offset(fields) < 0;
    return {.attribute = made ? made_normal : own_normal};
  }
  const ChosenNormal unread = unread_normal(call, fields);
  return unread.attribute == own_normal && makes_normals(call, fields) ? ChosenNormal{.attribute = made_normal}
                                                                       : unread;
}

MeshKey MeshWatch::mesh_of_draw(const DrawCall& call, const std::vector<capture::Field>& fields) const {
  const capture::Field* position = capture::find_role(fields, capture::Role::position);
  return call.list_segment != 0                    ? mesh_of_list(call.list_segment)
         : call.from_arrays && position != nullptr ? key_of(slot_of(*position))
                                                   : loose_mesh;
}

bool MeshWatch::is_curved(const DrawCall& call, const std::vector<capture::Field>& fields) const {
  return table_.is_curved(mesh_of_draw(call, fields));
}

bool MeshWatch::is_nearly_watched(const DrawCall& call, const std::vector<capture::Field>& fields) const {
  return table_.is_nearly_watched(mesh_of_draw(call, fields));
}

void MeshWatch::compiles(const DrawCall& call, const std::vector<capture::Field>& fields) {
  table_.compiles(mesh_of_draw(call, fields));
}

bool MeshWatch::mesh_wrote_depth(const DrawCall& call, const std::vector<capture::Field>& fields) const {
  return table_.wrote_depth(mesh_of_draw(call, fields));
}

int MeshWatch::find_array(const NormalSource& wanted, const std::vector<capture::Field>& fields) const {
  const auto matches = [&](int slot) {
    const AttributeSource& source = env_.state.arrays().attribute_source(slot);
    return source.enabled && normals_of(source) == wanted;
  };
  if (env_.capabilities.is_compatibility() && matches(normal_slot)) {
    return conventional_normal;
  }
  const int count = std::min(env_.capabilities.max_vertex_attributes, generic_slots);
  for (int location = 0; location < count; ++location) {
    if (!reads(fields, location) && matches(location)) {
      return location;
    }
  }
  return own_normal;
}

// The same normal at every vertex tells nothing about a surface: the array is off, or the list sets no normals.
bool MeshWatch::has_normals(const DrawCall& call, const Inputs& inputs) const {
  const capture::Field* normal = capture::find_role(*inputs.fields, capture::Role::normal);
  if (normal != nullptr && normal->made) {
    return true;
  }
  const int slot = normal != nullptr ? slot_of(*normal) : no_slot;
  if (slot == no_slot || inputs.lent_normal) {
    return inputs.lent_normal;
  }
  if (call.from_arrays) {
    return env_.state.arrays().attribute_source(slot).enabled;
  }
  // A segment of arrays does not count its vertices: its normals are compiled with them.
  const ListSegment* segment = call.segment;
  return segment == nullptr || segment->vertices == 0 || (segment->effects.set & slot_bit(slot)) != 0;
}

// In compatibility contexts, glVertexPointer and attribute 0 are one attribute. The array of attribute 0 has
// precedence.
int MeshWatch::vertex_slot_in_use() const {
  return !env_.capabilities.is_compatibility() || env_.state.arrays().attribute_source(0).enabled
             ? 0
             : static_cast<int>(vertex_slot);
}

int MeshWatch::slot_in_use(int position_slot) const {
  return position_slot == vertex_slot || position_slot == 0 ? vertex_slot_in_use() : position_slot;
}

MeshKey MeshWatch::key_of(int position_slot) const {
  const int slot = slot_in_use(position_slot);
  if (slot == no_slot) {
    return loose_mesh;
  }
  const AttributeSource& source = env_.state.arrays().attribute_source(slot);
  return source.enabled ? mesh_of(source, packed_stride(source.size, source.type)) : loose_mesh;
}

// The inputs of the program in use, if an earlier draw made glark read them.
const std::vector<capture::Field>* MeshWatch::known_fields() const {
  const Program* current = env_.state.programs().current().get();
  return current != nullptr && current->prepared && !current->fields.empty() ? &current->fields : nullptr;
}

}  // namespace glark::core
