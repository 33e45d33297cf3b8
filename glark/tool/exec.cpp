// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/exec.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <vector>

#include "glark/tool/run.h"

namespace glark::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* scan = "glark-scan";
// `glark info` with a file is glark-scan; without, the launcher itself.
constexpr std::string_view info_command = "info";
const std::vector<OtherCommand> commands {
#if GLARK_HAS_VSTREE
  {"simplify", scan, "Fewer triangles, or points where there are no triangles: glark simplify FILE -o OUT"},
      {"reconstruct", scan, "A mesh from points: glark reconstruct FILE -o OUT"},
      {"sample", scan, "Samples of a scan of any size: glark sample LARGE -o SMALL"},
      {"transfer", scan,
       "The edit of a sampling, on the whole scan: glark transfer LARGE --from SMALL --to EDITED -o OUT"},
      {"edit", scan, "Edit a scan of any size by its sampling: glark edit SCAN [--script FILE] [-o OUT]"},
#endif
#if GLARK_HAS_MAPS
      {"bake", scan, "A coarse mesh with maps of a scan: glark bake LARGE -o MODEL.glb"},
#endif
#if GLARK_HAS_SURFEL
      {"strip", scan, "Triangle strips that interpolate points: glark strip FILE -o OUT"},
      {"view", "glark-view",
       "Show points or triangles in a window, or write a picture: glark view FILE [--offscreen OUT.png]"},
#endif
};

}  // namespace

std::span<const OtherCommand> other_commands() { return commands; }

std::optional<std::string> find_program(const std::string& program) {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& place : {folder, folder.parent_path() / GLARK_LIBEXEC_FOLDER / "glark"})
    if (access((place / program).c_str(), X_OK) == 0) return (place / program).string();
  return std::nullopt;
}

const char* program_of(std::span<char* const> words) {
  if (words.empty()) return nullptr;
  for (const OtherCommand& command : commands)
    if (std::string_view(words[0]) == command.name) return command.program;
  return words[0] == info_command && words.size() > 1 ? scan : nullptr;
}

int become(const std::string& program, char** argv) {
  const std::optional<std::string> file = find_program(program);
  if (!file) {
    std::fprintf(stderr,
                 "glark: the program %s, which has this command, is not beside glark; install glark completely "
                 "(Debian package glark-tools)\n",
                 program.c_str());
    return exit_not_found;
  }
  execv(file->c_str(), argv);
  std::fprintf(stderr, "glark: %s cannot be run: %s\n", file->c_str(), std::strerror(errno));
  return exit_not_executable;
}

}  // namespace glark::tool
