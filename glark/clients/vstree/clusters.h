// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Groups of samples, each of which one point will stand for.
#pragma once

#include <glark/vstree.h>

#include "glark/clients/vstree/quadric.h"
#include "glark/clients/vstree/samples.h"
#include "glark/clients/workers.h"

namespace glark::vstree {

// What is to be simplified, checked.
struct Surface {
  Cube cube;
  PointSet points;  // with normals
  std::span<const std::uint32_t> triangles;

  std::size_t size() const { return points.positions.size() / 3; }
  Float4 point(std::size_t i) const { return cube.inside(&points.positions[3 * i]); }  // in the unit cube
  Record record(std::uint32_t i) const { return record_of(points, cube, i); }
};

struct Clusters {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of;  // [points]
  Records sorted;                 // [points], so that those of a cluster are neighbours
  struct Run {
    std::uint32_t begin, end;
  };
  std::vector<Run> runs;                 // [count], in `sorted`
  std::vector<std::uint32_t> triangles;  // over clusters; empty: not known yet

  std::span<const Record> samples(std::size_t cluster) const {
    return sorted.all().subspan(runs[cluster].begin, runs[cluster].end - runs[cluster].begin);
  }
};

Clusters cluster(const Surface& surface, const SimplifyOptions& options, const Workers& workers);

}  // namespace glark::vstree
