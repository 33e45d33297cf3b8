// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glark::conformance {

// '*' stands for any characters, '?' for one.
bool matches(std::string_view glob, std::string_view name);

// Reads names, one a line; '#' begins a comment, and empty lines are ignored. Throws std::runtime_error that names the
// file.
std::vector<std::string> read_list(const std::string& path);

struct Selection {
  std::vector<std::string> globs = {};  // empty: every case
  std::vector<std::string> names = {};  // from a case list; empty: every case
  bool has_list = false;
  int shard = 1;  // of `shards`, from 1
  int shards = 1;
};

// The selected cases of `all`, in its order. Throws std::invalid_argument that names a glob or name without a case.
std::vector<std::string> select(const std::vector<std::string>& all, const Selection& selection);

}  // namespace glark::conformance
