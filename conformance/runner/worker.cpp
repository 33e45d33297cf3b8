// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/worker.h"

#include <dlfcn.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "conformance/runner/exit_status.h"
#include "conformance/show/called_commands.h"
#include "conformance/show/show.h"
#include "conformance/suite/test.h"

namespace glark::conformance {
namespace {

void send(int channel, const nlohmann::json& message) {
  const std::string line = message.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) + '\n';
  for (std::size_t sent = 0; sent < line.size();) {
    const ssize_t count = write(channel, line.data() + sent, line.size() - sent);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

std::string text_of(GLenum name) {
  const GLubyte* const text = gl.GetString(name);
  return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

nlohmann::json environment_of(Test& test) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_DEPTH_ARK, &most);
  while (gl.GetError() != GL_NO_ERROR) {
  }
  return {{"api", name_of(test.api())},
          {"vendor", text_of(GL_VENDOR)},
          {"renderer", text_of(GL_RENDERER)},
          {"version", text_of(GL_VERSION)},
          {"shading language", text_of(GL_SHADING_LANGUAGE_VERSION)},
          {"GL_ARK_adaptive_refinement", test.has_extension("GL_ARK_adaptive_refinement") ? "yes" : "no"},
          {"GL_MAX_DEPTH_ARK", std::to_string(most)}};
}

std::vector<std::string> keep_images(const Result& result, const std::string& name, const std::string& report) {
  std::vector<std::string> paths;
  if (report.empty()) return paths;
  for (std::size_t i = 0; i < result.images.size(); ++i) {
    std::string label = result.images[i].name;
    std::replace_if(
        label.begin(), label.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
    std::string number = std::to_string(i);
    number.insert(0, 2 - std::min<std::size_t>(2, number.size()), '0');
    std::string path = "images/" + name;
    path += '-' + number + '-' + label + ".png";
    write_png(result.images[i].picture, report + "/" + path);
    paths.push_back(path);
  }
  return paths;
}

const Case& case_of(const std::string& name) {
  const auto& cases = all_cases();
  const auto found = std::lower_bound(cases.begin(), cases.end(), name,
                                      [](const Case& c, const std::string& n) { return c.name < n; });
  if (found == cases.end() || found->name != name) throw std::runtime_error("no case " + name);
  return *found;
}

void run_one(const std::string& name, Platform& platform, const RunOptions& options, int channel) {
  const Case& test_case = case_of(name);
  send(channel, {{"begin", name}});
  std::optional<CalledCommands> called;
  if (options.notes_commands) called.emplace();
  Result result = run_case(test_case, platform, options.api, options.seed);
  std::vector<std::string> images;
  try {
    images = keep_images(result, name, options.report);
  } catch (const std::exception& error) {
    result.messages.emplace_back(error.what());
  }
  send(channel, {{"end", name},
                 {"verdict", name_of(result.verdict)},
                 {"messages", result.messages},
                 {"images", images},
                 {"commands", called ? called->names() : std::vector<std::string>()}});
}

// The dynamic linker only warns if it cannot preload. Then the suite would judge a driver instead of the library.
bool is_loaded(const std::string& library) {
  return library.empty() || dlopen(library.c_str(), RTLD_LAZY | RTLD_NOLOAD) != nullptr;
}

// Each context takes and gives back some large blocks. Without this, glibc gives their pages to the kernel, which clears
// them each time: a third of the time of most cases.
void keep_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TOP_PAD, 16 << 20);
#endif
}

}  // namespace

int work(WorkerTask task, const RunOptions& options, const std::vector<std::string>& names, int channel) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a case that hangs must not outlive the program that would end it
  keep_memory();
  try {
    if (!is_loaded(options.implementation)) {
      send(channel, {{"not loaded", "the dynamic linker does not load " + options.implementation + '\n'}});
      return exit_status::usage;
    }
    const auto platform = Platform::open(options.platform);
    if (task == WorkerTask::describe) {
      Test test(*platform, options.api, "environment", options.seed);
      send(channel, {{"environment", environment_of(test)}});
    }
    if (task == WorkerTask::show) {
      send(channel, {{"shown", show(case_of(names.at(0)), *platform, options.api, options.seed)}});
      return exit_status::passed;
    }
    for (const std::string& name : names) run_one(name, *platform, options, channel);
  } catch (const std::exception& error) {
    send(channel, {{"error", error.what()}});
    return exit_status::no_context;
  }
  return exit_status::passed;
}

}  // namespace glark::conformance
