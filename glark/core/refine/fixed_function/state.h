// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "glark/core/refine/fixed_function/fixed_function.h"
#include "glark/gl/dispatch.h"

namespace glark::refine {

// The outputs of the fixed-function vertex stage that the application's fragment stage reads.
struct FragmentReads {
  bool own_fragment_stage = false;
  unsigned texture_units = 0;  // bit i: texture coordinates i
};

// Finds the inputs in the text of a GLSL or ARB assembly fragment program: gl_TexCoord[2], fragment.texcoord[2].
// Returns all units if an index is not literal.
FragmentReads fragment_reads(const std::string& source);

// Reads the enables and modes of the current context by GL queries; call it only after a change. Changes nothing
// (restores the active texture unit). `fog_distance`: the context has GL_NV_fog_distance.
FixedFunctionState read_fixed_function_state(const gl::Dispatch& gl, const FragmentReads& fragment, bool fog_distance);

}  // namespace glark::refine
