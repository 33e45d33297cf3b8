// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The capture of a draw, and what is kept of it for the next time: the same call on the same arrays of unwritten buffers, or the
// same segment of a display list with the same inherited values.
#include <algorithm>
#include <string_view>

#include "glark/core/context.h"
#include "glark/core/input_slots.h"
#include "glark/core/pipeline.h"

namespace glark::core {
namespace {

// Of the records of a kept capture; the last vec4 chunk may read past the last record.
GLsizeiptr bytes_to_keep(const capture::Layout& layout, std::uint64_t triangles) {
  return static_cast<GLsizeiptr>(triangles) * layout.triangle_words() * 4 + 16;
}

int builtin_slot(std::string_view name) {
  constexpr std::string_view texture = "gl_MultiTexCoord";
  if (name.starts_with(texture)) {
    return texture_coordinate_slot + (name.back() - '0');
  }
  return name == "gl_Vertex"           ? vertex_slot
         : name == "gl_Normal"         ? normal_slot
         : name == "gl_Color"          ? color_slot
         : name == "gl_SecondaryColor" ? secondary_color_slot
         : name == "gl_FogCoord"       ? fog_coordinate_slot
                                       : no_slot;
}

// System values follow from the call.
bool is_shared(const capture::Field& field) {
  return field.name == "gl_VertexID" || field.name == "gl_InstanceID" || field.name == "gl_BaseVertex" ||
         field.name == "gl_BaseInstance" || field.name == "gl_DrawID";
}

// Whether what is written to the buffer is noticed.
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

}  // namespace

// The attributes that a capture of `layout` reads; one that is not followed stands as no_slot.
std::vector<int> input_slots(const capture::Layout& layout, GLuint tag_attribute) {
  std::vector<int> slots;
  for (const capture::Field& field : layout.fields) {
    if (is_shared(field)) {
      continue;
    }
    if (capture::is_builtin(field)) {
      slots.push_back(builtin_slot(field.name));
      continue;
    }
    for (int i = 0; i < capture::columns_of(field.type) * field.array_size; ++i) {
      slots.push_back(generic_slot(static_cast<GLuint>(field.location + i)));
    }
  }
  if (layout.tagged) {
    slots.push_back(generic_slot(tag_attribute));
  }
  return slots;
}

// False: it reads what cannot be watched.
bool Pipeline::add_array_inputs(const Plan& plan, const ArrayDraw& draw) {
  if (context_.state().bindings().primitive_restart || context_.state().bindings().primitive_restart_fixed) {
    return false;
  }
  key_.add(draw.mode, draw.index_type);
  key_.add(static_cast<std::uint32_t>(draw.first), static_cast<std::uint32_t>(draw.count));
  key_.add(static_cast<std::uint32_t>(draw.instances), draw.base_instance);
  if (draw.index_type != 0) {
    key_.add(reinterpret_cast<std::uint64_t>(draw.indices));
    key_.add(static_cast<std::uint32_t>(draw.base_vertex));
    const BoundBuffer& elements = context_.state().element_buffer();
    if (!key_.add_buffer(elements.name, elements.generation)) {
      return false;
    }
  }
  for (int slot : *plan.inputs) {
    if (slot == no_slot) {
      return false;
    }
    // In compatibility contexts glVertexPointer and attribute 0 are one, and the attribute goes first.
    if (context_.is_compatibility() && (slot == vertex_slot || slot == 0)) {
      slot = context_.state().attribute_source(0).enabled ? 0 : static_cast<int>(vertex_slot);
      if (!context_.state().attribute_source(slot).enabled) {
        return false;
      }
    }
    const AttributeSource& source = context_.state().attribute_source(slot);
    if (!source.enabled) {
      key_.add_value(slot, context_.state().current_values());
    } else if (!key_.add_source(slot, source)) {
      return false;
    }
  }
  return true;
}

bool Pipeline::add_segment_inputs(const Plan& plan, const ListSegment& segment) {
  key_.add(segment.identity);
  for (const int slot : *plan.inputs) {
    if (slot == no_slot) {
      return false;
    }
    const bool is_vertex = slot == vertex_slot || slot == 0;  // lists are of compatibility contexts: the two are one
    if (!is_vertex && (segment.effects.own & slot_bit(slot)) == 0) {
      key_.add_value(slot, context_.state().current_values());
    }
  }
  return true;
}

// The same words are captured whichever of them are positions, normals and coordinates to the program or the application.
void Pipeline::add_welded_words(const Plan& plan) {
  const capture::Field* position = capture::find_role(plan.layout->fields, capture::Role::position);
  key_.add(static_cast<std::uint32_t>(position->offset),
           static_cast<std::uint32_t>(capture::normal_offset(plan.layout->fields)));
  key_.add(static_cast<std::uint32_t>(plan.layout->coordinate_offset));
}

// All that decides what is captured, and for adaptive draws how it is sorted. False: nothing of this draw can be kept.
bool Pipeline::make_key(const DrawCall& call, const Plan& plan) {
  if ((!call.exact || call.arrays == nullptr) && call.segment == nullptr) {
    return false;
  }
  key_.clear();
  key_.add(plan.capture_program,
           plan.last_vertex_convention ? GL_LAST_VERTEX_CONVENTION : context_.state().bindings().provoking_vertex);
  key_.add(plan.keeps_bins() ? 1 : 0, (context_.ark().smooth_interior ? 1U : 0U) | (plan.polygons ? 2U : 0U) |
                                          (plan.morphing ? 4U : 0U) | (plan.welded ? 8U : 0U));
  key_.add(plan.keeps_bins() ? pools_built_ : 0);
  if (plan.welded) {
    add_welded_words(plan);
  }
  return call.segment != nullptr ? add_segment_inputs(plan, *call.segment) : add_array_inputs(plan, *call.arrays);
}

Pipeline::Keeping Pipeline::look_up(const DrawCall& call, const Plan& plan) {
  if (!make_key(call, plan)) {
    return {};
  }
  if (context_.state().programs().current() != nullptr && context_.state().programs().current()->may_store) {
    context_.writes().by_gpu();  // by its earlier draws
  }
  const auto [answer, entry] = kept_.look_up(gl_, key_, context_.share().buffers);
  if (answer == DrawCache::Answer::kept) {
    return {entry, true};
  }
  // How much was captured has to be read back, and the application counts the same just now.
  if (answer == DrawCache::Answer::fresh || context_.state().bindings().primitives_written_query != 0) {
    return {};
  }
  ErrorScope errors(context_.pending_error());
  const bool all_watched = std::all_of(key_.buffers().begin(), key_.buffers().end(),
                                       [&](GLuint buffer) { return watched(gl_, context_.share().buffers, buffer); });
  const GLsizeiptr bytes = plan.keeps_bins() ? 0 : bytes_to_keep(*plan.layout, call.triangles);
  if (!all_watched || !kept_.make_room(gl_, *entry, bytes) || !kept_.allocate(gl_, *entry, bytes)) {
    entry->refused = true;
    return {};
  }
  return {entry, false};
}

capture::CoarseTriangles Pipeline::capture_draw(const DrawCall& call, const Plan& plan, Keeping& keeping,
                                                const Quiet& quiet) {
  if (keeping.filled) {
    ++statistics().captures_reused;
    return keeping.entry->triangles;
  }
  ++statistics().captures_made;
  const bool own = keeping.entry != nullptr && !plan.keeps_bins();
  const capture::Count count = keeping.entry != nullptr ? capture::Count::checked
                               : call.exact             ? capture::Count::known
                                                        : capture::Count::by_query;
  const auto capture = [&] {
    begin_capture(plan, count, own ? &keeping.entry->buffer : nullptr);
    quiet.interrupt();
    call.issue();
    quiet.hush();
    return end_capture(plan, call.triangles, call.exact);
  };
  capture::CoarseTriangles triangles = capture();
  // An error is this draw's own, or one that was there before it: the second time there is none before it.
  if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR) {
    context_.raise(error);
    triangles = capture();
    if (gl_.GetError() != GL_NO_ERROR) {  // GL rejects it: it draws nothing, and counts nothing
      add_surplus(call.exact ? -2 * static_cast<std::int64_t>(call.triangles) : 0);
      keeping.entry = nullptr;
      return {};
    }
  }
  // GL may have drawn nothing: conditional rendering, an incomplete framebuffer, a mapped buffer.
  if (keeping.entry != nullptr && (call.exact ? triangles.count != call.triangles : triangles.count == 0)) {
    keeping.entry = nullptr;
  }
  if (own && keeping.entry != nullptr) {
    keeping.entry->triangles = triangles;
    keeping.entry->filled = true;
  }
  return triangles;
}

bool Pipeline::takes_edge_flags() const {
  return context_.is_compatibility() && context_.state().bindings().polygon_mode != GL_FILL;
}

void Pipeline::begin_capture(const Plan& plan, capture::Count count, GpuBuffer* own) {
  if (count == capture::Count::by_query && context_.options().read_counts) {
    read_uncounted();  // its query is used again
  }
  if (plan.last_vertex_convention) {
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
  }
  if (takes_edge_flags()) {
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);  // Mesa 22 captures nothing of vertices with edge flags of their own
  }
  capture_.begin(plan.capture_program, context_.state().bindings(), count, own);
}

capture::CoarseTriangles Pipeline::end_capture(const Plan& plan, std::uint64_t triangles, bool exact) {
  const Bindings& b = context_.state().bindings();
  const capture::CoarseTriangles captured = capture_.end(*plan.layout, triangles, b);
  if (plan.last_vertex_convention) {
    gl_.ProvokingVertex(b.provoking_vertex);
  }
  if (takes_edge_flags()) {
    gl_.PolygonMode(GL_FRONT, b.front_polygon_mode);
    gl_.PolygonMode(GL_BACK, b.back_polygon_mode);
  }
  // The application's queries have counted the capture too. Only here, and if GL alone knows the number, it is read back.
  if (b.primitives_generated_query != 0 || b.primitives_written_query != 0) {
    add_surplus(static_cast<std::int64_t>(exact ? triangles : capture_.counted(b)));
  }
  if (triangles > 0) {
    weld(plan, captured, capture_.count_command(), false);
  }
  return captured;
}

void Pipeline::add_surplus(std::int64_t triangles) {
  for (const GLuint query :
       {context_.state().bindings().primitives_generated_query, context_.state().bindings().primitives_written_query}) {
    if (query != 0) {
      context_.state().query_surplus().add(query, triangles);  // modulo 2^64
    }
  }
}

// The bins of an adaptive draw: kept ones, or those that are made now, which may then be kept.
depth::BinnedInstances Pipeline::binned(const Plan& plan, const Records& records, const Keeping& keeping) {
  if (!plan.keeps_bins()) {
    return sort(plan, records);
  }
  if (keeping.filled) {
    statistics().refined_triangles += keeping.entry->refined_triangles;
    return keeping.entry->bins;
  }
  const depth::BinnedInstances bins = sort(plan, records);
  if (keeping.entry == nullptr) {
    return bins;
  }
  ErrorScope errors(context_.pending_error());
  DrawCache::Entry& entry = *keeping.entry;
  const bool in_order = takes_in_order(plan, records.triangles);
  const depth::InstanceExtent extent = in_order ? ordered_.extent(bins) : bins_.extent(bins);
  if (!kept_.make_room(gl_, entry, extent.bytes) || !kept_.allocate(gl_, entry, extent.bytes)) {
    entry.refused = true;
    return bins;
  }
  entry.bins = depth::copy_instances(gl_, bins, extent, entry.buffer);
  entry.triangles = records.triangles;
  entry.refined_triangles = extent.refined_triangles;
  entry.filled = true;
  return bins;
}

std::vector<GLuint> Pipeline::take_kept_buffers() { return kept_.take_buffers(); }

}  // namespace glark::core
