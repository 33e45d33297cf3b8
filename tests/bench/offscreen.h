// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A context of OSMesa, or of EGL in glark-bench-egl, with a small picture, so that the work for vertices takes most of the time.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glark::bench {

inline constexpr int picture_size = 256;

class Offscreen {
 public:
  Offscreen();
  ~Offscreen();
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  bool ready() const { return ready_; }

 private:
  struct Context;
  static void set_state();

  std::unique_ptr<Context> context_;
  bool ready_ = false;
};

using Picture = std::vector<std::uint8_t>;  // RGBA

Picture read_picture();

// Compares two pictures. Returns an empty text if both show the same and are not empty; otherwise describes the
// difference. Rounding along edges and the sampling of the lighting may differ.
std::string difference(const Picture& a, const Picture& b);

}  // namespace glark::bench
