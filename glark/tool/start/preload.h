// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which library the dynamic linker loads into a program of 64 bits and into one of 32.
//
// A program may start others: a launcher of 64 bits a game of 32 bits, or the reverse. LD_PRELOAD is the same for all of
// them, so it names the library by a path with $LIB. The dynamic linker of each program replaces $LIB by its own folder
// of libraries.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glark/tool/start/program_file.h"

namespace glark::tool {

struct Preload {
  std::string text;                     // for LD_PRELOAD
  std::string file;                     // the library for programs of the launcher's kind
  std::vector<ElfFile> libraries = {};  // what `text` leads to; the first one is `file`
};

// Reads a file of this name. Tests have their own.
using ReadElf = std::function<std::optional<ElfFile>(const std::string&)>;
std::optional<ElfFile> read_elf_file(const std::string& path);

// `wanted` is the name of a file, with or without $LIB. Nothing: there is no such file for `own`, the machine of the
// launcher. A name without $LIB may be a library for any machine.
std::optional<Preload> preload_of(const std::string& wanted, const ElfFile& own, const ReadElf& read);

// Returns the library `name` from the first of the folders under `prefix` that has it for `own`. The text contains $LIB
// only if a library for the other kind of programs (32 or 64 bits) exists, too. Otherwise it is the plain path, because
// programs with a dynamic linker of their own need that.
std::optional<Preload> find_preload(const std::string& prefix, const std::vector<std::string>& folders,
                                    const std::string& name, const ElfFile& own, const ReadElf& read);

}  // namespace glark::tool
