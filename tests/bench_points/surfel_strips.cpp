// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The rows of `glark-bench --filter surfel/`, which lies beside this program: table 5.1 of the thesis.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/bench_points/groups.h"

namespace glark::bench {
namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

}  // namespace

std::vector<Table> surfel_tables(const Settings& settings) {
  namespace fs = std::filesystem;
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "glark-bench";
  if (!fs::exists(program)) throw std::runtime_error(program.string() + " is missing; build it");
  const fs::path file = fs::temp_directory_path() / ("glark-bench-points." + std::to_string(getpid()) + ".json");
  const std::string command = quoted(program) + " --filter surfel/ --json " + quoted(file) +
                              (settings.rounds < 5 ? " --quick" : "") + " >/dev/null 2>&1";
  const int status = std::system(command.c_str());  // not 0 where a target is missed, too
  std::ifstream in(file);
  const nlohmann::json report = nlohmann::json::parse(in, nullptr, false);
  in.close();
  fs::remove(file);
  if (report.is_discarded()) throw std::runtime_error(command + " gave no report but status " + std::to_string(status));
  Table table{"Surfel strips, of one core", {"", "measured", "unit", "target", "thesis"}, {}};
  for (const nlohmann::json& row : report.at("rows")) {
    table.rows.push_back(
        {row.at("measure").get<std::string>(), Number{row.at("measured").get<double>(), 2},
         row.at("unit").get<std::string>(),
         row.value("target", nlohmann::json()).is_number() ? Cell{Number{row.at("target").get<double>(), 1}} : Cell{},
         row.value("best_known", std::string())});
  }
  table.note =
      "Table 5.1 of the thesis, preprocessing: face, 40881 points, 2 s; David, 258332, 12 s; Buddha, 543654, 26 s; "
      "Asian "
      "dragon, 3609601, 131 s: .020 to .028 M points/s.";
  return {table};
}

}  // namespace glark::bench
