// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One function for each command, as in glark/tool/scan/commands.h. The ranks must live as long as the application.
#pragma once

#include <CLI/CLI.hpp>

#include "glark/tool/mpi/mpi_ranks.h"
#include "glark/tool/scan/console.h"

namespace glark::tool {

void add_sample(CLI::App& app, MpiRanks& ranks);
void add_simplify(CLI::App& app, MpiRanks& ranks);
void add_transfer(CLI::App& app, MpiRanks& ranks);

// Adds what the ranks have sent, and the most memory and CPU time of a rank. Rank 0 prints the report.
void print_of_all(MpiRanks& ranks, Report report, bool json);

}  // namespace glark::tool
