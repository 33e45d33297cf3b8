// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One place where leaves disagree: points, the agreed triangles around them, and those that some leaf would have.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/layer.h"
#include "glark/clients/surfel/strip_path.h"

namespace glark::surfel {

// A triangle that not all leaves have.
struct Claim {
  StripTriangle triangle;  // counter-clockwise
  std::uint32_t missing;   // leaves that own a corner and have it not
  float size;              // the less the better
};

class Rift {
 public:
  // numbers: of points that are in a rift, which of its points they are.
  Rift(const Layer& layer, const std::uint32_t* numbers, const LayerOptions& options)
      : layer_(layer), numbers_(numbers), options_(options) {}

  // points: those of a rift, ascending.
  void begin(std::span<const std::uint32_t> points);
  void add_agreed(const StripTriangle& triangle);
  // The best first, as long as they fit to what is there; then what they leave open. `drawn` are the triangles.
  void close(std::vector<Claim>& claims);

  std::vector<StripTriangle> drawn;

 private:
  // A triangle at a point, by its other corners, and the sector that it has in the point's tangential plane.
  struct Wedge {
    std::uint32_t first, second;
    float from, angle;  // angle < 0: it is seen from behind there
  };
  struct Fan {
    Vector position, normal, u, v;
    std::vector<Wedge> wedges;
  };

  Fan* fan_of(std::uint32_t point);
  Wedge wedge_at(const Fan& fan, std::uint32_t first, std::uint32_t second) const;
  bool fits(const StripTriangle& triangle);
  bool stands_alone(const StripTriangle& triangle);
  bool has_edge(std::uint32_t from, std::uint32_t to);
  void insert(const StripTriangle& triangle);
  std::uint32_t next_on_border(std::uint32_t before, std::uint32_t at);
  void close_loops();
  bool is_outline(std::span<const std::uint32_t> loop);
  void fill(std::span<const std::uint32_t> loop);
  float cost(std::uint32_t a, std::uint32_t b, std::uint32_t c, float longest) const;

  const Layer& layer_;
  const std::uint32_t* numbers_;
  const LayerOptions& options_;
  std::span<const std::uint32_t> points_;
  std::vector<Fan> fans_;
};

// How good a triangle is: its circumcircle's squared radius, more where the points' normals are not those of its plane; below 0 if it
// is seen from behind.
float badness(const Layer& layer, const StripTriangle& triangle);

}  // namespace glark::surfel
