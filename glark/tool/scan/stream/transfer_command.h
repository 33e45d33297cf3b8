// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The arguments and the report of a transfer, by one process or by several.
#pragma once

#include <glark/stream.h>

#include <CLI/CLI.hpp>
#include <string>

#include "glark/tool/scan/console.h"

namespace glark::tool {

struct TransferCommand {
  std::string input, from, to, output;
  stream::TransferOptions options;
  bool json = false;
};

// Adds all arguments but --resume. `transfer` must live as long as the command.
void describe(CLI::App& command, TransferCommand& transfer);

// Warns of a scan that is not the sampling's. Returns the lines to print.
Report report_of(const TransferCommand& transfer, const stream::TransferReport& report, double seconds);

}  // namespace glark::tool
