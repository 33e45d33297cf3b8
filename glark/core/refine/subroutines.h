// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which subroutines a program runs is state of the context that glUseProgram resets: a refined draw takes the choice over to the
// derived program, and gives it back.
#pragma once

#include <vector>

#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::refine {

// Whether any stage of `program` has subroutine uniforms.
bool has_subroutine_uniforms(const gl::Dispatch& gl, const core::Program& program);

// Adds to `choice` what `stage` of the program in use, which `program` provides, has chosen.
void read_subroutines(const gl::Dispatch& gl, GLuint program, GLenum stage, core::SubroutineChoice& choice);

// Chooses for the program in use. `tables` (of a derived program) says how its subroutines are numbered; stages that they do not
// tell of are numbered as the application's.
void choose_subroutines(const gl::Dispatch& gl, const core::SubroutineChoice& choice,
                        const std::vector<core::SubroutineTable>& tables = {});

// How the subroutines of `from` are numbered in `to`, which is derived from it.
std::vector<core::SubroutineTable> map_subroutines(const gl::Dispatch& gl, const core::Program& from, GLuint to);

}  // namespace glark::refine
