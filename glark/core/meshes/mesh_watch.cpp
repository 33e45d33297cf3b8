// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/mesh_watch.h"

#include "glark/core/capture/layout.h"
#include "glark/core/state/lists/display_list.h"

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

}  // namespace

std::optional<Cause> MeshWatch::judge(const DrawCall& call, const std::vector<capture::Field>* fields,
                                      std::optional<Cause> cause) {
  if (!cause && !has_normals(call, *fields)) {
    cause = Cause::no_surface;
  }
  Framebuffers& framebuffers = env_.state.framebuffers();
  const std::optional<MeshPass> pass = mesh_pass({.bindings = env_.bindings(),
                                                  .depth_buffer = framebuffers.bound_has_depth(env_.gl, env_.errors),
                                                  .color_buffer = framebuffers.bound_has_colors(env_.gl, env_.errors)},
                                                 cause);
  const bool matters = pass && (pass->curves || pass->uses_depth || pass->must_meet());
  if (!matters) {
    return cause;
  }
  if (call.list_segment != 0) {
    return ask(mesh_of_list(call.list_segment), *pass, cause);
  }
  if (!call.from_arrays) {
    return cause == Cause::not_triangles ? cause : ask(loose_mesh, *pass, cause);
  }
  fields = fields != nullptr ? fields : known_fields();
  const capture::Field* position = fields != nullptr ? capture::find_role(*fields, capture::Role::position) : nullptr;
  if (position != nullptr || fields == nullptr) {
    return ask(key_of(position != nullptr ? slot_of(*position) : vertex_slot_in_use()), *pass, cause);
  }
  for (const capture::Field& field : *fields) {
    if (is_float_vector(field)) {
      cause = ask(key_of(slot_of(field)), *pass, cause);
    }
  }
  return cause;
}

std::optional<Cause> MeshWatch::ask(const MeshKey& key, const MeshPass& pass, std::optional<Cause> cause) {
  const MeshVerdict verdict = table_.draw(key, pass);
  return cause || verdict == MeshVerdict::curved ? cause : cause_of(verdict);
}

// The same normal at every vertex tells nothing about a surface: the array is off, or the list sets no normals.
bool MeshWatch::has_normals(const DrawCall& call, const std::vector<capture::Field>& fields) const {
  const capture::Field* normal = capture::find_role(fields, capture::Role::normal);
  const int slot = normal != nullptr ? slot_of(*normal) : no_slot;
  if (slot == no_slot) {
    return false;
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

MeshKey MeshWatch::key_of(int position_slot) const {
  const int slot = position_slot == vertex_slot || position_slot == 0 ? vertex_slot_in_use() : position_slot;
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
