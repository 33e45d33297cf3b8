// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_points/peer.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace glark::bench {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("glark-bench-points-" + std::to_string(getpid()));
  Folder() { fs::create_directory(path); }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

std::string quoted(const fs::path& path) {
  std::string text = "'";
  for (const char each : path.string()) text += each == '\'' ? std::string("'\\''") : std::string(1, each);
  return text + "'";
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  for (int byte = 0; pipe != nullptr && (byte = std::fgetc(pipe.get())) != EOF;) text += static_cast<char>(byte);
  return text;
}

}  // namespace

std::optional<PeerWork> peer(const std::string& task, const std::string& name, std::span<const float> positions,
                             int rounds) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "glark-bench-peers";
  if (!fs::exists(program)) return std::nullopt;
  const Folder folder;
  const fs::path points = folder.path / "points", triangles = folder.path / "triangles";
  std::ofstream(points, std::ios::binary)
      .write(reinterpret_cast<const char*>(positions.data()), static_cast<std::streamsize>(positions.size_bytes()));
  std::string command = quoted(program) + " " + task + " " + quoted(points) + " " + std::to_string(rounds);
  if (task == "front") command += " " + quoted(triangles);
  PeerWork result{{name, {}}, 0, {}};
  double bytes = -1;
  std::istringstream line(output_of(command));
  if (!(line >> result.work.cpu_seconds >> result.work.seconds >> bytes >> result.found))
    throw std::runtime_error("glark-bench-peers " + task + " failed");
  if (bytes >= 0) result.work.peak_bytes = bytes;
  if (task == "front") {
    result.triangles.resize(3 * result.found);
    std::ifstream(triangles, std::ios::binary)
        .read(reinterpret_cast<char*>(result.triangles.data()),
              static_cast<std::streamsize>(4 * result.triangles.size()));
  }
  return result;
}

}  // namespace glark::bench
