// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/doctor/doctor.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "glark/tool/doctor/diagnosis.h"
#include "glark/tool/doctor/read_reports.h"
#include "glark/tool/doctor/watch.h"
#include "glark/tool/start/notices.h"

namespace glark::tool {
namespace {

namespace fs = std::filesystem;

// A folder for the statistics of all processes, deleted at the end.
class Folder {
 public:
  Folder() {
    std::string path = (fs::temp_directory_path() / "glark-doctor-XXXXXX").string();
    if (mkdtemp(path.data()) != nullptr) path_ = path;
  }
  ~Folder() {
    std::error_code error;
    if (!path_.empty()) fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

int doctor(const RunOptions& options, const std::vector<std::string>& command, double seconds) {
  if (options.contains("stats")) {
    say("glark doctor writes statistics of its own; leave out --stats, or use glark run");
    return exit_usage;
  }
  const Folder folder;
  if (folder.path().empty()) {
    say("no folder for statistics can be made in " + fs::temp_directory_path().string() +
        "; set TMPDIR to another one");
    return exit_usage;
  }
  if (!prepare_run(options, command)) return exit_usage;
  if (find_command(command.front()).empty() || cannot_run(read_command(command.front())))
    return become_program(command);  // says why it fails
  setenv("GLARK_STATS", (folder.path() + "/%p.json").c_str(), 1);
  Observation observation = watch(command, seconds);
  observation.reports = read_reports(folder.path());
  observation.has_display = is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
  for (const std::string& line : diagnosis(observation)) std::printf("%s\n", line.c_str());
  return is_refined(observation) ? 0 : exit_nothing_refined;
}

}  // namespace glark::tool
