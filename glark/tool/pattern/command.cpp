// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/pattern/command.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "glark/tool/pattern/drawing.h"

namespace glark::tool {
namespace {

constexpr int deepest_drawing = 7;  // 16384 triangles; the eye sees no more

// `parts` has the triangles of `minimum` and says to which part of the pattern they belong.
const std::map<std::string, pattern::Interior> interiors = {{"minimum", pattern::Interior::parts},
                                                            {"smooth", pattern::Interior::smooth},
                                                            {"morphing", pattern::Interior::morphing}};

// Returns what is wrong with the name of the drawing, or an empty text.
std::string is_svg(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension();
  if (ending.empty() || ending == ".svg" || ending == ".SVG") return {};
  return fmt::format("the drawing is SVG, but {} ends in {}; name it FILE.svg", file, ending);
}

}  // namespace

void describe_pattern(CLI::App& command, PatternOptions& options) {
  command
      .add_option("DEPTHS", options.depths,
                  "The depths of the bottom, the right and the left edge; depth d has 2^d segments")
      ->required()
      ->expected(3)
      ->check(CLI::Range(0, deepest_drawing))
      ->type_name("A B C");
  command
      .add_option("--interior", options.interior,
                  "minimum (fewest triangles), smooth (softer where depths differ) or morphing (of --geomorph) "
                  "(default: minimum)")
      ->check(CLI::IsMember(interiors))
      ->type_name("KIND");
  command
      .add_option("-o,--output", options.file,
                  "Write the drawing to FILE and print its number of triangles (default: standard output)")
      ->check(is_svg)
      ->type_name("FILE");
}

int draw_pattern(const PatternOptions& options) {
  const std::array<int, 3> depths = {options.depths[0], options.depths[1], options.depths[2]};
  const pattern::Interior interior = interiors.at(options.interior);
  const std::string svg = pattern_as_svg(depths, interior);
  if (options.file.empty()) return std::fputs(svg.c_str(), stdout) < 0 ? 1 : 0;
  std::ofstream out(options.file);
  out << svg;
  if (!out.flush()) {
    std::fprintf(stderr, "glark: %s cannot be written; name another file with -o\n", options.file.c_str());
    return 1;
  }
  const std::size_t triangles = pattern_triangles(depths, interior).size();
  fmt::print("{} triangle{}\n", triangles, triangles == 1 ? "" : "s");
  return 0;
}

}  // namespace glark::tool
