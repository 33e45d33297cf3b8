// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sorts the triangles of an adaptive draw into instances of pieces: few triangles in one dispatch, many triangles in
// bins.
#pragma once

#include <cstdint>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/depth/bins.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/depth/measure/measure.h"
#include "glark/core/depth/ordered.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/pattern/pool_in_use.h"
#include "glark/core/state/environment.h"

namespace glark::depth {

struct SortRequest {
  const DepthPlan& plan;
  const capture::Layout& layout;
  capture::CoarseTriangles triangles;
  const core::GpuBuffer* count_command = nullptr;  // holds the count of triangles that are counted on the GPU
  bool tags_are_edge_depths = false;
  bool stored = false;  // the derived program reads the records from a storage block
};

// The size of a draw, for which buffers need room.
struct SortRoom {
  const DepthPlan& plan;
  const capture::Layout& layout;
  std::uint32_t triangles = 0;
  bool numbered = false;  // the derived program takes the number of the instance
  bool stored = false;    // the derived program reads the records from a storage block
  bool exact = false;     // the number of triangles is known before the draw
};

class InstanceSorter {
 public:
  InstanceSorter(const core::Environment& environment, const pattern::PoolInUse& pool, capture::Language language);

  bool has_room(const SortRoom& room) const;
  // False without memory. Wrap in an ErrorScope and set the application's transform feedback aside.
  bool reserve(const SortRoom& room);
  // Changes the program, the vertex array, GL_DRAW_INDIRECT_BUFFER and the storage buffer bindings, which the caller
  // restores.
  BinnedInstances sort(const SortRequest& request);
  // The size of the instances that sort() has just returned. Reads back.
  InstanceExtent extent(const SortRequest& request, const BinnedInstances& sorted) const;
  // A buffer of 0, 1, 2, ... for programs whose instances are numbered.
  GLuint numbers() const { return numbers_.name(); }

  // Adds what the GPU has counted to the statistics. Reads back.
  void read_counts();
  void frame_finished() { measure_.frame_finished(); }
  void release();

 private:
  bool takes_in_order(const SortRequest& request) const;
  bool has_room_in_bins(const SortRoom& room, const Measures& measures) const;
  bool reserve_bins(const SortRoom& room, const Measures& measures);
  BinnedInstances sort_in_bins(const SortRequest& request, const MeasureRequest& measured);
  bool has_numbers() const;
  bool reserve_numbers();

  const core::Environment& env_;
  const pattern::PoolInUse& pool_;
  MeasureStage measure_;
  BinStage bins_;
  OrderedStage ordered_;
  core::GpuBuffer numbers_;
  std::uint64_t prepared_for_ = 0;  // the number of the pool whose pieces the bins know
  bool counted_ = false;            // triangles were counted on the GPU since the last reading
};

}  // namespace glark::depth
