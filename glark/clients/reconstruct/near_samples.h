// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The samples in a box, laid out so that four are looked at together, one in each lane.
#pragma once

#include <span>

#include "glark/clients/reconstruct/octree.h"

namespace glark::vstree {

struct FourSamples {
  Float4 position[3];
  Float4 normal[3];
};

class NearSamples {
 public:
  // Takes those of the box, low .. high.
  void gather(const Octree& octree, Float4 low, Float4 high);
  bool covers(Float4 low, Float4 high) const;
  // What is left of the last four is far away.
  std::span<const FourSamples> all() const { return samples_; }

 private:
  std::vector<Record> inside_;
  std::vector<FourSamples> samples_;
  Float4 low_{1, 1, 1, 0}, high_{};
};

}  // namespace glark::vstree
