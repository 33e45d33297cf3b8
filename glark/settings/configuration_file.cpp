// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds and reads the configuration file: XDG Base Directory Specification 0.8.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "glark/settings/configuration.h"

namespace glark::settings {
namespace {

constexpr char name_in_folder[] = "/glark/glark.toml";

// The specification says that relative folders are ignored.
std::string in_folder(std::string_view folder) {
  if (!folder.starts_with('/')) return {};
  std::string file = std::string(folder) + name_in_folder;
  return access(file.c_str(), F_OK) == 0 ? file : std::string();
}

std::string_view variable_or(const char* const* environment, std::string_view name, std::string_view otherwise) {
  const std::optional<std::string_view> text = find_variable(environment, name);
  return text && !text->empty() ? *text : otherwise;
}

std::optional<std::string> read_open_file(int file, std::string& reason) {
  struct stat status {};
  if (fstat(file, &status) == 0 && S_ISDIR(status.st_mode)) {
    reason = "it is a folder";
    return std::nullopt;
  }
  std::string text;
  for (;;) {
    const std::size_t before = text.size();
    text.resize(before + 4096);
    const ssize_t count = read(file, text.data() + before, 4096);
    text.resize(before + static_cast<std::size_t>(count > 0 ? count : 0));
    if (count == 0) return text;
    if (count < 0 && errno != EINTR) {
      reason = std::strerror(errno);
      return std::nullopt;
    }
    if (text.size() > longest_configuration) {
      reason = fmt::format("it is longer than {} bytes", longest_configuration);
      return std::nullopt;
    }
  }
}

}  // namespace

std::string find_configuration(const char* const* environment) {
  if (const std::string_view named = variable_or(environment, variable::config, ""); !named.empty())
    return std::string(named);
  const std::string home = std::string(variable_or(environment, "HOME", "")) + "/.config";
  if (std::string file = in_folder(variable_or(environment, "XDG_CONFIG_HOME", home)); !file.empty()) return file;
  std::string_view folders = variable_or(environment, "XDG_CONFIG_DIRS", "/etc/xdg");
  while (!folders.empty()) {
    const std::size_t colon = folders.find(':');
    if (std::string file = in_folder(folders.substr(0, colon)); !file.empty()) return file;
    folders.remove_prefix(colon == std::string_view::npos ? folders.size() : colon + 1);
  }
  return {};
}

std::optional<std::string> read_configuration(const std::string& file, std::string& problem) {
  // O_NONBLOCK: a pipe without a writer must not block the program.
  const int opened = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  std::string reason = opened < 0 ? std::strerror(errno) : "";
  std::optional<std::string> text;
  if (opened >= 0) {
    text = read_open_file(opened, reason);
    close(opened);
  }
  if (!text) problem = fmt::format("the configuration file {} cannot be read: {}; it is not used", file, reason);
  return text;
}

}  // namespace glark::settings
