// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Estimates the surface near a point from the samples around.
#pragma once

#include "glark/clients/reconstruct/samples/near_samples.h"

namespace glark::reconstruct {

struct LocalEstimate {
  Float4 point{}, normal{};
  Float4 colour{};  // red, green and blue, 0 to 255, if the samples have colours
  bool found = false;
  bool opposed = false;  // no samples face the same way, but some face the opposite way
  bool near = false;     // the estimate is from samples within the radius; false: within twice the radius
};

// Finds points and colours with the same weights. Only one thread at a time may use it.
class LocalSurface {
 public:
  explicit LocalSurface(const Octree& octree) : octree_(octree) {}

  // Prepares for estimates in the box. Estimates outside the box are possible, but slower.
  void look_around(Float4 low, Float4 high);

  // Projects a point onto the surface along the normal there. Uses the samples within the radius that face the same way
  // as `normal`. If these are few, uses samples within twice the radius.
  LocalEstimate near(Float4 point, Float4 normal, float radius);

 private:
  LocalEstimate within(Float4 point, Float4 normal, float radius);

  const Octree& octree_;
  NearSamples around_;
  NearSamples alone_;  // the samples around a point outside the box
};

}  // namespace glark::reconstruct
