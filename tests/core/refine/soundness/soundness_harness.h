// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "glark/core/refine/derive.h"

namespace glark::refine {

inline StageVariation variation_of(const std::vector<std::string>& sources, bool es = false) {
  const Inspection inspection = inspect_vertex_stage(sources, es);
  EXPECT_TRUE(inspection.ok) << inspection.error;
  return inspection.traits.variation;
}

inline Variation output_of(const StageVariation& stage, const std::string& path) {
  const OutputVariation* const output = stage.find(path);
  return output != nullptr ? output->variation : Variation::constant;
}

// How gl_Position varies.
inline Variation position_of(const std::string& source, bool es = false) {
  return output_of(variation_of({source}, es), "gl_Position");
}

inline std::string reason_of(const std::string& source, const std::string& path = "gl_Position") {
  const StageVariation stage = variation_of({source});
  const OutputVariation* const output = stage.find(path);
  return output != nullptr ? output->reason : std::string();
}

// A stage with an attribute vec4 p, a float attribute f, an int attribute n, and a uniform u.
inline std::string stage(const std::string& body, const std::string& declarations = "") {
  return "#version 330\nin vec4 p; in float f; in int n; uniform float u; uniform mat4 m;\n" + declarations +
         "\nvoid main() { " + body + " }\n";
}

}  // namespace glark::refine
