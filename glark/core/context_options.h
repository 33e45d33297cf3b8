// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The choices that a host makes for a context. The settings read them from the user; glark/settings/table.cpp has the defaults
// that the user sees.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glark/core/draw_rule.h"
#include "glark/core/live/live_view.h"
#include "glark/core/refinement.h"

namespace glark::core {

// Draws that transparent refinement leaves as they are: bits of ContextOptions::left_draws. man glark explains the
// rules.
namespace left_draws {
inline constexpr unsigned screen_quads = 1U << 0;  // depth neither read nor written, one or two triangles
inline constexpr unsigned overlays = 1U << 1;      // depth neither read nor written, and blended
inline constexpr unsigned orthographic = 1U << 2;  // fixed function without perspective, depth neither read nor written
inline constexpr unsigned blended = 1U << 3;       // GL_BLEND on
inline constexpr unsigned no_depth_test = 1U << 4;    // GL_DEPTH_TEST off
inline constexpr unsigned no_depth_writes = 1U << 5;  // GL_DEPTH_TEST off, or glDepthMask(GL_FALSE)
inline constexpr unsigned by_default = screen_quads | overlays | orthographic;
}  // namespace left_draws

// The name of each attribute in the vertex shader, or its location in digits. Empty: glark guesses it.
struct AttributeRoles {
  std::string position;
  std::string normal;
  std::string texture_coordinate;
  bool operator==(const AttributeRoles&) const = default;
};

// How edge depths are measured where the application gives no tags. 0 turns a measure off. With several measures, an
// edge takes the least depth.
struct EdgeMeasure {
  float pixels = 0;      // longest segment of an edge on the screen
  float degrees = 0;     // greatest angle between the normals at the ends of a segment
  float error = 0;       // greatest distance of an edge's curve from its segments on the screen, in pixels
  unsigned budget = 0;   // most refined triangles in a frame; 0: no limit
  unsigned changes = 0;  // how often the application has changed these values
  bool on() const { return pixels > 0 || degrees > 0 || error > 0; }
  bool operator==(const EdgeMeasure&) const = default;
};

// The host's options for a context. Context::change_options() changes them between two frames.
struct ContextOptions {
  bool transparent = false;  // refine a program that does not know of the extension
  unsigned level = 2;        // uniform level of transparent refinement
  unsigned max_level = 6;    // level of the pool built for transparent refinement
  Refinement refinement = Refinement::linear_inputs;
  bool smooth = false;  // only meshes are refined that have one shape in all passes (meshes/mesh_table.h)
  ShapeNumbers shape_numbers = initial_shape_numbers();
  bool weld = true;   // weld curved triangles by position, if the program has split its vertices
  float crease = 80;  // degrees; edges stay straight whose faces meet at more although they share their normals
  bool geometry_normals = false;  // meshes without normals get normals made from positions; needs `weld`
  EdgeMeasure measure = {};       // on: transparent refinement by measured depths up to max_level
  bool geomorph = false;          // refined vertices move between the levels of measured depths
  bool centroids = false;         // quads and polygons become fans about their centroids
  bool wireframe = false;
  unsigned left_draws = left_draws::by_default;
  std::vector<std::uint64_t> left_shaders = {};  // programs that are left alone, by the hash of their sources
  std::vector<DrawRule> rules = {};              // of transparent refinement; the first one that matches applies
  AttributeRoles roles = {};
  std::uint64_t kept_vertex_bytes = std::uint64_t{256} << 20;  // of refined vertices that a context keeps
  bool wait =
      true;  // compile what a draw needs at once; else a few programs in each frame, and draw unrefined until then
  bool read_counts = false;  // once a frame, reads back the counts that only the GPU knows, for the statistics
  LiveView live = {};
};

}  // namespace glark::core
