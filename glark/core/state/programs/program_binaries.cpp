// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/programs/program_binaries.h"

#include <functional>
#include <string_view>

namespace glark::core {
namespace {

std::uint64_t hash_of(const void* binary, GLsizei length) {
  const std::string_view bytes(static_cast<const char*>(binary), static_cast<std::size_t>(length));
  return std::hash<std::string_view>{}(bytes);
}

}  // namespace

void ProgramBinaries::remember(const void* binary, GLsizei length, const std::vector<StageSource>& stages) {
  if (stages.empty()) {
    return;
  }
  const std::uint64_t hash = hash_of(binary, length);
  const std::lock_guard lock(mutex_);
  stages_[hash] = stages;
}

std::vector<StageSource> ProgramBinaries::find(const void* binary, GLsizei length) const {
  if (binary == nullptr || length <= 0) {
    return {};
  }
  const std::uint64_t hash = hash_of(binary, length);
  const std::lock_guard lock(mutex_);
  const auto found = stages_.find(hash);
  return found != stages_.end() ? found->second : std::vector<StageSource>();
}

}  // namespace glark::core
