// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/start/program_file.h"

#include <elf.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace glark::tool {
namespace {

namespace fs = std::filesystem;

// A file that we cannot read, or that lies about its size, must not hang or fill the memory.
constexpr std::size_t longest_header = 64 * 1024;
constexpr std::size_t most_interpreters = 5;

std::string first_bytes(const std::string& path) {
  std::string bytes(longest_header, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

template <class T>
std::optional<T> value_at(std::string_view bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T)) return std::nullopt;
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

template <class Header, class Segment>
void read_segments(std::string_view bytes, ElfFile& file) {
  const std::optional<Header> header = value_at<Header>(bytes, 0);
  if (!header) return;
  file.machine = header->e_machine;
  for (unsigned i = 0; i < header->e_phnum; ++i) {
    const std::uint64_t at = header->e_phoff + std::uint64_t{i} * header->e_phentsize;
    const auto segment = value_at<Segment>(bytes, static_cast<std::size_t>(std::min<std::uint64_t>(at, bytes.size())));
    if (!segment) return;
    if (segment->p_type != PT_INTERP || segment->p_offset >= bytes.size()) continue;
    const std::string_view rest = bytes.substr(static_cast<std::size_t>(segment->p_offset));
    const std::string_view text =
        rest.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(segment->p_filesz, rest.size())));
    file.interpreter = std::string(text.substr(0, text.find('\0')));
  }
}

ElfFile read_elf(std::string_view bytes, const std::string& path) {
  ElfFile file;
  file.is_64 = bytes.size() > EI_CLASS && bytes[EI_CLASS] == ELFCLASS64;
  constexpr char own_order = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
  if (bytes.size() <= EI_DATA || bytes[EI_DATA] != own_order) return file;
  if (file.is_64)
    read_segments<Elf64_Ehdr, Elf64_Phdr>(bytes, file);
  else
    read_segments<Elf32_Ehdr, Elf32_Phdr>(bytes, file);
  const std::string name = fs::path(path).filename().string();
  file.is_loader = name.starts_with("ld-") || name.starts_with("ld.so");
  return file;
}

// "#!/usr/bin/env -S python3 -u" is run by env, which looks for python3.
void read_first_line(std::string_view bytes, ProgramFile& program) {
  std::istringstream words(std::string(bytes.substr(2, bytes.find('\n') - 2)));
  std::string word;
  words >> program.interpreter;
  if (fs::path(program.interpreter).filename() == "env")
    for (bool option = true; option && words >> word;) {
      option = word.starts_with("-") || word.find('=') != std::string::npos;
      if (!option) program.interpreter = word;
    }
  program.interpreter_found = program.interpreter.empty() || !find_command(program.interpreter).empty();
}

void read_permissions(const std::string& path, ProgramFile& program) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return;
  program.set_user = (status.st_mode & S_ISUID) != 0 && status.st_uid != geteuid();
  program.set_group = (status.st_mode & (S_ISGID | S_IXGRP)) == (S_ISGID | S_IXGRP) && status.st_gid != getegid();
  program.capabilities = geteuid() != 0 && getxattr(path.c_str(), "security.capability", nullptr, 0) > 0;
}

bool runs(const fs::path& path) {
  std::error_code error;
  return access(path.c_str(), X_OK) == 0 && !fs::is_directory(path, error);
}

}  // namespace

std::string find_command(const std::string& command) {
  if (command.find('/') != std::string::npos) return fs::exists(command) ? command : std::string();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/local/bin:/bin:/usr/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const fs::path file = fs::path(folder.empty() ? "." : folder) / command; runs(file)) return file.string();
  return {};
}

ProgramFile read_program_file(const std::string& path) {
  ProgramFile program;
  std::error_code error;
  program.path = path;
  if (path.empty() || !fs::exists(path, error)) return program;
  if (const fs::path resolved = fs::canonical(path, error); !error) program.path = resolved.string();
  if (fs::is_directory(path, error)) {
    program.kind = ProgramFile::Kind::folder;
    return program;
  }
  program.kind = ProgramFile::Kind::other;
  if (!fs::is_regular_file(path, error)) return program;
  read_permissions(program.path, program);
  const std::string bytes = first_bytes(program.path);
  if (bytes.starts_with(ELFMAG)) {
    program.kind = ProgramFile::Kind::elf;
    program.elf = read_elf(bytes, program.path);
  } else if (bytes.starts_with("#!")) {
    program.kind = ProgramFile::Kind::script;
    read_first_line(bytes, program);
  } else if (bytes.starts_with("MZ")) {
    program.kind = ProgramFile::Kind::windows;
  }
  return program;
}

std::vector<ProgramFile> read_command(const std::string& command) {
  std::vector<ProgramFile> files{read_program_file(find_command(command))};
  while (files.back().kind == ProgramFile::Kind::script && files.size() < most_interpreters) {
    const std::string interpreter = find_command(files.back().interpreter);
    if (interpreter.empty()) break;
    files.push_back(read_program_file(interpreter));
  }
  return files;
}

std::string machine_name(const ElfFile& file) {
  switch (file.machine) {
    case EM_386: return "i386";
    case EM_X86_64: return file.is_64 ? "x86-64" : "x32";
    case EM_ARM: return "ARM";
    case EM_AARCH64: return "AArch64";
    case EM_RISCV: return file.is_64 ? "RISC-V 64" : "RISC-V 32";
    default: return (file.is_64 ? "64-bit machine " : "32-bit machine ") + std::to_string(file.machine);
  }
}

}  // namespace glark::tool
