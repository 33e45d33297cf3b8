// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The implicit function near two sheets that face opposite ways and are nearer to each other than a cell is wide.
//
// There the nearest plane may belong to the wrong side, because the distance along the sheets exceeds the distance
// between them. So both sides are evaluated, each from the planes that face its way. If matter lies between the sheets,
// the function is the maximum of both values. If a gap lies between them, it is the minimum.
#pragma once

#include <span>

#include "glark/clients/reconstruct/contour/transition_layer.h"

namespace glark::reconstruct {

// The values at four points in cells (no_value where no plane reaches), and the normals of the sides that give them.
struct FourValues {
  Float4 value;
  Float4 normal[3];
  Float4 apart;  // the distance of the two sides, or no_value
};

// Looks for planes that face the opposite way, so near that the grid may miss what is between them.
class Opposites {
 public:
  Opposites(const TransitionLayer& layer, unsigned level)
      : layer_(layer), level_(level), cells_(static_cast<float>(1U << level)) {}

  // Returns whether no two of the planes can face opposite ways. It may return false although there are none.
  bool are_alike(std::span<const std::uint32_t> planes) const;
  bool has(const SupportPlane& plane) const;

 private:
  bool is_opposed_in(std::size_t depth, std::uint64_t key, const SupportPlane& plane) const;

  const TransitionLayer& layer_;
  unsigned level_;
  float cells_;
};

class ThinSides {
 public:
  // cells: the number of cells along the unit cube. Points are in cells.
  ThinSides(std::span<const SupportPlane> planes, float cells) : planes_(planes), cells_(cells) {}

  // Chooses the planes, of those given, whose balls meet the box.
  void look_around(std::span<const std::uint32_t> which, Float4 low, Float4 high);
  // Chooses from the planes around. The box must lie within that of look_around().
  void look_at(Float4 low, Float4 high);
  // The points must lie within the box of look_at().
  FourValues at(const Float4 (&points)[3]) const;

 private:
  Float4 height_over(const Float4 (&points)[3], const Float4 (&normal)[3]) const;

  std::span<const SupportPlane> planes_;
  float cells_;
  std::vector<SupportPlane> around_, near_;  // in cells
};

}  // namespace glark::reconstruct
