// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Keeps captures and sorted instances for draws that repeat. A repeated draw is the same call on the same arrays, whose
// buffers were not written since, or the same segment of a display list with the same inherited values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "glark/core/capture/capture_plan.h"
#include "glark/core/capture/draw_call.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/depth/kept_instances.h"
#include "glark/core/keep/client_arrays.h"
#include "glark/core/keep/draw_cache.h"
#include "glark/core/keep/draw_key.h"
#include "glark/core/state/environment.h"

namespace glark::core {

// The part of a draw's plan that its capture and its sorted instances depend on.
struct KeyFacts {
  const capture::CapturePlan& capture;
  const depth::DepthPlan& depth;
  bool split = false;  // polygons, at their centroids
  bool cut = false;    // quads, again
  bool welded = false;
  float crease = 0;        // of welded triangles, in degrees
  std::uint64_t pool = 0;  // number of the pattern pool
};

// The place in the cache for a draw.
struct KeptDraw {
  DrawCache::Entry* entry = nullptr;  // null: nothing is kept of the draw
  bool filled = false;                // by an earlier draw
};

class KeptDraws {
 public:
  explicit KeptDraws(const Environment& environment) : env_(environment) {}

  KeptDraw find(const DrawCall& call, const KeyFacts& facts);
  // The capture of the draw goes into this buffer. Null: into the ring.
  static GpuBuffer* target_of(const KeptDraw& kept, const KeyFacts& facts) {
    return kept.entry != nullptr && !facts.depth.keeps_instances() ? &kept.entry->buffer : nullptr;
  }
  // After a capture: keeps it, unless GL drew less than it was asked for.
  static void keep_capture(KeptDraw& kept, const DrawCall& call, const KeyFacts& facts,
                           const capture::CoarseTriangles& triangles);
  // Copies the instances to the entry.
  void keep_instances(DrawCache::Entry& entry, const depth::BinnedInstances& instances,
                      const depth::InstanceExtent& extent, const capture::CoarseTriangles& triangles);

  // Copies the instances of a measured draw to the view of the entry. `number` tells views apart.
  void keep_view(DrawCache::Entry& entry, const depth::BinnedInstances& instances, const depth::InstanceExtent& extent,
                 std::uint64_t number);
  void drop_view(DrawCache::Entry& entry) { cache_.drop_view(env_.gl, entry); }

  // See DrawCache. `shared_bytes`: what the index buffers that draws share take of the user's budget.
  bool allocate_vertices(DrawCache::Entry& entry, const DrawCache::VertexRoom& room, std::int64_t shared_bytes) {
    const auto budget = static_cast<std::int64_t>(env_.options.kept_vertex_bytes);
    return cache_.allocate_vertices(env_.gl, entry, room, budget - shared_bytes);
  }
  // The buffers that the draw of the last find() reads, in the order of the states of its entry.
  std::span<const GLuint> buffers_read() const { return key_.buffers(); }
  // The refined vertices of the entry are drawn again.
  void reuse(DrawCache::Entry& entry) { cache_.reuse(entry); }
  void drop_vertices(DrawCache::Entry& entry) { cache_.drop_vertices(env_.gl, entry); }

  std::int64_t bytes() const { return cache_.bytes(); }
  void frame_finished() { cache_.frame_finished(env_.gl); }
  void release() { cache_.release(env_.gl); }
  std::vector<GLuint> take_buffers() { return cache_.take_buffers(); }  // the caller has them deleted

 private:
  bool make_key(const DrawCall& call, const KeyFacts& facts);
  bool add_arrays(const capture::CapturePlan& capture, const ArrayDraw& draw);
  bool add_indices(const ArrayDraw& draw);
  bool add_array_input(int slot);
  bool add_client_array(int slot, const AttributeSource& source);
  bool add_segment(const std::vector<int>& inputs, const ListSegment& segment);
  void add_welded_words(const capture::Layout& layout);
  bool all_watched() const;

  const Environment& env_;
  DrawCache cache_;
  DrawKey key_;                               // scratch
  std::optional<VertexRange> vertices_read_;  // by the draw whose key is made; empty: not known
};

}  // namespace glark::core
