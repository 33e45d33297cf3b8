// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Groups of rows, a file each: what one of them is about is in one place. A new one is a function here and a line in main.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/bench_points/table.h"

namespace glark::bench {

struct Settings {
  std::string data = GLARK_SCANS;
  std::vector<std::size_t> samples{1000000, 2000000, 5000000, 10000000};
  int rounds = 9;
};

std::vector<Table> partition_tables(const Settings& settings);
std::vector<Table> simplification_tables(const Settings& settings);
std::vector<Table> reconstruction_tables(const Settings& settings);
std::vector<Table> surfel_tables(const Settings& settings);

}  // namespace glark::bench
