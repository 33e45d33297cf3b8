// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Groups of rows, each in its own file. A new group needs a function here and a line in main.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/bench_points/measure/table.h"

namespace glark::bench {

struct Settings {
  std::string data = GLARK_SCANS;
  std::vector<std::size_t> samples{1000000, 2000000, 5000000, 10000000};
  int rounds = 9;
};

std::vector<Table> partition_tables(const Settings& settings);
std::vector<Table> simplification_tables(const Settings& settings);
std::vector<Table> reconstruction_tables(const Settings& settings);
std::vector<Table> generated_cloud_tables(const Settings& settings);
std::vector<Table> generated_mesh_tables(const Settings& settings);
std::vector<Table> surfel_tables(const Settings& settings);
std::vector<Table> map_tables(const Settings& settings);

}  // namespace glark::bench
