// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/start/preload.h"

#include <elf.h>

#include <array>
#include <string_view>

namespace glark::tool {
namespace {

// What $LIB means to programs of 64 and of 32 bits. First Debian and its derivatives, then Fedora and its relatives.
struct LibraryFolders {
  std::string_view of_64;
  std::string_view of_32;
};
constexpr std::array folder_pairs{LibraryFolders{"lib/x86_64-linux-gnu", "lib/i386-linux-gnu"},
                                  LibraryFolders{"lib64", "lib"}};
constexpr std::string_view token = "$LIB";

bool same_machine(const ElfFile& one, const ElfFile& other) {
  return one.machine == other.machine && one.is_64 == other.is_64;
}

std::string with_folder(const std::string& wanted, std::string_view folder) {
  return std::string(wanted).replace(wanted.find(token), token.size(), folder);
}

// Reads the libraries that the path `wanted` names in this pair of folders. Returns nothing if none of them fits `own`.
std::optional<Preload> read_pair(const std::string& wanted, const LibraryFolders& folders, const ElfFile& own,
                                 const ReadElf& read) {
  const std::string file = with_folder(wanted, own.is_64 ? folders.of_64 : folders.of_32);
  const std::optional<ElfFile> library = read(file);
  if (!library || !same_machine(*library, own)) return std::nullopt;
  Preload found{.text = wanted, .file = file, .libraries = {*library}};
  const std::optional<ElfFile> other = read(with_folder(wanted, own.is_64 ? folders.of_32 : folders.of_64));
  if (other && other->is_64 != own.is_64) found.libraries.push_back(*other);
  return found;
}

}  // namespace

std::optional<ElfFile> read_elf_file(const std::string& path) { return read_program_file(path).elf; }

std::optional<Preload> preload_of(const std::string& wanted, const ElfFile& own, const ReadElf& read) {
  if (wanted.find(token) == std::string::npos) {
    const std::optional<ElfFile> library = read(wanted);
    if (!library) return std::nullopt;
    return Preload{.text = wanted, .file = wanted, .libraries = {*library}};
  }
  for (const LibraryFolders& folders : folder_pairs)
    if (std::optional<Preload> found = read_pair(wanted, folders, own, read)) return found;
  return std::nullopt;
}

std::optional<Preload> find_preload(const std::string& prefix, const std::vector<std::string>& folders,
                                    const std::string& name, const ElfFile& own, const ReadElf& read) {
  const std::string wanted = prefix + "/" + std::string(token) + "/" + name;
  for (const std::string& folder : folders) {
    const std::string file = prefix + "/" + folder + "/" + name;
    const std::optional<ElfFile> library = read(file);
    if (!library || !same_machine(*library, own)) continue;
    for (const LibraryFolders& pair : folder_pairs) {
      if (folder != (own.is_64 ? pair.of_64 : pair.of_32)) continue;
      if (std::optional<Preload> both = read_pair(wanted, pair, own, read); both && both->libraries.size() > 1)
        return both;
    }
    return Preload{.text = file, .file = file, .libraries = {*library}};
  }
  return std::nullopt;
}

}  // namespace glark::tool
