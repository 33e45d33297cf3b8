// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <string_view>

extern char** environ;

namespace glark::conformance {
namespace {

constexpr int report_in_child = 3;

std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return ends;
}

// How many threads Mesa's llvmpipe draws with. 0 is faster here: the pictures are small, and the workers share the cores
// already. Other drivers ignore this variable.
constexpr std::string_view driver_threads = "LP_NUM_THREADS=";

// What the user has set stays.
std::vector<std::string> environment_with(const std::string& preload) {
  std::vector<std::string> environment = {std::string(driver_threads) + "0"};
  std::string others;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (!preload.empty() && std::strncmp(*entry, "LD_PRELOAD=", 11) == 0) {
      others = *entry + 11;
    } else if (std::string_view(*entry).starts_with(driver_threads)) {
      environment.front() = *entry;
    } else {
      environment.emplace_back(*entry);
    }
  }
  if (!preload.empty()) environment.push_back("LD_PRELOAD=" + preload + (others.empty() ? "" : ":" + others));
  return environment;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

bool read_all(int descriptor, std::string& text) {
  std::array<char, 65536> bytes{};
  for (;;) {
    const ssize_t count = read(descriptor, bytes.data(), bytes.size());
    if (count > 0) {
      text.append(bytes.data(), static_cast<std::size_t>(count));
    } else if (count == 0) {
      return false;
    } else if (errno != EINTR) {
      return errno == EAGAIN;
    }
  }
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const std::string& preload) {
  const auto report = make_pipe();
  const auto output = make_pipe();
  std::vector<std::string> texts = {"glark-conformance"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environment_with(preload);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output[1], STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, report[1], report_in_child);
  // A process group of its own, so that its child processes end with it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int error = posix_spawn(&pid_, "/proc/self/exe", &actions, &attributes, pointers_to(texts).data(),
                                pointers_to(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(report[1]);
  close(output[1]);
  report_ = report[0];
  output_ = output[0];
  if (error != 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(error));
}

Process::~Process() {
  if (pid_ > 0) {
    kill();
    wait();
  }
  close(report_);
  close(output_);
}

bool Process::read_report(std::string& text) { return read_all(report_, text); }
bool Process::read_output(std::string& text) { return read_all(output_, text); }

TimeUsed Process::used() const {
  TimeUsed used{.clock = std::chrono::duration<double>(Clock::now() - started_).count()};
  clockid_t id = 0;
  timespec time{};
  if (clock_getcpuclockid(pid_, &id) == 0 && clock_gettime(id, &time) == 0)
    used.processor = static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  return used;
}

void Process::kill() { ::kill(-pid_, SIGKILL); }

int Process::wait() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

}  // namespace glark::conformance
