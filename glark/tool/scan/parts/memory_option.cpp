// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/memory_option.h"
#include "glark/tool/scan/validators.h"

#include <unistd.h>

#include <limits>

namespace glark::tool {

void describe_memory(CLI::App& command, Memory& memory) {
  command
      .add_option_function<std::uint64_t>(
          "--memory",
          [&memory](const std::uint64_t& bytes) {
            memory = {bytes, true};
          },
          "The most memory for reading, as 256MB or 4GB, 128MB or more; default: three quarters of the machine's. "
          "Larger "
          "files are read in parts")
      ->transform(bytes_above_zero())
      ->check(CLI::Range(std::uint64_t{128} << 20, std::numeric_limits<std::uint64_t>::max()))
      ->type_name("BYTES");
}

Memory memory_for(const Memory& given) {
  if (given.is_given) return given;
  const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
  return {pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 4 * 3, false};
}

}  // namespace glark::tool
