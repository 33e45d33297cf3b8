// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds the GL program that draws the refined triangles of an application program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glark/core/capture/layout.h"
#include "glark/core/context_options.h"
#include "glark/core/refine/derive.h"
#include "glark/core/refine/fixed_function/fixed_function.h"
#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::refine {

struct BuilderTraits {
  bool transparent = false;  // the program does not know that it is refined
  capture::Language language = capture::Language::compatibility;
  int glsl_version = 450;
  GLint max_vertex_attributes = 16;
  GLint max_feedback_components = 64;
  GLint max_vertex_storage_blocks = 0;
  std::vector<std::string> extensions;  // of the context: what its preprocessor defines
  core::AttributeRoles roles;           // as the user set them
  core::ScalarTags scalar_tags;         // for vertices that carry no tags
  GLuint lattice_location = 0;
  GLuint patch_location = 1;
  GLuint first_chunk_location = 2;
};

class ProgramBuilder {
 public:
  ProgramBuilder(const gl::Dispatch& gl, const BuilderTraits& traits) : gl_(gl), traits_(traits) {}

  // Fills in the fields and traits of a linked program, and the cause if it cannot be refined. Only reads from GL.
  void prepare(core::Program& program) const;

  // How the outputs vary if the inputs at these locations (bit i: location i) are the same at all corners of a triangle.
  // Analyses the program when it is first asked for such locations.
  const StageVariation& variation(core::Program& program, std::uint32_t instanced) const;

  // Returns the derived program for `key`, with the current uniform values; nullptr (and a line in the log) if it
  // cannot be built. It follows the uniforms of `owner`, the application's program; null for plain fixed function.
  std::shared_ptr<core::DerivedProgram> derive(core::Program& program, core::Program* owner,
                                               const core::DerivedKey& key) const;

  // A Program that holds a vertex stage of ours beside the fragment stages of `fragment` (may be null). Its name is 0 if
  // GL refuses the source; the log then says what `what` is.
  std::shared_ptr<core::Program> generated(const std::string& source, std::string_view what,
                                           const core::Program* fragment) const;
  // A Program that holds the generated vertex stage of `state` beside the fragment stages of `fragment` (may be null).
  std::shared_ptr<core::Program> fixed_function(const FixedFunctionState& state, const core::Program* fragment) const;

  // Deletes the GL programs derived from `program`. A program that another context is drawing with is deleted at a
  // later call.
  void discard(core::Program& program);

 private:
  GLuint compile_and_link(const core::Program& program, const std::vector<std::string>& vertex_sources,
                          const core::Program* settings_of, const core::DerivedKey& key, std::string& error) const;
  void check_inputs(core::Program& program) const;
  void bind_inputs(GLuint name, const core::DerivedKey& key) const;
  bool needs_stage(GLenum stage, bool positions_only) const;
  int most_chunks(bool placed) const;
  capture::WeldedWords welded_words(const core::Program& program, const std::vector<capture::Field>& fields,
                                    int coordinate_field, const core::DerivedKey& key) const;
  bool can_store_records(const core::Program& program) const;
  DeriveRequest request_for(core::Program& program, const core::DerivedKey& key) const;
  Derivation derive_if_it_fits(const core::Program& program, const DeriveRequest& request) const;
  void find_uniforms(const DeriveRequest& request, core::DerivedProgram& derived) const;
  void follow_uniforms(core::Program& program, core::Program* owner,
                       const std::shared_ptr<core::DerivedProgram>& derived) const;

  const gl::Dispatch& gl_;
  BuilderTraits traits_;
  std::vector<std::shared_ptr<core::DerivedProgram>> discarded_;  // programs that are not deleted yet
};

}  // namespace glark::refine
