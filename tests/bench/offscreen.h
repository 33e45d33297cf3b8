// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// An OSMesa context with a small picture, so that the work for vertices takes most of the time.
#pragma once

#include <cstdint>
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

  bool ready() const { return context_ != nullptr; }

 private:
  void* context_ = nullptr;
  std::vector<std::uint32_t> pixels_;
};

using Picture = std::vector<std::uint8_t>;  // RGBA

Picture read_picture();

// Compares two pictures. Returns an empty text if both show the same and are not empty; otherwise describes the
// difference. Rounding along edges and the sampling of the lighting may differ.
std::string difference(const Picture& a, const Picture& b);

}  // namespace glark::bench
