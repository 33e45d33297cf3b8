// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/trim_memory.h"

#include <malloc.h>
#include <unistd.h>

#include <cstdio>

#include "glark/clients/common/resume/state_file.h"

namespace glark::stream {
namespace {

constexpr double near_limit = 0.8;

std::size_t resident_bytes() {
  const common::OpenFile file(std::fopen("/proc/self/statm", "r"));
  unsigned long pages = 0, resident = 0;
  if (!file || std::fscanf(file.get(), "%lu %lu", &pages, &resident) != 2) return 0;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void trim_memory(std::size_t limit) {
  if (static_cast<double>(resident_bytes()) > near_limit * static_cast<double>(limit)) malloc_trim(0);
}

}  // namespace glark::stream
