// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How log lines and dumped shaders name a program.
#pragma once

#include <string>
#include <vector>

#include "glark/core/state/programs/program.h"

namespace glark::refine {

// "program 3 [0123456789abcdef]": the name in GL and the hash of the sources.
std::string label(const core::Program& program);

// Hands the application's shaders to the shader sink.
void show_originals(const core::Program& program);
// Hands a derived vertex stage to the shader sink.
void show_derived(const core::Program& program, const core::DerivedKey& key,
                  const std::vector<std::string>& vertex_sources);

}  // namespace glark::refine
