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

// The scalar tags of chapter 8, for vertices that carry none.
struct ScalarTags {
  float sharpness = 0;  // 0 or more
  float tension = 0;    // -1 to 1
  float bias = 0;       // -1 to 1
  bool operator==(const ScalarTags&) const = default;
};

}  // namespace glark::core
