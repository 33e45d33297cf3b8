// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One function for each command. It adds the command and its callback to the application. Callbacks throw exceptions.
#pragma once

#include <CLI/CLI.hpp>

namespace glark::tool {

void add_bake(CLI::App& app);
void add_edit(CLI::App& app);
void add_info(CLI::App& app);
void add_reconstruct(CLI::App& app);
void add_sample(CLI::App& app);
void add_simplify(CLI::App& app);
void add_strip(CLI::App& app);
void add_transfer(CLI::App& app);

}  // namespace glark::tool
