// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/frames/encoder.h"

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <vector>

#include "glark/settings/settings.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

constexpr int longest_wait = 20000;  // milliseconds

// The shell leaves ffmpeg behind and ends. The socket is its descriptor 3.
constexpr char script[] = R"("$@" <&3 3<&- >/dev/null &)";

// Pictures carry their sizes, and come with the time of the clock. No picture is repeated: a slow program would become slower.
// A window that is resized is fitted into the film.
std::vector<std::string> command_for(const std::string& file, Size size) {
  const int width = (size.width + 1) / 2 * 2;  // as most encoders need
  const int height = (size.height + 1) / 2 * 2;
  return {
      "/bin/sh",
      "-c",
      script,
      "sh",
      "ffmpeg",
      "-nostdin",
      "-loglevel",
      "error",
      "-y",
      "-use_wallclock_as_timestamps",
      "1",
      "-f",
      "image2pipe",
      "-framerate",
      "1000",
      "-c:v",
      "ppm",
      "-i",
      "pipe:0",
      "-vf",
      fmt::format("scale={0}:{1}:force_original_aspect_ratio=decrease,pad={0}:{1}:-1:-1,format=yuv420p", width, height),
      "-fps_mode",
      "vfr",
      file};
}

bool is_in_path(std::string_view program) {
  std::string_view folders = settings::find_variable(first_environment(), "PATH").value_or("/usr/bin:/bin");
  while (!folders.empty()) {
    const std::size_t colon = folders.find(':');
    if (access(fmt::format("{}/{}", folders.substr(0, colon), program).c_str(), X_OK) == 0) return true;
    folders.remove_prefix(colon == std::string_view::npos ? folders.size() : colon + 1);
  }
  return false;
}

// glark itself must not be preloaded into ffmpeg.
std::vector<char*> environment_of_ffmpeg() {
  std::vector<char*> variables;
  for (const char* const* entry = first_environment(); *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with("LD_PRELOAD=")) variables.push_back(const_cast<char*>(*entry));
  variables.push_back(nullptr);
  return variables;
}

int spawn(std::vector<std::string> command, int socket) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, 3);
  pid_t shell = 0;
  const int error =
      posix_spawn(&shell, arguments[0], &actions, nullptr, arguments.data(), environment_of_ffmpeg().data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return error;
  while (waitpid(shell, nullptr, 0) < 0 && errno == EINTR) {
  }
  return 0;
}

}  // namespace

Encoder Encoder::start(const std::string& file, Size size, std::string& problem) {
  Encoder encoder;
  int ends[2] = {-1, -1};
  if (!is_in_path("ffmpeg")) {
    problem = "the program ffmpeg is not in PATH; install it";
  } else if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    problem = std::strerror(errno);
  } else {
    const int error = spawn(command_for(file, size), ends[1]);
    close(ends[1]);
    encoder.socket_ = ends[0];
    if (error != 0) {
      problem = std::strerror(error);
      encoder.finish();
    }
  }
  return encoder;
}

// A program that ignores no SIGPIPE must not die of it.
bool Encoder::send_all(const void* bytes, std::size_t count) const {
  const auto* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t sent = send(socket_, next, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool Encoder::add(std::span<const unsigned char> pixels, Size size) {
  const std::string header = fmt::format("P6\n{} {}\n255\n", size.width, size.height);
  if (send_all(header.data(), header.size()) && send_all(pixels.data(), pixels.size())) return true;
  finish();
  return false;
}

// ffmpeg closes its end when it has written the film.
void Encoder::finish() {
  if (socket_ < 0) return;
  shutdown(socket_, SHUT_WR);
  pollfd waits{.fd = socket_, .events = POLLIN, .revents = 0};
  while (poll(&waits, 1, longest_wait) < 0 && errno == EINTR) {
  }
  close(socket_);
  socket_ = -1;
}

}  // namespace glark::shim
