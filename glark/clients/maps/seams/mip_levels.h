// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A mipmap level of the charts, whose changes go back to the charts.
#pragma once

#include <vector>

#include "glark/clients/maps/seams/seams.h"

namespace glark::maps {

class MipLevel {
 public:
  // Level 0 are the charts themselves. Otherwise, the sides of all charts must be multiples of two to the power of `level`.
  // Seams of charts that have only a few texels in the level are left out: such a chart is all seam.
  MipLevel(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
           std::span<const SeamFrames> frames, unsigned level);

  std::span<const ChartImage> images() const { return images_; }
  std::span<const Seam> seams() const { return seams_; }
  std::span<const SeamFrames> frames() const { return frames_; }

  // Each texel becomes the mean of the charts' texels that it covers.
  void restrict_from(std::span<const ChartImage> charts);
  // Adds what has changed since restrict_from() to the charts' texels.
  void add_changes_to(std::span<const ChartImage> charts) const;

 private:
  unsigned channels_, level_;
  std::vector<std::vector<float>> values_, before_;  // empty in level 0
  std::vector<ChartImage> images_;
  std::vector<Seam> seams_;
  std::vector<SeamFrames> frames_;
};

}  // namespace glark::maps
