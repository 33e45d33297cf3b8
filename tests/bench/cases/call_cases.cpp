// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures the cost of calls that pass through the library. Two programs, with the library and without it, run in turn.
// The best time of each is compared.
#include <unistd.h>

#include <array>
#include <climits>
#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "tests/bench/cases/case.h"

namespace glark::bench {
namespace {

constexpr int runs = 12;
constexpr double most_added = 2;  // in nanoseconds

std::string folder_of_this_program() {
  std::array<char, PATH_MAX> path{};
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size() - 1);
  const std::string whole(path.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  return whole.substr(0, whole.rfind('/') + 1);
}

using Least = std::map<std::string, double>;

void run_program(const std::string& program, Least& least) {
  FILE* pipe = popen(("'" + folder_of_this_program() + program + "'").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + program);
  std::array<char, 128> line{};
  int lines = 0;
  while (std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr) {
    std::istringstream words(line.data());
    std::string name;
    double nanoseconds = 0;
    if (words >> name >> nanoseconds) {
      const auto [entry, fresh] = least.emplace(name, nanoseconds);
      if (!fresh && nanoseconds < entry->second) entry->second = nanoseconds;
      ++lines;
    }
  }
  if (pclose(pipe) != 0 || lines == 0) throw std::runtime_error(program + " failed");
}

void run(Report& report, const Effort&) {
  Least with;
  Least without;
  for (int i = 0; i < runs; ++i) {
    run_program(i % 2 == 0 ? "glark-bench-calls" : "glark-bench-plain", i % 2 == 0 ? with : without);
    run_program(i % 2 == 0 ? "glark-bench-plain" : "glark-bench-calls", i % 2 == 0 ? without : with);
  }
  for (const auto& [name, nanoseconds] : with) {
    const double plain = without.at(name);
    report.add({"call/" + name + "/added",
                "",
                Goal::at_most,
                most_added,
                nanoseconds - plain,
                "ns",
                {{"with_ns", nanoseconds}, {"without_ns", plain}}});
  }
}

}  // namespace

void add_call_cases(std::vector<Case>& cases) { cases.push_back({"call", run}); }

}  // namespace glark::bench
