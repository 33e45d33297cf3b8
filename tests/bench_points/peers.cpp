// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures CGAL for glark-bench-points. It is a separate program because parts of CGAL are under the GPL, and glark
// must not link to them.
//   glark-bench-peers octree POINTS ROUNDS            POINTS: x y z as floats of this machine
//   glark-bench-peers front POINTS ROUNDS TRIANGLES   writes three 32-bit indices a triangle
// Prints CPU seconds, seconds of the clock, bytes without the points (-1: unknown), and the number of leaves or
// triangles.
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Octree.h>
#include <CGAL/Point_set_3.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench_points/measure/measure.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Facet = std::array<std::size_t, 3>;

std::vector<Point> read_points(const char* file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(std::string(file) + " cannot be read");
  std::vector<Point> points;
  std::array<float, 3> xyz{};
  while (in.read(reinterpret_cast<char*>(xyz.data()), sizeof(xyz))) points.emplace_back(xyz[0], xyz[1], xyz[2]);
  return points;
}

std::size_t leaves_of(const std::vector<Point>& points) {
  constexpr std::size_t deepest = 20, most_in_a_leaf = 64;  // same limits as for nanoflann's tree in glark-bench-points
  CGAL::Point_set_3<Point> set;
  set.reserve(points.size());
  for (const Point& point : points) set.insert(point);
  CGAL::Octree<Kernel, CGAL::Point_set_3<Point>, CGAL::Point_set_3<Point>::Point_map> octree(set, set.point_map());
  octree.refine(deepest, most_in_a_leaf);
  const auto leaves = octree.traverse<CGAL::Orthtrees::Leaves_traversal>();
  return static_cast<std::size_t>(std::distance(leaves.begin(), leaves.end()));
}

void write_triangles(const std::vector<Facet>& facets, const char* file) {
  std::ofstream out(file, std::ios::binary);
  for (const Facet& facet : facets) {
    const std::array<std::uint32_t, 3> corners = {static_cast<std::uint32_t>(facet[0]),
                                                  static_cast<std::uint32_t>(facet[1]),
                                                  static_cast<std::uint32_t>(facet[2])};
    out.write(reinterpret_cast<const char*>(corners.data()), sizeof(corners));
  }
  if (!out.flush()) throw std::runtime_error(std::string(file) + " cannot be written");
}

void run(int count, char** words) {
  const std::string task = count > 1 ? words[1] : "";
  if (!(task == "octree" && count == 4) && !(task == "front" && count == 5))
    throw std::runtime_error("give: octree POINTS ROUNDS, or: front POINTS ROUNDS TRIANGLES");
  const std::vector<Point> points = read_points(words[2]);
  std::size_t found = 0;
  std::vector<Facet> facets;
  std::vector<glark::bench::Work> works;
  if (task == "octree") {
    works.push_back({"octree", [&] { found = leaves_of(points); }});
  } else {
    works.push_back({"front", [&] {
                       facets.clear();
                       CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                                                    std::back_inserter(facets));
                       found = facets.size();
                     }});
  }
  glark::bench::take_turns(works, std::atoi(words[3]));
  if (task == "front") write_triangles(facets, words[4]);
  std::printf("%.6f %.6f %.0f %zu\n", works[0].cpu_seconds, works[0].seconds, works[0].peak_bytes.value_or(-1), found);
}

}  // namespace

int main(int count, char** words) {
  try {
    run(count, words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glark-bench-peers: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
