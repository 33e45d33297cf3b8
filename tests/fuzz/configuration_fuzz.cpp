// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any text as a configuration file: no crash, no hang, and every setting keeps a valid value.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "glark/settings/configuration.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glark;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> names{"glxgears", "a"};
  settings::Settings result;
  std::vector<std::string> problems;
  settings::apply_configuration(text, "glark.toml", names, result, problems);
  if (result.context.level > core::max_supported_level || result.context.max_level > core::max_supported_level) abort();
  for (const std::string& problem : problems)
    if (!problem.starts_with("glark.toml:")) abort();
  return 0;
}
