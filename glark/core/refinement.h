// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The choices a user makes about refinement, shared by the settings, the API and the stages of a draw.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace glark::core {

inline constexpr unsigned max_supported_level = 11;

enum class Refinement {
  linear_inputs,  // interpolate the vertex attributes, run the vertex stage on every refined vertex (Boubekeur 2007, ch. 7.2.4)
  linear_outputs,    // run the vertex stage on the corners, interpolate its results
  pn,                // curved PN triangles (Vlachos et al. 2001)
  scalar_tagged_pn,  // the same, shaped by tags of the vertices (Boubekeur 2007, ch. 8)
};

// Draws that transparent refinement leaves as they are: bits of ContextOptions::left_draws. The first three are left unless
// the user says otherwise; docs/architecture.md has the rules in full.
namespace left_draws {
inline constexpr unsigned screen_quads = 1U << 0;  // depth neither read nor written, one or two triangles
inline constexpr unsigned overlays = 1U << 1;      // depth neither read nor written, and blended
inline constexpr unsigned orthographic = 1U << 2;  // fixed function without perspective, depth neither read nor written
inline constexpr unsigned blended = 1U << 3;       // GL_BLEND on
inline constexpr unsigned no_depth_test = 1U << 4;    // GL_DEPTH_TEST off
inline constexpr unsigned no_depth_writes = 1U << 5;  // GL_DEPTH_TEST off, or glDepthMask(GL_FALSE)
inline constexpr unsigned by_default = screen_quads | overlays | orthographic;
}  // namespace left_draws

// Which vertex attribute is what, by its name in the vertex shader or by its location in digits; empty: guessed.
struct AttributeRoles {
  std::string position;
  std::string normal;
  std::string texture_coordinate;
  bool operator==(const AttributeRoles&) const = default;
};

// How edge depths are measured where the application gives no tags. 0 turns a measure off; of two, an edge takes the lesser depth.
struct EdgeMeasure {
  float pixels = 0;     // longest segment of an edge on the screen
  float degrees = 0;    // greatest angle between the normals at the ends of a segment
  unsigned budget = 0;  // refined triangles a frame that the measures give way to
  bool on() const { return pixels > 0 || degrees > 0; }
  bool operator==(const EdgeMeasure&) const = default;
};

// The scalar tags of chapter 8 where vertices carry none of their own.
struct ScalarTags {
  float sharpness = 0;  // 0 or more
  float tension = 0;    // -1 to 1
  float bias = 0;       // -1 to 1
  bool operator==(const ScalarTags&) const = default;
};

// Refined positions move along their normals by scale * texel + bias.
struct Displacement {
  int unit = -1;         // texture image unit with a two-dimensional texture; -1: none
  unsigned channel = 0;  // of the texel
  int coordinate = -1;   // location of the attribute with the texture coordinate; -1: by its role
  float scale = 1;
  float bias = 0;
  bool on() const { return unit >= 0; }
};

// What the host of the core wants of a context from its start.
struct ContextOptions {
  bool transparent = false;  // refine a program that does not know of the extension
  unsigned level = 2;        // uniform level of transparent refinement
  unsigned max_level = 6;    // level of the pool built for transparent refinement
  Refinement refinement = Refinement::linear_inputs;
  ScalarTags scalar_tags = {};  // of all vertices
  bool weld = true;             // curved triangles by position, where the program has split its vertices
  EdgeMeasure measure = {};     // on: transparent refinement by measured depths up to max_level
  bool geomorph = false;        // refined vertices move between the levels of measured depths
  bool centroids = false;       // quads and polygons become fans about their centroids
  bool wireframe = false;
  unsigned left_draws = left_draws::by_default;
  std::vector<std::uint64_t> left_shaders = {};  // programs that are left alone, by the hash of their sources
  AttributeRoles roles = {};
  bool read_counts = false;  // for the statistics: read back, once a frame, what only the GPU has counted
};

}  // namespace glark::core
