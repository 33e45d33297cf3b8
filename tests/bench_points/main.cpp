// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-bench-points compares the client libraries for points with other libraries. docs/reference/points.md has the figures.
//   glark-bench-points [--only GROUP] [--data FOLDER] [--samples N,N,...] [--rounds N] [--json FILE] [--update docs/reference/points.md]
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/bench_points/groups.h"

namespace glark::bench {
namespace {

struct Group {
  const char* name;
  std::vector<Table> (*tables)(const Settings& settings);
};

constexpr Group groups[] = {
    {"partition", partition_tables},
    {"simplification", simplification_tables},
    {"reconstruction", reconstruction_tables},
    {"generated-clouds", generated_cloud_tables},
    {"generated-meshes", generated_mesh_tables},
    {"surfel", surfel_tables},
#if GLARK_HAS_MAPS
    {"maps", map_tables},
#endif
};

constexpr const char* help =
    "glark-bench-points: what the client libraries for points do, side by side with what others do, as tables of "
    "Markdown.\n"
    "  --only GROUP          partition, simplification, reconstruction, generated-clouds,\n"
    "                        generated-meshes, surfel or maps; all if not given\n"
    "  --data FOLDER         where NAME.ply or NAME.ply.zst of the scans are\n"
    "  --samples N,N,...     sizes of the sampled sets\n"
    "  --rounds N            how often everything is done, of which the least time counts\n"
    "  --json FILE           the same for programs\n"
    "  --update FILE.md      put the tables where the file has such ones\n";

struct Command {
  bool asks_for_help = false;
  Settings settings;
  std::string only, json, update;
};

std::vector<std::size_t> numbers_of(const std::string& list) {
  std::vector<std::size_t> numbers;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) numbers.push_back(std::stoul(word));
  return numbers;
}

Command command_of(int count, char** words) {
  const std::string options = "options are --only, --data, --samples, --rounds, --json and --update";
  Command command;
  for (int i = 1; i < count; i += 2) {
    const std::string word = words[i];
    if (word == "--help" || word == "-h") {
      command.asks_for_help = true;
      return command;
    }
    if (i + 1 == count) throw std::runtime_error(word + ": give a value, or nothing; " + options);
    const std::string value = words[i + 1];
    if (word == "--data") {
      command.settings.data = value;
    } else if (word == "--samples") {
      command.settings.samples = numbers_of(value);
    } else if (word == "--rounds") {
      command.settings.rounds = std::stoi(value);
    } else if (word == "--only") {
      command.only = value;
    } else if (word == "--json") {
      command.json = value;
    } else if (word == "--update") {
      command.update = value;
    } else {
      throw std::runtime_error(word + " is no option; " + options);
    }
  }
  return command;
}

void run(const Command& command) {
  if (command.asks_for_help) {
    std::fputs(help, stdout);
    return;
  }
  std::vector<Table> all;
  for (const Group& group : groups) {
    if (!command.only.empty() && command.only != group.name) continue;
    std::fprintf(stderr, "%s ...\n", group.name);
    std::vector<Table> tables = group.tables(command.settings);
    std::fputs(markdown_of(tables).c_str(), stdout);
    std::fflush(stdout);
    all.insert(all.end(), tables.begin(), tables.end());
  }
  if (all.empty()) throw std::runtime_error("--only " + command.only + ": there is no such group");
  if (!command.update.empty()) replace_in(command.update, markdown_of(all));
  if (command.json.empty()) return;
  std::ofstream out(command.json);
  out << json_of(all);
  if (!out.flush()) throw std::runtime_error(command.json + " cannot be written");
}

}  // namespace
}  // namespace glark::bench

int main(int count, char** words) {
  try {
    glark::bench::run(glark::bench::command_of(count, words));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glark-bench-points: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
