// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/start/notices.h"

#include <elf.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace glark::tool {
namespace {

namespace fs = std::filesystem;
using Kind = ProgramFile::Kind;

std::string name_of(const std::string& path) { return fs::path(path).filename().string(); }

// Programs that start another one where the preload does not reach.
struct Starter {
  std::string_view name;
  std::string_view why;
  std::string_view remedy;
};
constexpr std::array starters{
    Starter{"sudo", "drops the preload, so the program that it starts stays unrefined",
            "write: sudo glark run PROGRAM"},
    Starter{"doas", "drops the preload, so the program that it starts stays unrefined",
            "write: doas glark run PROGRAM"},
    Starter{"pkexec", "drops the preload, so the program that it starts stays unrefined",
            "write: pkexec glark run PROGRAM"},
    Starter{"su", "drops the preload, so the program that it starts stays unrefined",
            "write: su -c \"glark run PROGRAM\""},
    Starter{"snap", "drops the preload before it starts a program, which stays unrefined",
            "install the program as a package of the distribution"},
    Starter{"flatpak", "runs programs where the library does not exist, so they stay unrefined",
            "install the program as a package of the distribution"},
};

std::optional<std::string> about_starter(const std::string& path) {
  for (const Starter& starter : starters)
    if (name_of(path) == starter.name) return fmt::format("{} {}; {}", starter.name, starter.why, starter.remedy);
  return std::nullopt;
}

std::optional<std::string> about_privileges(const ProgramFile& program) {
  const char* what = program.set_user       ? "is a set-uid program"
                     : program.set_group    ? "is a set-gid program"
                     : program.capabilities ? "has file capabilities"
                                            : nullptr;
  if (what == nullptr) return std::nullopt;
  return fmt::format(
      "{} {}: the dynamic linker ignores the preload for it, so it stays unrefined; run a copy of the file",
      program.path, what);
}

// Programs of 64 and of 32 bits run side by side. The library for the other kind is a package of its own.
std::string how_to_get_library(const ElfFile& program, const ElfFile& own) {
  if (program.machine == EM_386 && own.machine == EM_X86_64)
    return "install the package libglark0:i386 (after dpkg --add-architecture i386)";
  if (program.machine == EM_X86_64 && program.is_64 && own.machine == EM_386)
    return "install the package libglark0:amd64 (after dpkg --add-architecture amd64)";
  return fmt::format("use its {} build", machine_name(own));
}

std::optional<std::string> about_elf(const ProgramFile& program, std::span<const ElfFile> libraries) {
  const ElfFile& elf = *program.elf;
  const bool fits = std::any_of(libraries.begin(), libraries.end(), [&](const ElfFile& library) {
    return elf.machine == library.machine && elf.is_64 == library.is_64;
  });
  if (!fits)
    return fmt::format(
        "{} is for {}, but there is no libGLARK.so for {}, so it stays unrefined; {}, or set GLARK_LIBRARY to such a "
        "library",
        program.path, machine_name(elf), machine_name(elf), how_to_get_library(elf, libraries.front()));
  if (elf.interpreter.empty() && !elf.is_loader)
    return fmt::format(
        "{} is linked statically: nothing can be preloaded into it, so it stays unrefined; only programs that it "
        "starts "
        "are refined; use a dynamically linked build",
        program.path);
  if (name_of(elf.interpreter).starts_with("ld-musl"))
    return fmt::format(
        "{} uses the C library musl, and libGLARK.so needs glibc, so it stays unrefined; use a build for glibc",
        program.path);
  return std::nullopt;
}

// Debian's packages of the dynamic linkers.
std::string package_of_loader(const ElfFile& elf) {
  if (name_of(elf.interpreter).starts_with("ld-musl")) return "musl";
  switch (elf.machine) {
    case EM_386: return "libc6:i386 and libgl1:i386 (after dpkg --add-architecture i386)";
    case EM_ARM: return "libc6:armhf";
    case EM_AARCH64: return "libc6:arm64";
    case EM_X86_64: return elf.is_64 ? "libc6:amd64" : "libc6-x32";
    default: return "libc6 for " + machine_name(elf);
  }
}

}  // namespace

std::vector<std::string> start_notices(std::span<const ProgramFile> files, std::span<const ElfFile> libraries) {
  std::vector<std::string> notices;
  const auto add = [&](const std::optional<std::string>& notice) {
    if (notice) notices.push_back(*notice);
    return notice.has_value();
  };
  for (const ProgramFile& program : files) {
    if (add(about_starter(program.path)) || add(about_privileges(program))) continue;
    if (program.kind == Kind::elf) add(about_elf(program, libraries));
    if (program.kind == Kind::windows)
      notices.push_back(fmt::format("{0} is a Windows program; write: glark run wine {0}", program.path));
  }
  return notices;
}

std::optional<std::string> cannot_run(std::span<const ProgramFile> files) {
  for (const ProgramFile& program : files) {
    if (program.kind == Kind::folder) return fmt::format("{} is a folder; name a program in it", program.path);
    if (program.kind == Kind::script && !program.interpreter_found)
      return fmt::format(
          "{} is a script for {}, which is not installed; install it, or correct the script's first line", program.path,
          program.interpreter);
    if (program.kind == Kind::elf && !program.elf->interpreter.empty() &&
        access(program.elf->interpreter.c_str(), F_OK) != 0)
      return fmt::format("{} is for {} and needs {}, which is not installed; install the package {}", program.path,
                         machine_name(*program.elf), program.elf->interpreter, package_of_loader(*program.elf));
  }
  return std::nullopt;
}

}  // namespace glark::tool
