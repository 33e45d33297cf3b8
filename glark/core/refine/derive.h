// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Derivation of the refinement program: the application's vertex stage, rewritten to run on refined vertices.
// Text in, text out; no GL.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/refinement.h"
#include "glark/core/state/programs/vertex_stage_traits.h"

namespace glark::refine {

// Names of the vertex inputs of a derived program; the caller binds their locations before linking.
inline constexpr const char* lattice_input = "glark_lattice";  // vec2: local barycentrics lu, lv in units of 2^-15
inline constexpr const char* patch_input = "glark_patch";      // vec4: placement of the piece
inline constexpr const char* chunk_input_prefix =
    "glark_chunk";  // vec4 glark_chunk0, glark_chunk1, ...: words of the coarse record

// For records that are too long for the chunks: a storage block with the words of all records, and the first word of
// the draw.
inline constexpr const char* records_block = "glark_Records";
inline constexpr const char* words_member = "glark_words";
inline constexpr const char* first_word_uniform = "glark_first_word";
inline constexpr unsigned records_binding = 4;
// uint, in OpenGL ES with a placement: the number of the instance among all bins. It takes the place of the first
// chunk.
inline constexpr const char* instance_input = "glark_instance";

// The ShapeNumber of the refinement.
inline constexpr const char* shape_number_uniform = "glark_shape_number";

// For displacement: a sampler; a vec4 that picks the channel of the texel; a vec2 of scale and bias.
inline constexpr const char* height_map_uniform = "glark_height_map";
inline constexpr const char* height_channel_uniform = "glark_height_channel";
inline constexpr const char* height_range_uniform = "glark_height_range";

// How later stages and fixed state treat the outputs of the vertex stage.
struct OutputRules {
  bool flat_colors = false;   // glShadeModel(GL_FLAT): built-in colours are flat
  bool clamp_colors = false;  // built-in colours end at 0 and 1 before they are interpolated
  // Outputs from which a geometry shader computes positions. It reads the value of every vertex, even if they are
  // `flat`.
  std::set<std::string> positions = {};
  // Outputs that are interpolated between the corners, even if the refinement runs the stage on interpolated inputs:
  // "color", "block.color".
  std::set<std::string> unsound = {};
};

struct DeriveRequest {
  std::vector<std::string> vertex_sources;  // one per vertex shader object, as compiled by the application
  bool es = false;                          // OpenGL ES context
  int context_glsl_version = 450;           // highest version of the context: 450, 320 (ES), ...
  capture::Layout layout;                   // where the coarse record holds each input
  core::Refinement refinement = core::Refinement::linear_inputs;
  // For a refinement that takes tags: the layout's fields for normal discontinuities and for scalar tags, vec3 or vec4.
  // -1: vertices carry no tags, and the constant tags apply.
  int discontinuity_field = -1;
  int scalar_tag_field = -1;
  core::ScalarTags scalar_tags;
  int coordinate_field =
      -1;  // field of the texture coordinate for displacement, two floats or more; -1: nothing is displaced
  bool stored = false;       // the record is read from the storage block
  bool at_corner = false;    // each vertex is one captured corner, which the chunks hold; nothing is refined
  bool at_points = false;    // only the position counts; each vertex is a triangle, and instances are lattice points
  bool morphing = false;     // the placement holds edge depths, and vertices move between levels; with a placement only
  bool creased = false;      // welded edges may be straight although their normals lean along them
  bool placed = true;        // false: without the patch input; the piece covers the triangle
  int provoking_corner = 2;  // corner whose value a flat output takes
  OutputRules outputs;
  std::string refinement_source;  // the application's own refinement shader (glRefinementShaderSourceARK), or empty
  std::vector<std::string>
      extensions;  // of the context ("GL_ARB_..."): which GL_ macros its preprocessor defines; empty: unknown
};

struct Inspection {
  bool ok = false;
  VertexStageTraits traits;
  std::string error;  // one line: which construct, why, what the user can do
};

struct Derivation {
  bool ok = false;
  std::vector<std::string> vertex_sources;  // as many as in the request
  std::string error;
  std::string prefix = {};      // begins our names in the sources
  bool corner_outputs = false;  // some outputs come from the corners of the coarse triangle
};

// Parses the vertex stage. Never throws; malformed GLSL gives ok = false and an error that names the line.
// `extensions` as in DeriveRequest. `constants`: names of attributes that are the same at all corners of a triangle.
Inspection inspect_vertex_stage(const std::vector<std::string>& vertex_sources, bool es,
                                const std::vector<std::string>& extensions = {},
                                const std::set<std::string>& constants = {});

// Rewrites the vertex stage. With `reads_vertex_id` the caller asks for Refinement::linear_outputs.
Derivation derive_vertex_stage(const DeriveRequest& request);

}  // namespace glark::refine
