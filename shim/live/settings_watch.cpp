// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/live/settings_watch.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>
#include <string>
#include <tuple>

#include "glark/settings/configuration.h"
#include "shim/live/live_settings.h"
#include "shim/report/options.h"

namespace glark::shim {
namespace {

constexpr auto look_interval = std::chrono::milliseconds(500);

std::atomic<bool> hung_up{false};

bool had_terminal = false;

bool has_terminal() {
  const int terminal = open("/dev/tty", O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (terminal >= 0) close(terminal);
  return terminal >= 0;
}

// A terminal that closes also sends SIGHUP: the kernel does, and the shell passes it on. The program must end then, as
// without us.
void note_hang_up(int signal, siginfo_t* info, void*) {
  const int saved = errno;
  const bool terminal_closed = info->si_code == SI_KERNEL || (had_terminal && !has_terminal());
  errno = saved;
  if (!terminal_closed) {
    hung_up.store(true, std::memory_order_relaxed);
    return;
  }
  struct sigaction ends {};
  ends.sa_handler = SIG_DFL;
  sigaction(signal, &ends, nullptr);
  raise(signal);
}

// A program that handles or ignores SIGHUP itself keeps doing so.
void install_hang_up() {
  struct sigaction present {};
  if (sigaction(SIGHUP, nullptr, &present) != 0 || (present.sa_flags & SA_SIGINFO) != 0 ||
      present.sa_handler != SIG_DFL)
    return;
  had_terminal = has_terminal();
  struct sigaction ours {};
  ours.sa_sigaction = note_hang_up;
  ours.sa_flags = SA_SIGINFO | SA_RESTART;
  sigemptyset(&ours.sa_mask);
  sigaction(SIGHUP, &ours, nullptr);
}

// Two versions of a file differ in one of these; all are 0 if there is no file.
using FileVersion = std::tuple<dev_t, ino_t, off_t, time_t, long>;

FileVersion version_of(const std::string& file) {
  struct stat status {};
  if (file.empty() || stat(file.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

FileVersion configuration_version() { return version_of(settings::find_configuration(first_environment())); }

struct Watch {
  std::mutex mutex;
  FileVersion version = configuration_version();
  std::chrono::steady_clock::time_point last_look = std::chrono::steady_clock::now();
};

Watch& watch() {
  static Watch& instance = *[] {
    if (wants_keys()) install_hang_up();
    return new Watch;
  }();
  return instance;
}

}  // namespace

void watch_settings() {
  if (!options().context.transparent) return;
  Watch& state = watch();
  const std::unique_lock lock(state.mutex, std::try_to_lock);
  if (!lock.owns_lock()) return;
  bool again = hung_up.exchange(false, std::memory_order_relaxed);
  const auto now = std::chrono::steady_clock::now();
  if (again || now - state.last_look >= look_interval) {
    state.last_look = now;
    const FileVersion version = configuration_version();
    again = again || version != state.version;
    state.version = version;
  }
  if (again) read_settings_again();
}

}  // namespace glark::shim
