// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How the outputs of a vertex stage vary over a coarse triangle, as functions of the vertex attributes.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace glark::refine {

// From the best to the worst.
enum class Variation {
  constant,    // the same at all vertices
  affine,      // running the stage between the corners gives the same as interpolating the outputs
  continuous,  // smooth, or with kinks (max, abs, clamp)
  switched,    // jumps where a comparison changes its result; between the jumps it is continuous
  undefined,   // has no meaning between vertices: floor, integers, texel fetches
};

// Where an output is interpolated over a triangle. Otherwise one corner gives its value.
enum class Interpolation { always, unless_flat_shaded, never };

struct OutputVariation {
  std::string path;  // "color", "block.color", "gl_Position"; elements of an array are taken together
  Variation variation = Variation::constant;
  std::string reason;                 // "line 12: floor() of 'vertexId'"; empty unless it is switched or undefined
  std::set<std::string> inputs = {};  // the attributes that it depends on
  Interpolation interpolation = Interpolation::always;
};

// All outputs of a vertex stage. An output that is not listed is constant.
struct StageVariation {
  std::vector<OutputVariation> outputs;

  const OutputVariation* find(std::string_view path) const;
  const OutputVariation* position() const { return find("gl_Position"); }
  bool is_affine() const;
};

inline bool StageVariation::is_affine() const {
  return std::all_of(outputs.begin(), outputs.end(),
                     [](const OutputVariation& output) { return output.variation <= Variation::affine; });
}

inline const OutputVariation* StageVariation::find(std::string_view path) const {
  for (const OutputVariation& output : outputs) {
    if (output.path == path) return &output;
  }
  return nullptr;
}

}  // namespace glark::refine
