// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: Boubekeur 2007, ch. 7.2.3 (drawing a pattern in place of a triangle). The thesis binds an index buffer and
// sets uniforms per triangle; instancing draws all triangles of a pattern at once.
#include "glark/core/submit/submit.h"

#include <cstddef>
#include <cstdint>

namespace glark::submit {
namespace {

using refine::first_chunk_location;
using refine::lattice_location;
using refine::patch_location;

constexpr GLuint lattice_binding = 0;
constexpr GLuint patch_binding = 1;
constexpr GLuint record_binding = 2;
constexpr GLuint never_advance = 0x7fffffff;  // divisor: one patch for all instances of a draw
constexpr GLsizei patch_bytes = 16;
constexpr GLsizei chunk_bytes = 16;

const void* index_offset(std::uint32_t first_index) {
  return reinterpret_cast<const void*>(static_cast<std::size_t>(first_index) * 2);
}

}  // namespace

void SubmitStage::bind_vertex_array(int chunks, Source source, GLuint indices) {
  VertexArray& array = arrays_[{chunks, source}];
  const bool made = array.name != 0;
  if (!made) {
    gl_.GenVertexArrays(1, &array.name);
  }
  gl_.BindVertexArray(array.name);
  const std::uint32_t deletions = core::GpuBuffer::deletions();
  if (!made || array.indices != indices || array.deletions != deletions) {
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    array.indices = indices;
    array.deletions = deletions;
  }
  if (!made) {
    enable_inputs(chunks, source);
  }
}

void SubmitStage::enable_inputs(int chunks, Source source) {
  gl_.EnableVertexAttribArray(lattice_location);
  gl_.VertexAttribFormat(lattice_location, 2, GL_UNSIGNED_SHORT, GL_FALSE, 0);
  gl_.VertexAttribBinding(lattice_location, lattice_binding);
  GLuint location = patch_location;
  if (source != Source::whole) {
    gl_.EnableVertexAttribArray(patch_location);
    gl_.VertexAttribFormat(patch_location, 4, GL_FLOAT, GL_FALSE, 0);
    gl_.VertexAttribBinding(patch_location, patch_binding);
    gl_.VertexBindingDivisor(patch_binding, source == Source::uniform ? never_advance : 1);
    location = first_chunk_location;
  }
  if (source == Source::numbered) {
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribIFormat(location, 1, GL_UNSIGNED_INT, 0);
    gl_.VertexAttribBinding(location, record_binding);
  }
  for (int chunk = 0; chunk < chunks; ++chunk, ++location) {
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribFormat(location, 4, GL_FLOAT, GL_FALSE, static_cast<GLuint>(chunk * chunk_bytes));
    gl_.VertexAttribBinding(location, record_binding);
  }
  gl_.VertexBindingDivisor(record_binding, 1);
}

void SubmitStage::draw_uniform(const pattern::GpuPool& pool, const UniformDraw& draw) {
  const capture::CoarseTriangles& triangles = draw.triangles;
  bind_vertex_array(draw.stored ? 0 : draw.layout->chunk_count(), draw.placed ? Source::uniform : Source::whole,
                    pool.indices());
  gl_.BindVertexBuffer(lattice_binding, pool.vertices(), 0, sizeof(pattern::LatticeVertex));
  gl_.BindVertexBuffer(record_binding, triangles.buffer, triangles.offset, draw.layout->triangle_words() * 4);
  const unsigned piece_level = draw.level < static_cast<unsigned>(pattern::deepest_uniform)
                                   ? draw.level
                                   : static_cast<unsigned>(pattern::deepest_uniform);
  const pattern::Piece& piece = pool.piece(pattern::uniform_piece(static_cast<int>(piece_level)));
  const GLintptr command = pattern::GpuPool::command_of(piece_level);
  if (triangles.count_on_gpu) {
    constexpr GLintptr count_at = offsetof(capture::CountCommand, instance_count);
    pool.commands().copy_from(gl_, draw.count_command->name(), count_at, command + count_at, sizeof(std::uint32_t));
    gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, pool.commands().name());
  }
  const unsigned first = pattern::GpuPool::first_tile(draw.level);
  for (unsigned tile = 0; tile < pattern::GpuPool::tile_count(draw.level); ++tile) {
    if (draw.placed) {
      gl_.BindVertexBuffer(patch_binding, pool.patches(), static_cast<GLintptr>(first + tile) * patch_bytes,
                           patch_bytes);
    }
    if (triangles.count_on_gpu) {
      gl_.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(command));
    } else {
      gl_.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(piece.index_count), GL_UNSIGNED_SHORT,
                                index_offset(piece.first_index), static_cast<GLsizei>(triangles.count));
    }
  }
}

void SubmitStage::draw_points(const pattern::GpuPool& pool, const PointDraw& draw) {
  const InstanceSource& from = draw.source;
  const Source source = from.patches == 0 ? Source::whole : from.one_patch ? Source::uniform : Source::binned;
  bind_vertex_array(draw.chunks, source, draw.indices != 0 ? draw.indices : pool.indices());
  gl_.BindVertexBuffer(lattice_binding, pool.vertices(), 0, sizeof(pattern::LatticeVertex));
  gl_.BindVertexBuffer(record_binding, from.records, from.records_offset, from.record_stride);
  if (from.patches != 0) {
    gl_.BindVertexBuffer(patch_binding, from.patches, from.patches_offset, patch_bytes);
  }
  if (draw.indices == 0) {
    gl_.DrawArraysInstanced(GL_POINTS, draw.first, draw.count, draw.instances);
    return;
  }
  gl_.DrawElementsInstanced(GL_POINTS, draw.count, GL_UNSIGNED_SHORT,
                            index_offset(static_cast<std::uint32_t>(draw.first)), draw.instances);
}

void SubmitStage::draw_binned(const pattern::GpuPool& pool, const depth::BinnedInstances& bins, BinnedInputs inputs) {
  bind_vertex_array(inputs.chunks, inputs.numbers != 0 ? Source::numbered : Source::binned, pool.indices());
  gl_.BindVertexBuffer(lattice_binding, pool.vertices(), 0, sizeof(pattern::LatticeVertex));
  gl_.BindVertexBuffer(patch_binding, bins.patches, bins.patches_offset, patch_bytes);
  if (inputs.numbers != 0) {
    gl_.BindVertexBuffer(record_binding, inputs.numbers, 0, sizeof(std::uint32_t));
  } else {
    gl_.BindVertexBuffer(record_binding, bins.records, bins.records_offset, bins.record_stride);
  }
  gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, bins.commands);
  const auto multi_draw = gl_.MultiDrawElementsIndirect;
  if (multi_draw != nullptr) {
    multi_draw(GL_TRIANGLES, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(bins.commands_offset), bins.command_count,
               0);
    return;
  }
  for (GLsizei command = 0; command < bins.command_count; ++command) {
    gl_.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT,
                             reinterpret_cast<const void*>(bins.commands_offset + command * GLintptr{20}));
  }
}

void SubmitStage::release() {
  for (const auto& [key, array] : arrays_) {
    gl_.DeleteVertexArrays(1, &array.name);
  }
  arrays_.clear();
}

}  // namespace glark::submit
