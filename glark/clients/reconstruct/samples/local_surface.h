// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where the samples around a point say that the surface is.
#pragma once

#include "glark/clients/reconstruct/samples/near_samples.h"

namespace glark::reconstruct {

struct LocalEstimate {
  Float4 point{}, normal{};
  Float4 colour{};  // red, green and blue, 0 to 255; if the samples have colours
  bool found = false;
  bool opposed = false;  // there are none such, but some that face the other way
  bool near = false;     // by samples within the radius, not within twice as far
};

// Mean colours by the same weights. For one thread at a time.
class LocalSurface {
 public:
  explicit LocalSurface(const Octree& octree) : octree_(octree) {}

  // What is asked for next is in the box, most of it.
  void look_around(Float4 low, Float4 high);

  // The foot of a point along the normal there, by samples nearer than the radius that face the way that `normal` does. Where these are
  // few, by those nearer than twice the radius.
  LocalEstimate near(Float4 point, Float4 normal, float radius);

 private:
  LocalEstimate within(Float4 point, Float4 normal, float radius);

  const Octree& octree_;
  NearSamples around_;
  NearSamples alone_;  // of a point that is not
};

}  // namespace glark::reconstruct
