// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The text that glark adds to the application's vertex stage: the vertex inputs of the derived program, the code that
// fills the application's globals from the coarse record, and main. In these texts '@' stands for the prefix of our
// names; derive.cpp replaces it. GLSL has no such character, so the application's names cannot contain it.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/refine/derive.h"
#include "glark/core/refine/glsl/rewrite.h"
#include "glark/core/refine/glsl/types.h"

namespace glark::refine {

// A field of the coarse record and the global that it fills.
struct InputVariable {
  capture::Field field;
  std::string global;  // "position", "@Vertex"
  const NumericType* type = nullptr;
};

// An output of the vertex stage, declared in or (built-in) assigned to unit `unit`.
struct OutputVariable {
  std::size_t unit = 0;
  std::string path;     // "color", "block.color", "gl_Position"
  std::string written;  // the global that the stage writes in its place; empty: the output itself
  std::string type;
  std::vector<std::string> sizes;  // array sizes, none open
  bool flat = false;
  bool by_shade_model = false;  // flat under glShadeModel(GL_FLAT)
  bool noperspective = false;
  int indexed_words = 0;  // size of an array whose indices are not all constants
  bool clamped = false;   // to 0 .. 1
  bool unsound = false;   // interpolated between the corners in every refinement
  std::string problem;    // why it cannot be saved; empty if it can
};

struct EpiloguePlan {
  GlslVersion version;
  core::Refinement refinement = core::Refinement::linear_inputs;
  bool at_corner = false;  // see DeriveRequest
  bool at_points = false;  // see DeriveRequest
  bool placed = true;
  bool stored = false;
  int provoking_corner = 2;
  int corner_words = 0;
  int control_offset = -1;  // word of the welded control points in a corner; -1: computed from the corners' own normals
  bool creased = false;     // see DeriveRequest
  int border_offset = -1;   // word of the welded normals and coordinates for displacement; -1: the triangle's own
  int chunk_count = 0;
  std::vector<InputVariable> inputs;
  std::optional<InputVariable> discontinuity;  // of the normals, and the tags; constants if vertices carry none
  std::optional<InputVariable> scalar_tags;
  core::ScalarTags constant_tags;
  std::optional<InputVariable> coordinate;  // for displacement
  std::vector<OutputVariable> outputs;      // all outputs if they are interpolated, otherwise the flat and unsound ones
  bool morphing = false;                    // the placement holds edge depths; vertices move between levels
  std::vector<OutputVariable> morphed;      // outputs that are mixed with those at the neighbours of the level below
  std::vector<Structure> structures;
  std::vector<bool> resets;  // per unit: has a function that initialises its globals again
  std::size_t main_unit = 0;
  std::string refinement_source;  // rewritten text of the application's refinement shader, or empty
  std::set<std::string> refinement_identifiers;

  const core::RefinementTraits& traits() const { return core::traits_of(refinement); }
  bool interpolates_outputs() const { return traits().interpolates_outputs; }
  // The stage runs at all corners, because some outputs are interpolated.
  bool runs_at_corners() const;
  bool curved() const { return traits().curves_positions; }
  bool displaced() const { return coordinate.has_value(); }
  // Some outputs vary linearly on the screen.
  bool has_screen_outputs() const;
};

using TypeSet = std::set<std::string>;

// chunks.cpp: the record as expressions, and the statements that fill the inputs.
std::string chunk_declarations(const EpiloguePlan& plan);
std::string corner_expression(const EpiloguePlan& plan, const InputVariable& input, int element, int corner);
// Words of a corner as a vector.
std::string corner_vector(const EpiloguePlan& plan, int offset, int corner, int words = 3);
std::string fill_from_corner(const EpiloguePlan& plan, int corner);
std::string fill_by_interpolation(const EpiloguePlan& plan, TypeSet& mixed_types);
// Definitions or prototypes of "T @mix(T, T, T)".
std::string mix_functions(const TypeSet& types, bool define);

// surface.cpp: the position and the normal on the curved triangle.
// Returns the input that is curved or displaced, and its normal; null if the stage has no such input of a fitting type.
const InputVariable* position_of(const EpiloguePlan& plan);
const InputVariable* normal_of(const EpiloguePlan& plan);
// The GLSL functions of the refinement, of displacement too if `plan` displaces.
std::string surface_functions(const EpiloguePlan& plan);
std::string fill_from_surface(const EpiloguePlan& plan, TypeSet& mixed_types);
// The first `rows` components of a vector at a corner. A missing fourth component is 1.
std::string resized(const EpiloguePlan& plan, const InputVariable& input, int corner, int rows);
// `value` for the first three components; the fourth, if the input has one, stays linear.
std::string with_linear_w(const EpiloguePlan& plan, const InputVariable& input, const std::string& value,
                          TypeSet& mixed_types);
// The argument list of WORD_patch() and WORD_slopes(), without the closing parenthesis.
std::string patch_arguments(const EpiloguePlan& plan);

// scalar_tags.cpp: the surface that tags of the vertices shape.
// Declares @c0, @c1 and @c2: the corners with their tags.
std::string tagged_corners(const EpiloguePlan& plan);
std::string fill_from_tagged_surface(const EpiloguePlan& plan, TypeSet& mixed_types);

// displacement.cpp: moves the position and turns the normal, after they are filled.
std::string displacement_uniforms(const EpiloguePlan& plan);
std::string displace(const EpiloguePlan& plan, TypeSet& mixed_types);

// outputs.cpp
std::vector<OutputVariable> collect_outputs(const std::vector<VertexUnit>& units, std::size_t main_unit,
                                            const OutputRules& rules);
bool is_flat(const OutputVariable& output, const std::vector<Structure>& structures);
// Itself, or a member at any depth.
bool has_integers(const OutputVariable& output, const std::vector<Structure>& structures);
// "blocks[1].color" -> "blocks.color"
std::string without_indices(std::string path);
// Functions "@save<slot>_<unit>", "@finish_<unit>" and "@finish_screen_<unit>" of one unit, with the variables that
// they need.
std::string output_functions(const EpiloguePlan& plan, std::size_t unit, TypeSet& mixed_types);
bool unit_has_outputs(const EpiloguePlan& plan, std::size_t unit);
bool unit_has_screen_outputs(const EpiloguePlan& plan, std::size_t unit);

// indexed_outputs.cpp: lets the stage write globals in place of matrices, and of arrays whose index is not constant. Compilers
// make a choice among all elements of such an output wherever it is written, and the stage is inlined at each corner. A
// global stays an array. Returns the declarations of the globals, and sets OutputVariable::written.
std::string replace_indexed_outputs(VertexUnit& unit, const std::string& prefix, std::vector<OutputVariable>& outputs);

// Functions "@begin_<unit>", "@gather_<unit>" and "@settle_<unit>": see add_functions().
std::string morph_functions(const EpiloguePlan& plan, std::size_t unit, TypeSet& added_types);

// morph.cpp
std::string morph_place_function();
std::string run_between_parents(const EpiloguePlan& plan);
std::string prototypes_of_morphed_unit(const EpiloguePlan& plan, std::size_t unit);
std::string add_functions(const TypeSet& types, bool define);
bool unit_has_morphed_outputs(const EpiloguePlan& plan, std::size_t unit);

// epilogue.cpp
// Directives that must follow #version.
std::string epilogue_header(const EpiloguePlan& plan, const IdentifierSet& application_identifiers);
// Text in front of and behind the application's refinement shader, at the end of the unit that defines main.
struct MainEpilogue {
  std::string declarations;
  std::string main;
};
MainEpilogue main_epilogue(const EpiloguePlan& plan, const std::string& declarations_of_inputs);
// Text at the end of a unit that does not define main.
std::string unit_epilogue(const EpiloguePlan& plan, std::size_t unit);

}  // namespace glark::refine
