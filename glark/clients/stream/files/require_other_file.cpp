// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/require_other_file.h"

#include <glark/stream.h>

namespace glark::stream {
namespace {

namespace fs = std::filesystem;

// Files that do not exist yet are compared by name.
bool are_same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::exists(a, error) && fs::exists(b, error)) return fs::is_regular_file(a, error) && fs::equivalent(a, b, error);
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

}  // namespace

void require_other_file(const fs::path& output, std::initializer_list<fs::path> inputs) {
  if (output.empty()) return;
  for (const fs::path& input : inputs)
    if (!input.empty() && are_same(output, input))
      throw Error(
          Element::option, 0,
          output.string() + ": is the same file as " + input.string() + ", which would be lost; write to another file");
}

}  // namespace glark::stream
