// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One function a command: adds it to the application and what it does to its callback. What goes wrong is thrown.
#pragma once

#include <CLI/CLI.hpp>

namespace glark::tool {

void add_info(CLI::App& app);
void add_reconstruct(CLI::App& app);
void add_simplify(CLI::App& app);
void add_strip(CLI::App& app);

}  // namespace glark::tool
