// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The classes of draws of the last frame of a context, for a user who looks at them.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/core/live/draw_groups.h"
#include "glark/core/report/draw_classes.h"

namespace glark::core {

struct WatchedClass {
  DrawClassKey key;
  bool kept = false;  // refined vertices of an earlier frame
  std::uint64_t draws = 0;
  std::uint64_t triangles = 0;   // of the application
  std::uint64_t pixel_step = 0;  // its last draw that changed the chosen pixel, counted from 1; 0: no draw did

  DrawGroup group() const { return group_of(key.verdict, kept); }
};

class FrameWatch {
 public:
  // More classes of a frame are not told apart: the rest counts as the last one.
  static constexpr std::size_t most_classes = 256;

  void count(const DrawClassKey& key, bool kept, std::uint64_t triangles);
  // The draw of this class changed the chosen pixel.
  void changed_pixel(const DrawClassKey& key, bool kept);
  void frame_finished();

  // Those of the last frame, the one with the most triangles first.
  const std::vector<WatchedClass>& last_frame() const { return last_; }

 private:
  WatchedClass& find(const DrawClassKey& key, bool kept);

  std::vector<WatchedClass> current_;
  std::vector<WatchedClass> last_;
  std::uint64_t pixel_steps_ = 0;
};

}  // namespace glark::core
