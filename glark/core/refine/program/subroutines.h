// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Subroutines are chosen per context, and glUseProgram resets the choice. A refined draw copies the choice to the
// derived program and restores it afterwards.
#pragma once

#include <vector>

#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::refine {

// Returns whether any stage of `program` has subroutine uniforms.
bool has_subroutine_uniforms(const gl::Dispatch& gl, const core::Program& program);

// Adds the subroutines that a stage of the program in use has chosen to `choice`. `program` provides this stage.
void read_subroutines(const gl::Dispatch& gl, GLuint program, GLenum stage, core::SubroutineChoice& choice);

// Chooses subroutines in the program in use. `tables` belong to a derived program and translate the numbers of its
// subroutines. Stages without a table use the numbers of the application's program.
void choose_subroutines(const gl::Dispatch& gl, const core::SubroutineChoice& choice,
                        const std::vector<core::SubroutineTable>& tables = {});

// Translates the subroutine numbers of `from` to those of `to`, which is derived from it.
std::vector<core::SubroutineTable> map_subroutines(const gl::Dispatch& gl, const core::Program& from, GLuint to);

}  // namespace glark::refine
