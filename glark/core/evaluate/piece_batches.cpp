// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/piece_batches.h"

#include <array>

namespace glark::evaluate {
namespace {

constexpr GLsizei patch_bytes = 16;
constexpr std::size_t indices_at_once = std::size_t{1} << 18;

// As GL has it.
struct IndirectCommand {
  std::uint32_t index_count = 0;
  std::uint32_t instances = 0;
  std::uint32_t first_index = 0;
  std::uint32_t base_vertex = 0;
  std::uint32_t base_instance = 0;
};

std::vector<IndirectCommand> read_commands(const gl::Dispatch& gl, const core::DrawCache::Entry& entry) {
  const depth::BinnedInstances& bins = entry.instances();
  std::vector<IndirectCommand> commands(static_cast<std::size_t>(bins.command_count));
  const auto bytes = static_cast<std::int64_t>(commands.size() * sizeof(commands[0]));
  if (bytes > 0 && !entry.instance_buffer().read(gl, bins.commands_offset, bytes, commands.data())) {
    commands.clear();
  }
  return commands;
}

}  // namespace

PieceBatches::PieceBatches(const Pieces& pieces, const core::DrawPlan& plan, const core::DrawCache::Entry& entry) {
  if (plan.depth.adaptive) {
    add_bins(pieces, entry);
  } else {
    add_tiles(pieces, plan, entry.triangles);
  }
}

void PieceBatches::add(const Pieces& pieces, std::uint32_t first_index, std::uint32_t index_count, const Batch& batch) {
  batches_.push_back(batch);
  batches_.back().pattern = &pieces.patterns.find(pieces.gl, pieces.pool, pieces.pool_number, first_index, index_count);
  const PiecePattern& pattern = *batches_.back().pattern;
  complete_ = complete_ && pattern.indices.size() == index_count;
  vertices_ += std::uint64_t{batch.instances} * pattern.vertices.size();
  indices_ += std::uint64_t{batch.instances} * pattern.indices.size();
}

void PieceBatches::add_bins(const Pieces& pieces, const core::DrawCache::Entry& entry) {
  const depth::BinnedInstances& bins = entry.instances();
  for (const IndirectCommand& command : read_commands(pieces.gl, entry)) {
    const auto first = static_cast<GLintptr>(command.base_instance);
    add(pieces, command.first_index, command.index_count,
        {.instances = command.instances,
         .source = {.records = bins.records,
                    .records_offset = bins.records_offset + first * bins.record_stride,
                    .record_stride = bins.record_stride,
                    .patches = bins.patches,
                    .patches_offset = bins.patches_offset + first * patch_bytes}});
  }
  complete_ = complete_ && !batches_.empty() && indices_ > 0;
}

void PieceBatches::add_tiles(const Pieces& pieces, const core::DrawPlan& plan,
                             const capture::CoarseTriangles& triangles) {
  const unsigned level = plan.depth.level;
  const pattern::Piece& piece = pieces.pool.piece(pattern::uniform_piece(pattern::deepest_uniform));
  const unsigned first = pattern::GpuPool::first_tile(level);
  for (unsigned tile = 0; tile < pattern::GpuPool::tile_count(level); ++tile) {
    add(pieces, piece.first_index, piece.index_count,
        {.instances = triangles.count,
         .source = {.records = triangles.buffer,
                    .records_offset = triangles.offset,
                    .record_stride = plan.capture.layout->triangle_words() * 4,
                    .patches = pieces.pool.patches(),
                    .patches_offset = static_cast<GLintptr>(first + tile) * patch_bytes,
                    .one_patch = true}});
  }
}

void PieceBatches::write_indices(const gl::Dispatch& gl, const core::GpuBuffer& to) const {
  std::vector<std::uint32_t> indices;
  std::int64_t written = 0;
  std::uint32_t first_vertex = 0;
  const auto flush = [&] {
    const auto bytes = static_cast<std::int64_t>(indices.size() * sizeof(indices[0]));
    to.write(gl, written, bytes, indices.data());
    written += bytes;
    indices.clear();
  };
  for (const Batch& batch : batches_) {
    for (std::uint32_t instance = 0; instance < batch.instances; ++instance) {
      for (const std::uint16_t index : batch.pattern->indices) {
        indices.push_back(first_vertex + index);
      }
      first_vertex += static_cast<std::uint32_t>(batch.pattern->vertices.size());
      if (indices.size() >= indices_at_once) {
        flush();
      }
    }
  }
  if (!indices.empty()) {
    flush();
  }
}

std::vector<submit::PointDraw> PieceBatches::point_draws(const gl::Dispatch& gl, const capture::Layout& layout,
                                                         core::GpuBuffer& points) const {
  std::vector<std::uint16_t> all;
  std::map<const PiecePattern*, std::size_t> first_of;
  for (const Batch& batch : batches_) {
    if (first_of.try_emplace(batch.pattern, all.size()).second) {
      all.insert(all.end(), batch.pattern->vertices.begin(), batch.pattern->vertices.end());
    }
  }
  std::vector<submit::PointDraw> draws;
  if (!points.allocate(gl, static_cast<std::int64_t>(all.size() * sizeof(all[0])), all.data(), GL_STREAM_DRAW)) {
    return draws;
  }
  for (const Batch& batch : batches_) {
    draws.push_back({.indices = points.name(),
                     .first = static_cast<GLint>(first_of.at(batch.pattern)),
                     .count = static_cast<GLsizei>(batch.pattern->vertices.size()),
                     .instances = static_cast<GLsizei>(batch.instances),
                     .chunks = layout.chunk_count(),
                     .source = batch.source});
  }
  return draws;
}

}  // namespace glark::evaluate
