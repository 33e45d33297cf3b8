// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/selection.h"

#include <fnmatch.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <stdexcept>

namespace glark::conformance {

bool matches(std::string_view glob, std::string_view name) {
  return fnmatch(std::string(glob).c_str(), std::string(name).c_str(), 0) == 0;
}

std::vector<std::string> read_list(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    line = line.substr(0, line.find('#'));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    lines.push_back(line.substr(first, line.find_last_not_of(" \t\r") + 1 - first));
  }
  if (file.bad()) throw std::runtime_error("cannot read " + path);
  return lines;
}

std::vector<std::string> select(const std::vector<std::string>& all, const Selection& selection) {
  for (const std::string& glob : selection.globs)
    if (std::none_of(all.begin(), all.end(), [&](const std::string& name) { return matches(glob, name); }))
      throw std::invalid_argument("no case matches " + glob);
  const std::set<std::string> known(all.begin(), all.end());
  for (const std::string& name : selection.names)
    if (known.count(name) == 0) throw std::invalid_argument("no case is named " + name);
  const std::set<std::string> listed(selection.names.begin(), selection.names.end());

  std::vector<std::string> chosen;
  for (const std::string& name : all) {
    const bool by_glob =
        selection.globs.empty() || std::any_of(selection.globs.begin(), selection.globs.end(),
                                               [&](const std::string& glob) { return matches(glob, name); });
    if (by_glob && (!selection.has_list || listed.count(name) != 0)) chosen.push_back(name);
  }
  // Takes every shards-th case. Neighbours take a similar time, so they go to different shards.
  std::vector<std::string> mine;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (static_cast<int>(i % static_cast<std::size_t>(selection.shards)) == selection.shard - 1)
      mine.push_back(chosen[i]);
  return mine;
}

}  // namespace glark::conformance
