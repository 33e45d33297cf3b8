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

const settings::Settings& options() {
  static const settings::Settings& instance = *[] {
    // Reads `environ`, because programs may define a getenv of their own.
    settings::Parsed parsed = settings::parse(environ, program_names());
    install_log(parsed.settings.log_level);
    for (const std::string& problem : parsed.problems) core::log(core::LogLevel::warning, problem);
    if (!parsed.settings.dump_folder.empty()) install_shader_dump(parsed.settings.dump_folder);
    return new settings::Settings(std::move(parsed.settings));
  }();
  return instance;
}

}  // namespace glark::shim
