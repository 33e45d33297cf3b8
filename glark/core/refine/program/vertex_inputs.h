// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The vertex inputs of an application program, as GL reports them.
#pragma once

#include "glark/core/context_options.h"
#include "glark/core/state/programs/program.h"
#include "glark/gl/dispatch.h"

namespace glark::refine {

// Fills program.fields, in an order that does not depend on the driver. If an input cannot be captured, sets
// program.cause and logs the reason.
void read_vertex_inputs(const gl::Dispatch& gl, const core::AttributeRoles& roles, core::Program& program);

}  // namespace glark::refine
