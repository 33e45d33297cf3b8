// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes the uniforms, blocks and outputs of a derived program agree with the application's program.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::refine {

// Before linking: what `from` was linked with, and the locations of its fragment outputs, set on `to`.
void copy_link_settings(const gl::Dispatch& gl, const core::Program& from, GLuint to);

// After linking: fills derived.location_of.
void map_uniform_locations(const gl::Dispatch& gl, GLuint from, core::DerivedProgram& derived);

// Uniforms that only the refinement shader declares: their locations in `derived`, and their values from `other` (may
// be null), another program derived from the same one.
void copy_virtual_uniforms(const gl::Dispatch& gl, const std::vector<std::string>& names,
                           const core::DerivedProgram* other, core::DerivedProgram& derived);

// Values of all uniforms outside blocks, and the bindings of uniform and storage blocks. `handles`: those of bindless
// textures and images, by location in `from`; GL cannot be asked for them.
void copy_uniform_values(const gl::Dispatch& gl, GLuint from, const core::DerivedProgram& derived,
                         const std::map<GLint, GLuint64>& handles = {});
// The names of all uniforms of the default block, element by element. Nothing if the program has a uniform that is no
// number, that is built in, or that lies in a block; `but` may be anything.
std::optional<std::vector<std::string>> plain_uniforms(const gl::Dispatch& gl, GLuint program, const std::string& but);
void copy_block_bindings(const gl::Dispatch& gl, GLuint from, GLuint to);

}  // namespace glark::refine
