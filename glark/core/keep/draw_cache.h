// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Captures and bins of draws that do not change. A draw is kept when it is seen for the second time, so that streams of fresh
// geometry cost next to nothing; what was not used for longest goes first.
#pragma once

#include <cstdint>
#include <list>
#include <span>
#include <unordered_map>
#include <vector>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/depth/binned_instances.h"
#include "glark/core/keep/draw_key.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/state/arrays/buffer_stamps.h"

namespace glark::core {

class DrawCache {
 public:
  enum class Answer {
    fresh,  // nothing is kept, nor shall it be
    keep,   // seen before: what is made now may be kept
    kept,   // everything is there
  };
  struct Entry {
    std::vector<std::uint64_t> key;
    std::uint64_t hash = 0;
    std::vector<BufferStamps::State> states;  // of the buffers, in the order of the key's
    bool filled = false;
    bool refused = false;  // reads what cannot be watched, or finds no room
    GpuBuffer buffer;
    capture::CoarseTriangles triangles;
    depth::BinnedInstances bins;          // of an adaptive draw; the coarse triangles are then not kept
    std::uint64_t refined_triangles = 0;  // of the bins
    std::uint64_t last_use = 0;
    std::uint64_t last_frame = 0;
  };

  // The buffers' states are taken here, so before the draw is captured.
  std::pair<Answer, Entry*> look_up(const gl::Dispatch& gl, const DrawKey& key, const BufferStamps& stamps);
  // Makes room for `bytes`, at the expense of entries that no longer take their turn. False: the draws in turn fill the budget.
  bool make_room(const gl::Dispatch& gl, const Entry& wanted, GLsizeiptr bytes);
  // Gives the entry a buffer of its own of `bytes`; false without memory. Wrap in an ErrorScope.
  bool allocate(const gl::Dispatch& gl, Entry& entry, GLsizeiptr bytes);
  // Drops what no draw of the last frames used.
  void frame_finished(const gl::Dispatch& gl);
  void release(const gl::Dispatch& gl);
  // The names of all buffers, for whoever deletes them later: nothing is kept any more.
  std::vector<GLuint> take_buffers();

 private:
  using Entries = std::list<Entry>;
  Entries::iterator find(std::uint64_t hash, std::span<const std::uint64_t> words);
  void drop_oldest(const gl::Dispatch& gl);

  Entries entries_;  // the one used last comes first
  std::unordered_multimap<std::uint64_t, Entries::iterator> by_hash_;
  std::vector<BufferStamps::State> states_;  // scratch
  std::uint64_t uses_ = 0;
  std::uint64_t frame_ = 0;
  GLsizeiptr kept_bytes_ = 0;
};

}  // namespace glark::core
