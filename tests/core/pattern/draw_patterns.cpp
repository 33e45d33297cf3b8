// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-pattern-drawings DIR: writes the drawings of docs/explanation/patterns.md as SVG, from the pool of the library.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "tests/core/pattern/assembly.h"

namespace {

using glark::pattern::Interior;
using glark::pattern::testing::Point;

struct Drawing {
  const char* name;
  int depths[3];
  Interior interior;
};
constexpr Drawing drawings[] = {
    {"uniform", {3, 3, 3}, Interior::minimum},   {"mixed", {2, 3, 5}, Interior::minimum},
    {"smooth", {2, 3, 5}, Interior::smooth},     {"fan", {0, 3, 1}, Interior::minimum},
    {"morphing", {2, 3, 5}, Interior::morphing},
};

constexpr double side = 480;
constexpr double margin = 8;
const double height = side * std::sqrt(0.75);

// Corner 0 is on the left, corner 1 on the right, corner 2 at the top.
std::string svg_point(const Point& point) {
  const double u = static_cast<double>(point.u) / glark::pattern::testing::whole;
  const double v = static_cast<double>(point.v) / glark::pattern::testing::whole;
  char text[64];
  std::snprintf(text, sizeof text, "%.2f,%.2f", margin + side * (u + v / 2), margin + height * (1 - v));
  return text;
}

bool write_drawing(const Drawing& drawing, const std::string& folder) {
  const bool nested = drawing.interior == Interior::morphing;
  const glark::pattern::Pool pool = glark::pattern::build_pool(6, nested);
  const auto& [e0, e1, e2] = drawing.depths;
  const auto assembly = glark::pattern::testing::assemble(pool, glark::pattern::expand(e0, e1, e2, drawing.interior));
  std::ofstream out(folder + "/" + drawing.name + ".svg");
  out << "<!-- SPDX-FileCopyrightText: 2026 The glark authors -->\n<!-- SPDX-License-Identifier: MIT -->\n"
      << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << side + 2 * margin << "\" height=\""
      << std::ceil(height + 2 * margin)
      << "\">\n<g fill=\"#dce6f2\" stroke=\"#1f3b5c\" stroke-width=\"1\" stroke-linejoin=\"round\">\n";
  for (const auto& triangle : assembly.triangles)
    out << "<polygon points=\"" << svg_point(triangle[0]) << ' ' << svg_point(triangle[1]) << ' '
        << svg_point(triangle[2]) << "\"/>\n";
  out << "</g>\n</svg>\n";
  return static_cast<bool>(out.flush());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: glark-pattern-drawings DIR\n");
    return 2;
  }
  for (const Drawing& drawing : drawings)
    if (!write_drawing(drawing, argv[1])) {
      std::fprintf(stderr, "glark-pattern-drawings: %s/%s.svg cannot be written\n", argv[1], drawing.name);
      return 1;
    }
  return 0;
}
