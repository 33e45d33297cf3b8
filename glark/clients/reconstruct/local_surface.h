// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where the samples around a point say that the surface is.
#pragma once

#include "glark/clients/reconstruct/octree.h"

namespace glark::vstree {

struct LocalEstimate {
  Float4 point{}, normal{};
  bool found = false;
  bool opposed = false;  // there are none such, but some that face the other way
  bool near = false;     // by samples within the radius, not within twice as far
};

class LocalSurface {
 public:
  explicit LocalSurface(const Octree& octree) : octree_(octree) {}

  // The foot of a point along the normal there, by samples nearer than the radius that face the way that `normal` does. Where these are
  // few, by those nearer than twice the radius.
  LocalEstimate near(Float4 point, Float4 normal, float radius) const;

 private:
  LocalEstimate within(Float4 point, Float4 normal, float radius) const;

  const Octree& octree_;
};

}  // namespace glark::vstree
