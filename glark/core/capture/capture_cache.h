// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Captures of draws that do not change: the same call on the same vertex array, with no buffer written since.
// A draw is cached when it is seen for the second time, so that streams of fresh geometry cost nothing extra.
#pragma once

#include <cstdint>
#include <map>

#include "glark/core/capture/capture.h"
#include "glark/core/draw_call.h"

namespace glark::capture {

struct CacheKey {
  core::ArrayDraw draw;
  GLuint capture_program = 0;
  GLuint vertex_array = 0;
  auto operator<=>(const CacheKey&) const = default;
};

// What must stand still for an entry to stay valid.
struct Epochs {
  std::uint64_t buffers = 0;
  std::uint64_t vertex_arrays = 0;
  bool operator==(const Epochs&) const = default;
};

class CaptureCache {
 public:
  enum class Answer {
    fresh,  // capture to the ring
    keep,   // capture into the entry's own buffer
    kept,   // the records are there
  };
  struct Entry {
    Epochs epochs;
    bool refused = false;  // reads what we cannot watch: client memory, current attribute values, persistent mappings
    bool filled = false;
    core::GpuBuffer buffer;
    CoarseTriangles triangles;
    std::uint64_t generation = 0;  // of its last use
  };

  // `cacheable` is asked once for each new pair of epochs: whether all that the draw reads is watched.
  template <typename Cacheable>
  std::pair<Answer, Entry*> look_up(const CacheKey& key, const Epochs& epochs, Cacheable&& cacheable) {
    Entry& entry = entries_[key];
    entry.generation = generation_;
    if (entry.epochs != epochs) {
      entry.epochs = epochs;
      entry.filled = false;
      entry.refused = false;
      return {Answer::fresh, &entry};
    }
    if (entry.filled) {
      return {Answer::kept, &entry};
    }
    if (!entry.refused && cacheable()) {
      return {Answer::keep, &entry};
    }
    entry.refused = true;
    return {Answer::fresh, &entry};
  }

  // Bounded in entries and bytes also where frames never end: to be called before a look-up.
  void make_room(const gl::Dispatch& gl);
  // Drops, now and then, the entries that no draw of the last frames used.
  void frame_finished(const gl::Dispatch& gl);
  // The entry's buffer holds the records now.
  static void fill(Entry& entry, const CoarseTriangles& triangles);
  // Whether as many bytes more may be kept.
  bool may_keep(GLsizeiptr bytes) const;
  void count_kept(GLsizeiptr bytes) { kept_bytes_ += bytes; }
  void release(const gl::Dispatch& gl);

 private:
  std::map<CacheKey, Entry> entries_;
  void forget_unused(const gl::Dispatch& gl);

  std::uint64_t frame_ = 0;
  std::uint64_t generation_ = 0;
  GLsizeiptr kept_bytes_ = 0;
};

// Whether every array that `layout` reads comes from a buffer object that is not mapped persistently, and the indices too.
// Queries; the application's vertex array is bound.
bool reads_only_buffers(const gl::Dispatch& gl, const Layout& layout, bool indexed, GLuint tag_attribute);

}  // namespace glark::capture
