// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The sources of the programs whose binaries the application has taken (glGetProgramBinary). When it loads such a binary
// again, the program has these sources. Any thread may call these functions.
#pragma once

#include <cstdint>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "glark/core/state/programs/program.h"
#include "glark/gl/types.h"

namespace glark::core {

class ProgramBinaries {
 public:
  void remember(const void* binary, GLsizei length, const std::vector<StageSource>& stages);
  // Empty: the binary was not taken here.
  std::vector<StageSource> find(const void* binary, GLsizei length) const;

 private:
  mutable std::mutex mutex_;
  std::unordered_map<std::uint64_t, std::vector<StageSource>> stages_;  // by the hash of the binary
};

}  // namespace glark::core
