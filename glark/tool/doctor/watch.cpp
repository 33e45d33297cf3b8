// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/doctor/watch.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "glark/tool/run.h"

namespace glark::tool {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto pause_between_looks = std::chrono::milliseconds(100);
constexpr auto patience = std::chrono::seconds(2);  // between the request to end and the end by force

volatile sig_atomic_t interrupted = 0;
void note_interrupt(int) { interrupted = 1; }

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// The parents of all processes. The name in /proc/N/stat may hold blanks and parentheses.
std::map<int, int> parents_of_all() {
  std::map<int, int> parents;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", error)) {
    const int number = std::atoi(entry.path().filename().c_str());
    std::ifstream in(entry.path() / "stat");
    std::string text;
    if (number <= 0 || !std::getline(in, text)) continue;
    std::istringstream rest(text.substr(std::min(text.rfind(')') + 1, text.size())));
    char state = 0;
    int parent = 0;
    if (rest >> state >> parent && state != 'Z') parents[number] = parent;
  }
  return parents;
}

// We are the parent of orphans, so every process that the program started leads to us.
std::set<int> descendants() {
  const std::map<int, int> parents = parents_of_all();
  std::set<int> found;
  for (bool more = true; more;) {
    more = false;
    for (const auto& [number, parent] : parents)
      if (parent == getpid() || found.contains(parent)) more = found.insert(number).second || more;
  }
  return found;
}

void look_at(int number, std::map<int, SeenProcess>& seen) {
  const std::string folder = "/proc/" + std::to_string(number);
  std::ifstream maps(folder + "/maps");
  SeenProcess& process = seen[number];
  process.number = number;
  std::ifstream(folder + "/comm") >> process.name;
  for (std::string line; std::getline(maps, line);) {
    const std::string file = line.substr(line.rfind('/') + 1);
    process.has_glark = process.has_glark || file.starts_with("libGLARK.so");
    process.has_vulkan = process.has_vulkan || file.starts_with("libvulkan.so");
    for (const char* name : {"libGL.so", "libOpenGL.so", "libGLESv2.so", "libEGL.so", "libGLX.so", "libOSMesa.so"})
      process.has_gl = process.has_gl || file.starts_with(name);
  }
}

int start(const std::vector<std::string>& command) {
  const int child = fork();
  if (child == 0) {
    setsid();  // a program in the background must not stop because it reads from the terminal
    _exit(become_program(command));
  }
  return child;
}

Ending ending_of(int status, double seconds) {
  if (WIFSIGNALED(status)) return {Ending::How::crashed, WTERMSIG(status), seconds};
  return {Ending::How::left, WEXITSTATUS(status), seconds};
}

// Collects ended processes. Returns whether it met the program itself.
bool collect(int program, int& program_status) {
  bool met = false;
  int status = 0;
  for (int number = waitpid(-1, &status, WNOHANG); number > 0; number = waitpid(-1, &status, WNOHANG)) {
    met = met || number == program;
    if (number == program) program_status = status;
  }
  return met;
}

void stop_all() {
  int ignored = 0;
  for (const int how : {SIGTERM, SIGKILL}) {
    for (const int number : descendants()) kill(number, how);
    for (const Clock::time_point start = Clock::now(); Clock::now() - start < patience;) {
      collect(0, ignored);
      if (descendants().empty()) return;
      std::this_thread::sleep_for(pause_between_looks);
    }
  }
}

}  // namespace

Observation watch(const std::vector<std::string>& command, double seconds) {
  Observation observation;
  observation.program = command.front();
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  interrupted = 0;
  for (const int how : {SIGINT, SIGTERM, SIGHUP}) signal(how, note_interrupt);
  std::map<int, SeenProcess> seen;
  const Clock::time_point began = Clock::now();
  const int program = start(command);
  bool ended = program < 0;
  while (seconds_since(began) < seconds && interrupted == 0) {
    int status = 0;
    if (collect(program, status)) {
      ended = true;
      observation.ending = ending_of(status, seconds_since(began));
    }
    const std::set<int> living = descendants();
    if (ended && living.empty()) break;
    for (const int number : living) look_at(number, seen);
    std::this_thread::sleep_for(pause_between_looks);
  }
  if (!ended) observation.ending.seconds = seconds_since(began);
  stop_all();
  for (const int how : {SIGINT, SIGTERM, SIGHUP}) signal(how, SIG_DFL);
  for (const auto& [number, process] : seen) observation.processes.push_back(process);
  return observation;
}

}  // namespace glark::tool
