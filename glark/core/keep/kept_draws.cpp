// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/keep/kept_draws.h"

#include <algorithm>
#include <bit>

#include "glark/core/capture/layout.h"
#include "glark/core/state/lists/display_list.h"

namespace glark::core {
namespace {

// Bytes of the records of a kept capture. The last vec4 chunk may read past the last record.
std::int64_t bytes_to_keep(const capture::Layout& layout, std::uint64_t triangles) {
  return static_cast<std::int64_t>(triangles) * layout.triangle_words() * 4 + 16;
}

// Returns whether glark notices every write to the buffer.
bool watched(const gl::Dispatch& gl, const BufferStamps& stamps, GLuint buffer) {
  if (gl.IsBuffer(buffer) == GL_FALSE) {  // binding it would make it
    return false;
  }
  const CopyWriteBinding binding(gl, buffer);
  GLint flags = 0;
  gl.GetBufferParameteriv(GL_COPY_WRITE_BUFFER, GL_BUFFER_STORAGE_FLAGS,
                          &flags);  // stays 0 where there is no such storage
  return (flags & GL_MAP_PERSISTENT_BIT) == 0 && stamps.trusted(buffer);
}

// Core profiles refuse arrays without a buffer: their addresses mean nothing.
bool reads_client_memory(const Capabilities& capabilities) { return capabilities.api != Capabilities::Api::core; }

}  // namespace

// False: the draw reads an attribute that cannot be watched.
bool KeptDraws::add_arrays(const capture::CapturePlan& capture, const ArrayDraw& draw) {
  const bool fixed = env_.bindings().primitive_restart_fixed;
  if (env_.bindings().primitive_restart && !fixed && draw.index_type != 0) {
    return false;  // the index is not followed
  }
  key_.add(fixed ? 1 : 0);
  key_.add(draw.mode, draw.index_type);
  key_.add(static_cast<std::uint32_t>(draw.first), static_cast<std::uint32_t>(draw.count));
  key_.add(static_cast<std::uint32_t>(draw.instances), draw.base_instance);
  vertices_read_.reset();
  if (draw.index_type == 0) {
    vertices_read_ = vertices_read(draw, {});
  } else if (!add_indices(draw)) {
    return false;
  }
  const int lent = capture.lent ? generic_slot(capture.lent->attribute) : static_cast<int>(no_slot);
  return std::all_of(capture.inputs->begin(), capture.inputs->end(), [&](int slot) {
    return slot != no_slot && slot == lent ? key_.add_source(slot, capture.lent->source) : add_array_input(slot);
  });
}

bool KeptDraws::add_indices(const ArrayDraw& draw) {
  key_.add(static_cast<std::uint32_t>(draw.base_vertex));
  const BoundBuffer& elements = env_.state.arrays().element_buffer();
  if (elements.name != 0) {
    key_.add(reinterpret_cast<std::uint64_t>(draw.indices));
    return key_.add_buffer(elements.name, elements.generation);
  }
  const std::span<const std::byte> indices = client_indices(draw);
  if (indices.empty() || env_.bindings().primitive_restart_fixed || !reads_client_memory(env_.capabilities)) {
    return false;
  }
  vertices_read_ = vertices_read(draw, indices);
  key_.add_content(hash_of(indices));
  return true;
}

bool KeptDraws::add_client_array(int slot, const AttributeSource& source) {
  if (!vertices_read_ || !reads_client_memory(env_.capabilities)) {
    return false;
  }
  const std::span<const std::byte> bytes = bytes_read(slot, source, *vertices_read_);
  if (bytes.empty()) {
    return false;
  }
  key_.add_content(slot, source, hash_of(bytes));
  return true;
}

bool KeptDraws::add_array_input(int slot) {
  if (slot == no_slot) {
    return false;
  }
  // In compatibility contexts glVertexPointer and attribute 0 are one attribute; the array of attribute 0 has
  // precedence.
  if (env_.capabilities.is_compatibility() && (slot == vertex_slot || slot == 0)) {
    slot = env_.state.arrays().attribute_source(0).enabled ? 0 : static_cast<int>(vertex_slot);
    if (!env_.state.arrays().attribute_source(slot).enabled) {
      return false;
    }
  }
  const AttributeSource& source = env_.state.arrays().attribute_source(slot);
  if (!source.enabled) {
    key_.add_value(slot, env_.state.arrays().current_values());
    return true;
  }
  return source.buffer != 0 ? key_.add_source(slot, source) : add_client_array(slot, source);
}

bool KeptDraws::add_segment(const std::vector<int>& inputs, const ListSegment& segment) {
  key_.add(segment.identity);
  for (const int slot : inputs) {
    if (slot == no_slot) {
      return false;
    }
    // Only compatibility contexts have lists: there both slots are the same attribute.
    const bool is_vertex = slot == vertex_slot || slot == 0;
    if (!is_vertex && (segment.effects.own & slot_bit(slot)) == 0) {
      key_.add_value(slot, env_.state.arrays().current_values());
    }
  }
  return true;
}

// The capture does not depend on the roles of the attributes, but welding does: the roles are part of the key.
void KeptDraws::add_welded_words(const capture::Layout& layout) {
  const capture::Field* position = capture::find_role(layout.fields, capture::Role::position);
  key_.add(static_cast<std::uint32_t>(position->offset),
           static_cast<std::uint32_t>(capture::normal_offset(layout.fields)));
  key_.add(static_cast<std::uint32_t>(layout.coordinate_offset));
}

// The key holds everything that determines the capture and, if instances are kept, their order. False: nothing of this
// draw can be kept.
bool KeptDraws::make_key(const DrawCall& call, const KeyFacts& facts) {
  if (call.arrays == nullptr && call.segment == nullptr) {
    return false;
  }
  const capture::CapturePlan& capture = facts.capture;
  key_.clear();
  key_.add(capture.program, capture.convention != 0 ? capture.convention : env_.bindings().provoking_vertex);
  key_.add(facts.depth.keeps_instances() ? 1 : 0, static_cast<unsigned>(facts.depth.interior) |
                                                      (facts.split ? 4U : 0U) | (facts.welded ? 8U : 0U) |
                                                      (facts.cut ? 16U : 0U));
  key_.add(std::bit_cast<std::uint32_t>(facts.crease));
  key_.add(facts.depth.keeps_instances() ? facts.pool : 0);
  if (facts.welded) {
    add_welded_words(*capture.layout);
  }
  if (call.segment != nullptr) {
    return add_segment(*capture.inputs, *call.segment);
  }
  key_.add(call.commands.size());
  for (const std::uint32_t word : call.commands) {
    key_.add(word);
  }
  return add_arrays(capture, *call.arrays);
}

bool KeptDraws::all_watched() const {
  return std::all_of(key_.buffers().begin(), key_.buffers().end(),
                     [&](GLuint buffer) { return watched(env_.gl, env_.share.buffers, buffer); });
}

KeptDraw KeptDraws::find(const DrawCall& call, const KeyFacts& facts) {
  if (!make_key(call, facts)) {
    return {};
  }
  const std::shared_ptr<Program>& current = env_.state.programs().current();
  if (current != nullptr && current->may_store) {
    env_.share.buffers.gpu_wrote(env_.state.stamps().next());  // by the program's earlier draws
  }
  const auto [answer, entry] = cache_.look_up(env_.gl, key_, env_.share.buffers);
  if (answer == DrawCache::Answer::kept) {
    return {entry, true};
  }
  // Keeping a capture reads its size from a query that the application has open at the moment.
  if (answer == DrawCache::Answer::fresh || env_.bindings().queries.written() != 0) {
    return {};
  }
  ErrorScope errors(env_.errors);
  const std::int64_t bytes = facts.depth.keeps_instances() ? 0 : bytes_to_keep(*facts.capture.layout, call.triangles);
  if (!all_watched() || !cache_.make_room(env_.gl, *entry, bytes) || !cache_.allocate(env_.gl, *entry, bytes)) {
    entry->refused = true;
    return {};
  }
  return {entry, false};
}

void KeptDraws::keep_capture(KeptDraw& kept, const DrawCall& call, const KeyFacts& facts,
                             const capture::CoarseTriangles& triangles) {
  // GL may have drawn nothing: conditional rendering, an incomplete framebuffer, a mapped buffer.
  if (kept.entry != nullptr && (call.exact ? triangles.count != call.triangles : triangles.count == 0)) {
    kept.entry = nullptr;
  }
  if (kept.entry != nullptr && !facts.depth.keeps_instances()) {
    kept.entry->triangles = triangles;
    kept.entry->filled = true;
  }
}

void KeptDraws::keep_instances(DrawCache::Entry& entry, const depth::BinnedInstances& instances,
                               const depth::InstanceExtent& extent, const capture::CoarseTriangles& triangles) {
  if (!cache_.make_room(env_.gl, entry, extent.bytes) || !cache_.allocate(env_.gl, entry, extent.bytes)) {
    entry.refused = true;
    return;
  }
  entry.bins = depth::copy_instances(env_.gl, instances, extent, entry.buffer);
  entry.triangles = triangles;
  entry.refined_triangles = extent.refined_triangles;
  entry.filled = true;
}

void KeptDraws::keep_view(DrawCache::Entry& entry, const depth::BinnedInstances& instances,
                          const depth::InstanceExtent& extent, std::uint64_t number) {
  const std::int64_t bytes = entry.buffer.size() + extent.bytes;
  if (!cache_.make_room(env_.gl, entry, bytes) || !cache_.allocate_view(env_.gl, entry, extent.bytes)) {
    entry.view.refused = true;
    return;
  }
  entry.view.bins = depth::copy_instances(env_.gl, instances, extent, entry.view.buffer);
  entry.view.refined_triangles = extent.refined_triangles;
  entry.view.number = number;
}

}  // namespace glark::core
