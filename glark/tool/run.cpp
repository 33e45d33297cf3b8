// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>

#include "glark/settings/terminal.h"
#include "glark/tool/start/notices.h"
#include "glark/tool/start/preload.h"

namespace glark::tool {
namespace {

namespace fs = std::filesystem;
namespace variable = settings::variable;

constexpr char library_name[] = "libGLARK.so." GLARK_SOVERSION;

std::optional<Preload> wanted_library(const std::string& wanted, const ElfFile& own) {
  const std::string file = fs::absolute(wanted).string();
  std::optional<Preload> found = preload_of(file, own, read_elf_file);
  if (!found && fs::exists(file))
    say(fmt::format("{} names {}, which is not a library; correct it or unset it", variable::library, wanted));
  else if (!found)
    say(fmt::format("{} names {}, which does not exist; correct it or unset it", variable::library, wanted));
  return found;
}

std::optional<Preload> find_library() {
  const std::optional<ElfFile> own = read_elf_file("/proc/self/exe");
  if (!own) {
    say("/proc/self/exe cannot be read; mount /proc");
    return std::nullopt;
  }
  if (const char* wanted = std::getenv(variable::library); wanted != nullptr && *wanted != '\0')
    return wanted_library(wanted, *own);
  std::error_code error;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
  std::optional<Preload> found =
      find_preload(prefix.string(), {"lib", GLARK_LIBRARY_FOLDER}, library_name, *own, read_elf_file);
  if (!found)
    say(fmt::format("{} for {} is not in {}; install glark completely or set {} to the file", library_name,
                    machine_name(*own), (prefix / "lib").string(), variable::library));
  return found;
}

// Puts the library before the preloads that the user already has.
bool set_preload(const std::string& library) {
  if (library.find_first_of(": ") != std::string::npos) {
    say(fmt::format(
        "the path {} contains a colon or a space, which LD_PRELOAD cannot express; move glark or link to it from "
        "another folder",
        library));
    return false;
  }
  const char* others = std::getenv("LD_PRELOAD");
  const std::string value = others == nullptr || *others == '\0' ? library : library + ":" + others;
  setenv("LD_PRELOAD", value.c_str(), 1);
  return true;
}

// File names become absolute, because the program may change its folder. Unwritable files are refused now, not after
// the program has run for an hour.
std::optional<std::string> writable(const std::string& option, const std::string& file) {
  const fs::path path = fs::absolute(file);
  const fs::path folder = path.parent_path();
  if (fs::is_directory(path)) {
    say(fmt::format("{}: {} is a folder; name a file in it", option, path.string()));
    return std::nullopt;
  }
  const bool exists = fs::exists(path);
  if (access((exists ? path : folder).c_str(), W_OK) == 0) return path.string();
  if (exists)
    say(fmt::format("{}: {} cannot be written: {}; name another file", option, path.string(), std::strerror(errno)));
  else
    say(fmt::format("{}: the folder {} cannot be written: {}; make it or name another", option, folder.string(),
                    std::strerror(errno)));
  return std::nullopt;
}

std::optional<std::string> captures_value(const std::vector<std::string>& wanted) {
  std::string value;
  for (const std::string& text : wanted)
    for (const settings::CaptureRequest& request :
         settings::parse_captures(text).value_or(std::vector<settings::CaptureRequest>())) {
      const std::optional<std::string> file = writable("--capture", request.file);
      if (!file) return std::nullopt;
      if (!value.empty()) value += ',';
      value += fmt::format("{}:{}", request.frame, *file);
    }
  return value;
}

std::optional<std::string> made_folder(const std::string& option, const std::string& folder) {
  const fs::path path = fs::absolute(folder);
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && fs::is_directory(path) && access(path.c_str(), W_OK | X_OK) == 0) return path.string();
  const std::string reason = error ? error.message() : std::strerror(fs::is_directory(path) ? errno : ENOTDIR);
  say(fmt::format("{}: the folder {} cannot be written: {}; name another", option, path.string(), reason));
  return std::nullopt;
}

std::optional<std::string> readable(const std::string& option, const std::string& file) {
  const fs::path path = fs::absolute(file);
  if (access(path.c_str(), R_OK) == 0 && !fs::is_directory(path)) return path.string();
  say(fmt::format("{}: {} cannot be read: {}; name another file", option, path.string(),
                  std::strerror(fs::is_directory(path) ? EISDIR : errno)));
  return std::nullopt;
}

// Returns the value for the environment, or nothing, after a message, if the value is unusable.
std::optional<std::string> value_of(const settings::Setting& setting, const std::vector<std::string>& given) {
  const std::string option = fmt::format("--{}", setting.key);
  switch (setting.kind) {
    case settings::Kind::captures: return captures_value(given);
    case settings::Kind::output_file: return writable(option, given.back());
    case settings::Kind::output_folder: return made_folder(option, given.back());
    case settings::Kind::input_file: return readable(option, given.back());
    case settings::Kind::toggle: return "1";
    case settings::Kind::value: break;
  }
  return given.back();
}

bool set_environment(const RunOptions& options) {
  setenv(variable::enable, "1", 1);
  for (const auto& [key, given] : options) {
    const settings::Setting& setting = *settings::find_setting(key);
    const std::optional<std::string> value = value_of(setting, given);
    if (!value) return false;
    setenv(setting.variable, value->c_str(), 1);
  }
  return true;
}

}  // namespace

void say(const std::string& message) {
  const bool colors = settings::has_colors(STDERR_FILENO);
  fmt::print(stderr, "{}glark:{} {}\n", colors ? settings::style::yellow : "", colors ? settings::style::plain : "",
             message);
}

bool prepare_run(const RunOptions& options, const std::vector<std::string>& command) {
  if (!set_environment(options)) return false;
  const std::optional<Preload> library = find_library();
  if (!library || !set_preload(library->text)) return false;
  for (const std::string& notice : start_notices(read_command(command[0]), library->libraries)) say(notice);
  return true;
}

int become_program(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  const int error = errno;
  if (const std::optional<std::string> reason = cannot_run(read_command(command[0]))) {
    say(*reason);
    return exit_not_executable;
  }
  if (error == ENOENT) {
    say(fmt::format("the program {} is not found; check its name or give its path", command[0]));
    return exit_not_found;
  }
  say(fmt::format("the program {} cannot be run: {}", command[0], std::strerror(error)));
  return exit_not_executable;
}

int run(const RunOptions& options, const std::vector<std::string>& command) {
  return prepare_run(options, command) ? become_program(command) : exit_usage;
}

}  // namespace glark::tool
