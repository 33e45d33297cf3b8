// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/keep/draw_cache.h"

#include <algorithm>
#include <utility>

namespace glark::core {
namespace {

constexpr std::uint64_t frames_to_keep = 120;
constexpr std::size_t most_entries = 8192;
constexpr std::int64_t most_bytes = std::int64_t{256} << 20;

// One multiplication a word is enough, because the words of keys with the same hash are compared.
std::uint64_t hash_of(std::span<const std::uint64_t> words) {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (const std::uint64_t word : words) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdU;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

DrawCache::Entries::iterator DrawCache::find(std::uint64_t hash, std::span<const std::uint64_t> words) {
  const auto [first, last] = by_hash_.equal_range(hash);
  for (auto at = first; at != last; ++at) {
    if (std::equal(words.begin(), words.end(), at->second->key.begin(), at->second->key.end())) {
      return at->second;
    }
  }
  return entries_.end();
}

std::pair<DrawCache::Answer, DrawCache::Entry*> DrawCache::look_up(const gl::Dispatch& gl, const DrawKey& key,
                                                                   const BufferStamps& stamps) {
  states_.clear();
  for (const GLuint buffer : key.buffers()) {
    states_.push_back(stamps.state(buffer));
  }
  const std::uint64_t hash = hash_of(key.words());
  auto at = find(hash, key.words());
  const bool known = at != entries_.end();
  if (!known) {
    if (entries_.size() >= most_entries) {
      drop_oldest(gl);
    }
    entries_.emplace_front();
    at = entries_.begin();
    at->place = at;
    at->key.assign(key.words().begin(), key.words().end());
    at->hash = hash;
    by_hash_.emplace(hash, at);
  }
  Entry& entry = *at;
  const bool first_in_frame = use(entry);
  if (!known || entry.states != states_) {
    entry.states = states_;
    entry.filled = entry.refused = false;
    drop_view(gl, entry);
    entry.view = {};
    return {Answer::fresh, &entry};
  }
  if (entry.filled) {
    ++entry.reuses;
    entry.frames_reused += first_in_frame ? 1 : 0;
  }
  return {entry.filled ? Answer::kept : entry.refused ? Answer::fresh : Answer::keep, &entry};
}

// Returns whether it is the first use in the frame.
bool DrawCache::use(Entry& entry) {
  entries_.splice(entries_.begin(), entries_, entry.place);
  entry.last_use = ++uses_;
  return std::exchange(entry.last_frame, frame_) != frame_;
}

void DrawCache::reuse(Entry& entry) {
  entry.frames_reused += use(entry) ? 1 : 0;
  ++entry.reuses;
}

void DrawCache::drop_oldest(const gl::Dispatch& gl) {
  Entry& entry = entries_.back();
  kept_bytes_ -= entry.buffer.size();
  entry.buffer.release(gl);
  drop_view(gl, entry);
  const auto [first, last] = by_hash_.equal_range(entry.hash);
  by_hash_.erase(std::find_if(first, last, [&](const auto& pair) { return &*pair.second == &entry; }));
  entries_.pop_back();
}

bool DrawCache::make_room(const gl::Dispatch& gl, const Entry& wanted, std::int64_t bytes) {
  // Repeated draws use all entries in turn. An entry that was not used for two turns is no longer drawn. Dropping an
  // entry in use would only make its draw capture again instead of this one.
  while (kept_bytes_ - wanted.buffer.size() + bytes > most_bytes && &entries_.back() != &wanted &&
         !repeats(entries_.back())) {
    drop_oldest(gl);
  }
  return kept_bytes_ - wanted.buffer.size() + bytes <= most_bytes;
}

bool DrawCache::allocate(const gl::Dispatch& gl, Entry& entry, std::int64_t bytes) {
  if (bytes <= entry.buffer.size()) {
    return true;
  }
  kept_bytes_ -= entry.buffer.size();
  const bool done = entry.buffer.allocate(gl, bytes, nullptr, GL_STATIC_COPY);
  kept_bytes_ += entry.buffer.size();
  return done;
}

bool DrawCache::allocate_view(const gl::Dispatch& gl, Entry& entry, std::int64_t bytes) {
  GpuBuffer& buffer = entry.view.buffer;
  kept_bytes_ -= buffer.size();
  const bool done = buffer.allocate(gl, bytes, nullptr, GL_STATIC_COPY);
  kept_bytes_ += buffer.size();
  return done;
}

void DrawCache::drop_view(const gl::Dispatch& gl, Entry& entry) {
  kept_bytes_ -= entry.view.buffer.size();
  entry.view.buffer.release(gl);
  entry.view.number = 0;
  entry.view.refused = false;
  entry.reuses = entry.frames_reused = 0;
  drop_vertices(gl, entry);
}

bool DrawCache::allocate_vertices(const gl::Dispatch& gl, Entry& entry, const VertexRoom& room, std::int64_t budget) {
  const std::int64_t bytes = room.vertices + room.indices;
  for (auto at = entries_.rbegin(); at != entries_.rend() && vertex_bytes_ + bytes > budget; ++at) {
    if (&*at != &entry && !repeats(*at)) {
      drop_vertices(gl, *at);
    }
  }
  RefinedVertices& vertices = entry.vertices;
  if (vertex_bytes_ + bytes > budget || !vertices.buffer.allocate(gl, room.vertices, nullptr, GL_STATIC_COPY)) {
    return false;
  }
  if (room.indices > 0 && !vertices.indices.allocate(gl, room.indices, nullptr, GL_STATIC_DRAW)) {
    vertices.buffer.release(gl);
    return false;
  }
  vertex_bytes_ += bytes;
  return true;
}

void DrawCache::drop_vertices(const gl::Dispatch& gl, Entry& entry) {
  vertex_bytes_ -= entry.vertices.bytes();
  entry.vertices.release(gl);
}

void DrawCache::frame_finished(const gl::Dispatch& gl) {
  ++frame_;
  while (!entries_.empty() && entries_.back().last_frame + frames_to_keep < frame_) {
    drop_oldest(gl);
  }
}

void DrawCache::release(const gl::Dispatch& gl) {
  while (!entries_.empty()) {
    drop_oldest(gl);
  }
}

std::vector<GLuint> DrawCache::take_buffers() {
  std::vector<GLuint> names;
  for (const Entry& entry : entries_) {
    for (const GpuBuffer* buffer :
         {&entry.buffer, &entry.view.buffer, &entry.vertices.buffer, &entry.vertices.indices}) {
      if (buffer->name() != 0) {
        names.push_back(buffer->name());
      }
    }
  }
  entries_.clear();
  by_hash_.clear();
  kept_bytes_ = vertex_bytes_ = 0;
  return names;
}

}  // namespace glark::core
