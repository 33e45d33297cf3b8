// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The refinements, and the choices a user makes about them. The settings, the API, the derivation of programs and the
// statistics read the same rows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glark/gl/types.h"
#include "include/GL/glark.h"

namespace glark::core {

inline constexpr unsigned max_supported_level = 11;

// How refined vertices get their values. Each has a row in `refinements`.
enum class Refinement { linear_inputs, linear_outputs, pn, scalar_tagged_pn, phong };

// A number that shapes a refinement, the same for all vertices of a draw.
struct ShapeNumber {
  GLenum token = 0;                  // for glARKParameterfARK; 0: only the settings can set it
  std::string_view token_name = {};  // in the extension's text, as the next two
  std::string_view values = {};
  std::string_view initial_text = {};
  std::string_view key;            // in a configuration file; the option is "--" and this
  const char* variable = nullptr;  // of the environment; null: the refinement has no such number
  std::string_view placeholder;    // stands for the value in --help
  std::string_view needed;         // completes "... is needed"
  std::string_view help;
  float least = 0;
  float most = 0;
  float initial = 0;

  constexpr bool exists() const { return variable != nullptr; }
};

struct RefinementTraits {
  Refinement refinement = Refinement::linear_inputs;
  GLenum token = 0;             // value of GL_REFINEMENT_ARK
  std::string_view token_name;  // as in the extension's text
  std::string_view word;        // for users: --refine, names of dumped shaders; begins the names of its GLSL functions
  std::string_view help;        // a few words, for --help
  std::string_view details;     // a sentence, for the documents
  bool interpolates_outputs = false;  // runs the vertex stage at the corners only
  bool curves_positions = false;      // needs positions and normals; welded edges have control points in the record
  bool curves_normals = false;        // otherwise normals are linear
  bool takes_tags = false;            // of vertices: discontinuity and scalar tags
  std::optional<Refinement> displaced_as = std::nullopt;  // evaluates the same surface with displacement
  ShapeNumber number = {};
};

// To add a refinement: add a token to glark.xml and GL/glark.h, and an enumerator and a row here. If it curves
// positions, add refine/epilogue/WORD.glsl to the list of refine/CMakeLists.txt; pn.glsl says what this file must
// define. Outside the library, add it to the extension's text, docs/reference/api.md, and the conformance suite.
inline constexpr std::array refinements{
    // Boubekeur 2007, ch. 7.2.4
    RefinementTraits{.refinement = Refinement::linear_inputs,
                     .token = GL_LINEAR_INPUTS_ARK,
                     .token_name = "LINEAR_INPUTS_ARK",
                     .word = "linear",
                     .help = "the vertex stage runs on every refined vertex",
                     .details = "linear runs the program's vertex stage on every refined vertex. "},
    RefinementTraits{
        .refinement = Refinement::linear_outputs,
        .token = GL_LINEAR_OUTPUTS_ARK,
        .token_name = "LINEAR_OUTPUTS_ARK",
        .word = "outputs",
        .help = "its results are interpolated",
        .details = "outputs interpolates the results of the vertex stage, so that the picture stays the same. ",
        .interpolates_outputs = true},
    // Vlachos, Peters, Boyd, Mitchell, Curved PN Triangles, 2001
    RefinementTraits{.refinement = Refinement::pn,
                     .token = GL_CURVED_PN_ARK,
                     .token_name = "CURVED_PN_ARK",
                     .word = "pn",
                     .help = "curved",
                     .details = "pn makes curved PN triangles. ",
                     .curves_positions = true,
                     .curves_normals = true,
                     .displaced_as = Refinement::scalar_tagged_pn},
    // Boubekeur 2007, ch. 8
    RefinementTraits{.refinement = Refinement::scalar_tagged_pn,
                     .token = GL_SCALAR_TAGGED_PN_ARK,
                     .token_name = "SCALAR_TAGGED_PN_ARK",
                     .word = "stpn",
                     .help = "curved, with --tension",
                     .details = "stpn makes curved triangles that --tension shapes. ",
                     .curves_positions = true,
                     .curves_normals = true,
                     .takes_tags = true,
                     .number = {.initial_text = "0",
                                .key = "tension",
                                .variable = "GLARK_TENSION",
                                .placeholder = "T",
                                .needed = "a number from -1 to 1",
                                .help = "Set how flat --refine stpn is: 1 is flat, 0 is pn, -1 is rounder than pn",
                                .least = -1,
                                .most = 1}},
    // Boubekeur, Alexa, Phong Tessellation, 2008
    RefinementTraits{.refinement = Refinement::phong,
                     .token = GL_PHONG_ARK,
                     .token_name = "PHONG_ARK",
                     .word = "phong",
                     .help = "curved, normals linear, with --phong-shape",
                     .details = "phong bends triangles towards the tangent planes of their corners and keeps normals "
                                "linear, which is cheaper than pn.",
                     .curves_positions = true,
                     .number = {.token = GL_PHONG_SHAPE_ARK,
                                .token_name = "PHONG_SHAPE_ARK",
                                .values = "0 to 1",
                                .initial_text = "0.75",
                                .key = "phong-shape",
                                .variable = "GLARK_PHONG_SHAPE",
                                .placeholder = "A",
                                .needed = "a number from 0 to 1",
                                .help = "Set how far --refine phong bends triangles: 0 is flat",
                                .least = 0,
                                .most = 1,
                                .initial = 0.75F}},
};

constexpr const RefinementTraits& traits_of(Refinement refinement) {
  return refinements[static_cast<std::size_t>(refinement)];
}

constexpr bool rows_are_in_order() {
  for (std::size_t i = 0; i < refinements.size(); ++i)
    if (refinements[i].refinement != static_cast<Refinement>(i)) return false;
  return true;
}
static_assert(rows_are_in_order());

// The shape number of each refinement.
using ShapeNumbers = std::array<float, refinements.size()>;
constexpr ShapeNumbers initial_shape_numbers() {
  ShapeNumbers numbers{};
  for (std::size_t i = 0; i < refinements.size(); ++i) {
    numbers[i] = refinements[i].number.initial;
  }
  return numbers;
}

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

// How edge depths are measured where the application gives no tags. 0 turns a measure off. With two measures, an edge
// takes the lesser depth.
struct EdgeMeasure {
  float pixels = 0;     // longest segment of an edge on the screen
  float degrees = 0;    // greatest angle between the normals at the ends of a segment
  unsigned budget = 0;  // most refined triangles in a frame; 0: no limit
  bool on() const { return pixels > 0 || degrees > 0; }
  bool operator==(const EdgeMeasure&) const = default;
};

// The scalar tags of chapter 8, for vertices that carry none.
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

// The host's options for a context. Set once, when the context is created.
struct ContextOptions {
  bool transparent = false;  // refine a program that does not know of the extension
  unsigned level = 2;        // uniform level of transparent refinement
  unsigned max_level = 6;    // level of the pool built for transparent refinement
  Refinement refinement = Refinement::linear_inputs;
  ShapeNumbers shape_numbers = initial_shape_numbers();
  bool weld = true;          // weld curved triangles by position, if the program has split its vertices
  EdgeMeasure measure = {};  // on: transparent refinement by measured depths up to max_level
  bool geomorph = false;     // refined vertices move between the levels of measured depths
  bool centroids = false;    // quads and polygons become fans about their centroids
  bool wireframe = false;
  unsigned left_draws = left_draws::by_default;
  std::vector<std::uint64_t> left_shaders = {};  // programs that are left alone, by the hash of their sources
  AttributeRoles roles = {};
  bool read_counts = false;  // once a frame, reads back the counts that only the GPU knows, for the statistics
};

}  // namespace glark::core
