// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/report/options.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "glark/settings/configuration.h"
#include "shim/report/log.h"
#include "shim/report/shader_dump.h"

namespace glark::shim {

namespace {

std::vector<std::string> names_of_this_program() {
  std::vector<std::string> arguments;
  if (std::ifstream file("/proc/self/cmdline"); file)
    for (std::string word; std::getline(file, word, '\0') && arguments.size() < 64;) arguments.push_back(word);
  std::error_code error;
  return settings::program_names(std::filesystem::read_symlink("/proc/self/exe", error).string(), arguments);
}

}  // namespace

const std::vector<std::string>& program_names() {
  static const std::vector<std::string>& instance = *new std::vector<std::string>(names_of_this_program());
  return instance;
}

// Reads `environ`, because programs may define a getenv of their own.
const char* const* first_environment() {
  static const std::vector<const char*>& instance = *[] {
    auto* const pointers = new std::vector<const char*>;
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry)
      pointers->push_back((new std::string(*entry))->c_str());
    pointers->push_back(nullptr);
    return pointers;
  }();
  return instance.data();
}

bool wants_keys() {
  static const bool answer = options().context.transparent && (options().overlay || options().toggle_key != nullptr);
  return answer;
}

const settings::Settings& options() {
  static const settings::Settings& instance = *[] {
    settings::Parsed parsed = settings::parse(first_environment(), program_names());
    install_log(parsed.settings.log_level);
    for (const std::string& problem : parsed.problems) core::log(core::LogLevel::warning, problem);
#if !GLARK_PANEL
    if (parsed.settings.overlay || parsed.settings.toggle_key != nullptr)
      core::log(core::LogLevel::warning,
                "this build of glark has no panel and follows no keys; docs/how-to/panel.md says "
                "what it needs");
#endif
    if (!parsed.settings.dump_folder.empty()) install_shader_dump(parsed.settings.dump_folder);
    return new settings::Settings(std::move(parsed.settings));
  }();
  return instance;
}

}  // namespace glark::shim
