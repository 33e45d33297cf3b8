// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The cache of captures and sorted instances of draws that do not change. A draw is kept when it is seen for the second
// time, so that streams of new geometry cost almost nothing. The entry that was not used for longest is dropped first.
#pragma once

#include <cstdint>
#include <list>
#include <span>
#include <unordered_map>
#include <vector>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/depth/binned_instances.h"
#include "glark/core/keep/draw_key.h"
#include "glark/core/keep/kept_view.h"
#include "glark/core/keep/refined_vertices.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/state/arrays/buffer_stamps.h"

namespace glark::core {

class DrawCache {
 public:
  enum class Answer {
    fresh,  // nothing is kept, and nothing should be kept now
    keep,   // the draw was seen before: its capture may be kept now
    kept,   // the entry is filled
  };
  struct Entry {
    std::vector<std::uint64_t> key;
    std::uint64_t hash = 0;
    std::vector<BufferStamps::State> states;  // states of the buffers, in the order of the key
    bool filled = false;
    bool refused = false;  // the draw reads a buffer that cannot be watched, or there is no room
    GpuBuffer buffer;
    capture::CoarseTriangles triangles;
    depth::BinnedInstances bins;          // instances of an adaptive draw; then its coarse triangles are not kept
    std::uint64_t refined_triangles = 0;  // their number in the bins
    std::uint64_t last_use = 0;
    std::uint64_t last_frame = 0;
    KeptView view;  // of a measured draw
    RefinedVertices vertices;
    std::list<Entry>::iterator place;  // in the list of the cache
    unsigned reuses = 0;               // of the filled entry
    unsigned frames_reused = 0;        // frames in which it was reused

    // Programs that never end a frame repeat their draws, too.
    bool repeats_often() const { return frames_reused > 2 || reuses > 16; }
    // The instances that are drawn, and the buffer that holds their commands.
    const depth::BinnedInstances& instances() const { return view.kept() ? view.bins : bins; }
    const GpuBuffer& instance_buffer() const { return view.kept() ? view.buffer : buffer; }
  };

  // Notes that the draw of a filled entry comes again.
  void reuse(Entry& entry);
  // Takes the states of the buffers: call it before the draw is captured.
  std::pair<Answer, Entry*> look_up(const gl::Dispatch& gl, const DrawKey& key, const BufferStamps& stamps);
  // Makes room for `bytes`: drops entries whose draws are no longer repeated. False: entries in use fill the budget.
  bool make_room(const gl::Dispatch& gl, const Entry& wanted, std::int64_t bytes);
  // Gives the entry a buffer of its own of `bytes`; false without memory. Wrap in an ErrorScope.
  bool allocate(const gl::Dispatch& gl, Entry& entry, std::int64_t bytes);
  // The same for the instances of its view.
  bool allocate_view(const gl::Dispatch& gl, Entry& entry, std::int64_t bytes);
  // Drops the instances of the view, and the vertices that were made of them. The draw begins to repeat again.
  void drop_view(const gl::Dispatch& gl, Entry& entry);
  struct VertexRoom {
    std::int64_t vertices = 0;  // bytes
    std::int64_t indices = 0;   // bytes; 0: in a buffer that draws share
  };
  // Gives the entry buffers for its refined vertices. Drops vertices of draws that are no longer repeated. False: the
  // others fill the budget, or there is no memory. Wrap in an ErrorScope.
  bool allocate_vertices(const gl::Dispatch& gl, Entry& entry, const VertexRoom& room, std::int64_t budget);
  void drop_vertices(const gl::Dispatch& gl, Entry& entry);
  // Drops entries that no draw of the last frames used.
  void frame_finished(const gl::Dispatch& gl);
  void release(const gl::Dispatch& gl);
  // Forgets all entries, and returns the names of their buffers, for deletion by the caller or another context.
  std::vector<GLuint> take_buffers();

  std::int64_t bytes() const { return kept_bytes_ + vertex_bytes_; }  // of its buffers

 private:
  using Entries = std::list<Entry>;
  Entries::iterator find(std::uint64_t hash, std::span<const std::uint64_t> words);
  bool use(Entry& entry);
  bool repeats(const Entry& entry) const { return uses_ - entry.last_use <= 2 * entries_.size(); }
  void drop_oldest(const gl::Dispatch& gl);

  Entries entries_;  // the one used last comes first
  std::unordered_multimap<std::uint64_t, Entries::iterator> by_hash_;
  std::vector<BufferStamps::State> states_;  // scratch
  std::uint64_t uses_ = 0;
  std::uint64_t frame_ = 0;
  std::int64_t kept_bytes_ = 0;
  std::int64_t vertex_bytes_ = 0;
};

}  // namespace glark::core
