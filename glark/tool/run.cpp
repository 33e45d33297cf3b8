// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/run.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>

namespace glark::tool {
namespace {

namespace fs = std::filesystem;
namespace variable = settings::variable;

constexpr char library_name[] = "libGLARK.so";
constexpr char library_variable[] = "GLARK_LIBRARY";

void say(const std::string& message) { std::fprintf(stderr, "glark: %s\n", message.c_str()); }

std::optional<fs::path> find_library() {
  if (const char* wanted = std::getenv(library_variable); wanted != nullptr && *wanted != '\0') {
    if (fs::exists(wanted)) return fs::absolute(wanted);
    say(std::string(library_variable) + " names " + wanted + ", which does not exist; correct it or unset it");
    return std::nullopt;
  }
  std::error_code error;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
  for (const fs::path folder : {"lib", "lib/glark", GLARK_LIBRARY_FOLDER, GLARK_LIBRARY_FOLDER "/glark"})
    if (const fs::path file = prefix / folder / library_name; fs::exists(file)) return file;
  say(std::string(library_name) + " is not in " + (prefix / "lib").string() + "; install glark completely or set " +
      library_variable + " to the file");
  return std::nullopt;
}

// Preloads that the user already has stay, after ours.
bool preload(const fs::path& library) {
  if (library.string().find_first_of(": ") != std::string::npos) {
    say("the path " + library.string() +
        " contains a colon or a space, which LD_PRELOAD cannot express; move glark or link to it from another folder");
    return false;
  }
  const char* others = std::getenv("LD_PRELOAD");
  const std::string value = others == nullptr || *others == '\0' ? library.string() : library.string() + ":" + others;
  setenv("LD_PRELOAD", value.c_str(), 1);
  return true;
}

// The program may change its folder: names of files are made absolute here. Whether they can be written is found out now,
// not when the program has run for an hour.
std::optional<std::string> writable(const std::string& option, const std::string& file) {
  const fs::path path = fs::absolute(file);
  const fs::path folder = path.parent_path();
  if (fs::is_directory(path)) {
    say(option + ": " + path.string() + " is a folder; name a file in it");
    return std::nullopt;
  }
  const bool exists = fs::exists(path);
  if (access((exists ? path : folder).c_str(), W_OK) == 0) return path.string();
  if (exists)
    say(option + ": " + path.string() + " cannot be written: " + std::strerror(errno) + "; name another file");
  else
    say(option + ": the folder " + folder.string() + " cannot be written: " + std::strerror(errno) +
        "; make it or name another");
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
      value.append(std::to_string(request.frame)).append(":").append(*file);
    }
  return value;
}

void set(const char* name, const std::string& value) {
  if (!value.empty()) setenv(name, value.c_str(), 1);
}

bool set_environment(const RunOptions& options) {
  const std::optional<std::string> captures = captures_value(options.captures);
  if (!captures) return false;
  std::optional<std::string> statistics = "";
  if (!options.statistics.empty()) statistics = writable("--stats", options.statistics);
  if (!statistics) return false;
  set(variable::enable, "1");
  set(variable::level, options.level);
  set(variable::max_level, options.max_level);
  set(variable::refine, options.refine);
  set(variable::edge_pixels, options.edge_pixels);
  set(variable::curvature, options.curvature);
  set(variable::budget, options.budget);
  set(variable::wireframe, options.wireframe ? "1" : "");
  set(variable::log, options.log);
  set(variable::capture, *captures);
  set(variable::statistics, *statistics);
  return true;
}

}  // namespace

int run(const RunOptions& options, const std::vector<std::string>& command) {
  if (!set_environment(options)) return exit_usage;
  const std::optional<fs::path> library = find_library();
  if (!library || !preload(*library)) return exit_usage;

  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  const int error = errno;
  if (error == ENOENT) {
    say("the program " + command[0] + " is not found; check its name or give its path");
    return exit_not_found;
  }
  say("the program " + command[0] + " cannot be run: " + std::strerror(error));
  return exit_not_executable;
}

}  // namespace glark::tool
