// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/edit/window.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace glark::tool {
namespace {

// Beside this program.
std::string viewer() {
  std::error_code error;
  return (std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "glark-view").string();
}

bool has_display() {
  const char* x11 = std::getenv("DISPLAY");
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  return (x11 != nullptr && *x11 != 0) || (wayland != nullptr && *wayland != 0);
}

}  // namespace

bool can_open_window() { return isatty(STDIN_FILENO) == 1 && has_display() && access(viewer().c_str(), X_OK) == 0; }

void become_window(std::vector<std::string> arguments) {
  std::string program = viewer(), command = "edit";
  std::vector<char*> words{program.data(), command.data()};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  execv(program.c_str(), words.data());
  throw std::runtime_error(program + ": cannot be run: " + std::strerror(errno) +
                           "; install glark completely (Debian package glark-tools), or edit by --script");
}

}  // namespace glark::tool
