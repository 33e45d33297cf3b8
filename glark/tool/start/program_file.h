// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What an executable file is, as far as preloading depends on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace glark::tool {

// The first bytes of an ELF file. Machine numbers are those of <elf.h>.
struct ElfFile {
  unsigned machine = 0;
  bool is_64 = false;
  bool is_loader = false;        // the dynamic linker itself, as a program
  std::string interpreter = {};  // the dynamic linker that the file names; empty: the program is static
};

struct ProgramFile {
  enum class Kind { missing, folder, elf, script, windows, other };
  Kind kind = Kind::missing;
  std::string path = {};            // with symbolic links resolved
  std::optional<ElfFile> elf = {};  // kind == elf
  std::string interpreter = {};     // kind == script: the program that runs it; empty if the first line names none
  bool interpreter_found = true;
  bool set_user = false;      // the kernel would change the user ...
  bool set_group = false;     // ... or the group
  bool capabilities = false;  // or give it capabilities
};

// Looks for the command as execvp does; empty if there is none.
std::string find_command(const std::string& command);

// Reads the file. `path` need not exist.
ProgramFile read_program_file(const std::string& path);

// The file and, for a script, the interpreters that run it, the last one at the end.
std::vector<ProgramFile> read_command(const std::string& command);

// In the words of a user: "x86-64", "i386" ...
std::string machine_name(const ElfFile& file);

}  // namespace glark::tool
