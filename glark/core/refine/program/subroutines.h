// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Subroutines are chosen per context, and glUseProgram resets the choice. A refined draw copies the choice to the derived program and
// restores it afterwards.
#pragma once

#include <vector>

#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::refine {

// Whether any stage of `program` has subroutine uniforms.
bool has_subroutine_uniforms(const gl::Dispatch& gl, const core::Program& program);

// Adds to `choice` what `stage` of the program in use, which `program` provides, has chosen.
void read_subroutines(const gl::Dispatch& gl, GLuint program, GLenum stage, core::SubroutineChoice& choice);

// Chooses for the program in use. `tables` belong to a derived program and translate the numbers of its subroutines. Stages without a
// table are numbered as in the application's program.
void choose_subroutines(const gl::Dispatch& gl, const core::SubroutineChoice& choice,
                        const std::vector<core::SubroutineTable>& tables = {});

// How the subroutines of `from` are numbered in `to`, which is derived from it.
std::vector<core::SubroutineTable> map_subroutines(const gl::Dispatch& gl, const core::Program& from, GLuint to);

}  // namespace glark::refine
