// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program/unsound_outputs.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace glark::refine {
namespace {

constexpr std::string_view color_words[] = {"color", "colour", "diffuse", "specular", "ambient", "emissi",   "light",
                                            "lit",   "shade",  "shading", "lambert",  "fog",     "luminance"};

bool is_sound(const OutputVariation& output, bool is_surface) {
  switch (output.variation) {
    case Variation::constant:
    case Variation::affine: return true;
    case Variation::continuous: return is_surface;
    case Variation::switched: return is_surface && is_color(output.path);
    case Variation::undefined: return false;
  }
  return false;
}

}  // namespace

bool is_color(const std::string& path) {
  std::string lower = path;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(std::begin(color_words), std::end(color_words),
                     [&](std::string_view word) { return lower.find(word) != std::string::npos; });
}

std::vector<OutputVariation> unsound_outputs(const StageVariation& stage, bool is_surface) {
  std::vector<OutputVariation> unsound;
  for (const OutputVariation& output : stage.outputs) {
    // Triangles have no point size.
    const bool decided_elsewhere = output.path == "gl_Position" || output.path == "gl_PointSize";
    if (!decided_elsewhere && !is_sound(output, is_surface)) unsound.push_back(output);
  }
  return unsound;
}

}  // namespace glark::refine
