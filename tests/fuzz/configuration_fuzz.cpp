// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any text as a configuration file: no crash, no hang, and every setting keeps a valid value. A change that is made
// twice is the same as made once.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "glark/settings/configuration.h"
#include "glark/settings/edit/configuration_edit.h"

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
  const std::vector<settings::ChangedSetting> changed{{"level", "3"}};
  const std::string edited = settings::with_settings(text, "a", changed, {});
  if (settings::with_settings(edited, "a", changed, {}) != edited) abort();
  return 0;
}
