// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/pattern/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/core/pattern/pool.h"

namespace glark::tool {
namespace {

constexpr double side = 480;
constexpr double margin = 28;  // for the texts beside the edges
const double height = side * std::sqrt(0.75);

// The refined vertex of the lattice, as the vertex shader computes it: expand.h has the formula.
PatternPoint place(pattern::LatticeVertex vertex, const pattern::Instance& instance) {
  constexpr double one = pattern::lattice_one;
  const std::array<double, 3> local = {(one - vertex.u - vertex.v) / one, vertex.u / one, vertex.v / one};
  std::array<double, 3> tile{};
  for (std::size_t k = 0; k < 3; ++k) tile[(k + static_cast<std::size_t>(instance.r)) % 3] = local[k];
  return {static_cast<double>(instance.ou) + static_cast<double>(instance.s) * tile[1],
          static_cast<double>(instance.ov) + static_cast<double>(instance.s) * tile[2]};
}

Part part_of(int piece) {
  if (piece < pattern::first_skirt) return Part::interior;
  return piece < pattern::first_fan ? Part::skirt : Part::fan;
}

std::string svg_point(PatternPoint point) {
  return fmt::format("{:.2f},{:.2f}", margin + side * (point.u + point.v / 2), margin + height * (1 - point.v));
}

// The text stands outside the triangle, along the edge.
std::string svg_label(int edge, int depth) {
  constexpr double gap = 16;
  const double x[3] = {side / 2, side * 3 / 4 + gap * std::sqrt(0.75), side / 4 - gap * std::sqrt(0.75)};
  const double y[3] = {height + gap + 4, height / 2 - gap / 2, height / 2 - gap / 2};
  const int turn[3] = {0, 60, -60};
  const int segments = 1 << depth;
  return fmt::format("<text transform=\"translate({:.2f},{:.2f}) rotate({})\">depth {}: {} {}</text>\n",
                     margin + x[edge], margin + y[edge], turn[edge], depth, segments,
                     segments == 1 ? "segment" : "segments");
}

}  // namespace

std::vector<PatternTriangle> pattern_triangles(std::array<int, 3> depths, pattern::Interior interior) {
  const int deepest = *std::max_element(depths.begin(), depths.end());
  const auto instances = pattern::expand(depths[0], depths[1], depths[2], interior);  // refuses what is out of range
  const pattern::Pool pool = pattern::build_pool(static_cast<unsigned>(std::max(deepest, pattern::lifted_interior)),
                                                 interior == pattern::Interior::morphing);
  std::vector<PatternTriangle> triangles;
  for (const pattern::Instance& instance : instances) {
    const pattern::Piece& piece = pool.pieces[static_cast<std::size_t>(instance.piece)];
    for (std::size_t k = 0; k < piece.index_count; k += 3) {
      PatternTriangle triangle{{}, part_of(instance.piece)};
      for (std::size_t corner = 0; corner < 3; ++corner)
        triangle.corners[corner] =
            place(pool.vertices[piece.base_vertex + pool.indices[piece.first_index + k + corner]], instance);
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

std::string pattern_as_svg(std::array<int, 3> depths, pattern::Interior interior) {
  constexpr const char* colours[] = {"#cfe0f3", "#f9dcb0", "#d5ecc8"};  // by Part
  std::string svg = fmt::format(
      "<!-- SPDX-FileCopyrightText: 2026 The glark authors -->\n<!-- SPDX-License-Identifier: MIT -->\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<g stroke=\"#1f3b5c\" stroke-width=\"1\" stroke-linejoin=\"round\">\n",
      side + 2 * margin, std::ceil(height + 2 * margin));
  for (const PatternTriangle& triangle : pattern_triangles(depths, interior))
    svg += fmt::format("<polygon fill=\"{}\" points=\"{} {} {}\"/>\n", colours[static_cast<int>(triangle.part)],
                       svg_point(triangle.corners[0]), svg_point(triangle.corners[1]), svg_point(triangle.corners[2]));
  svg += "</g>\n<g fill=\"#1f3b5c\" font-family=\"sans-serif\" font-size=\"14\" text-anchor=\"middle\">\n";
  for (int edge = 0; edge < 3; ++edge) svg += svg_label(edge, depths[static_cast<std::size_t>(edge)]);
  return svg + "</g>\n</svg>\n";
}

}  // namespace glark::tool
