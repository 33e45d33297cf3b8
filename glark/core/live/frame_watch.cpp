// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/live/frame_watch.h"

#include <algorithm>

namespace glark::core {

WatchedClass& FrameWatch::find(const DrawClassKey& key, bool kept) {
  const auto found = std::find_if(current_.begin(), current_.end(),
                                  [&](const WatchedClass& known) { return known.kept == kept && known.key == key; });
  if (found != current_.end()) {
    return *found;
  }
  if (current_.size() < most_classes) {
    current_.push_back({.key = key, .kept = kept});
  }
  return current_.back();
}

void FrameWatch::count(const DrawClassKey& key, bool kept, std::uint64_t triangles) {
  WatchedClass& entry = find(key, kept);
  ++entry.draws;
  entry.triangles += triangles;
}

void FrameWatch::changed_pixel(const DrawClassKey& key, bool kept) { find(key, kept).pixel_step = ++pixel_steps_; }

void FrameWatch::frame_finished() {
  last_.swap(current_);
  current_.clear();
  pixel_steps_ = 0;
  std::stable_sort(last_.begin(), last_.end(),
                   [](const WatchedClass& a, const WatchedClass& b) { return a.triangles > b.triangles; });
}

}  // namespace glark::core
