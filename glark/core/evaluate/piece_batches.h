// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A draw whose coarse triangles are cut into pieces: by depths that vary, or by the tiles of a deep level. Each batch has
// the instances of one piece.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/core/evaluate/piece_pattern.h"
#include "glark/core/keep/draw_cache.h"
#include "glark/core/plan/draw_plan.h"
#include "glark/core/submit/submit.h"

namespace glark::evaluate {

struct Batch {
  const PiecePattern* pattern = nullptr;
  std::uint32_t instances = 0;
  submit::InstanceSource source;
};

class PieceBatches {
 public:
  struct Pieces {
    const gl::Dispatch& gl;
    const pattern::GpuPool& pool;
    std::uint64_t pool_number;
    PiecePatterns& patterns;
  };
  // In the order in which the refined draw draws them. Reads back.
  PieceBatches(const Pieces& pieces, const core::DrawPlan& plan, const core::DrawCache::Entry& entry);

  bool complete() const { return complete_; }  // all pieces could be read
  std::uint64_t vertex_count() const { return vertices_; }
  std::uint64_t index_count() const { return indices_; }
  // Writes the triangles of all instances as uint32.
  void write_indices(const gl::Dispatch& gl, const core::GpuBuffer& to) const;
  // The refined vertices as points. Their indices go to `points`, which is empty without memory.
  std::vector<submit::PointDraw> point_draws(const gl::Dispatch& gl, const capture::Layout& layout,
                                             core::GpuBuffer& points) const;

 private:
  void add_bins(const Pieces& pieces, const core::DrawCache::Entry& entry);
  void add_tiles(const Pieces& pieces, const core::DrawPlan& plan, const capture::CoarseTriangles& triangles);
  void add(const Pieces& pieces, std::uint32_t first_index, std::uint32_t index_count, const Batch& batch);

  std::vector<Batch> batches_;
  std::uint64_t vertices_ = 0;
  std::uint64_t indices_ = 0;
  bool complete_ = true;
};

}  // namespace glark::evaluate
