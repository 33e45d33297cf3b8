// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What glark doctor knows after it has watched a program: plain values.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace glark::tool {

// How the program that was started came to its end.
struct Ending {
  enum class How { stopped, left, crashed };  // stopped: by the doctor, after the given time
  How how = How::stopped;
  int status = 0;  // exit status, or the number of the signal
  double seconds = 0;
};

// A process that was seen, by the libraries that it had loaded.
struct SeenProcess {
  int number = 0;
  std::string name = {};
  bool has_glark = false;
  bool has_gl = false;
  bool has_vulkan = false;
};

using Count = std::pair<std::string, std::uint64_t>;  // a key of cause.h or refinement_fallback.h, and draws

// The statistics file of a process.
struct ProcessReport {
  struct Context {
    std::string version;
    bool refinable = false;
  };
  std::string name = {};
  int number = 0;
  std::vector<Context> contexts = {};
  std::uint64_t frames = 0;
  std::uint64_t seen = 0;
  std::uint64_t refined = 0;
  std::uint64_t coarse_triangles = 0;
  std::uint64_t refined_triangles = 0;
  std::vector<Count> left = {};            // by cause, the most frequent first
  std::vector<Count> fallbacks = {};       // the most frequent first
  std::vector<Count> refinements = {};     // draws by the refinement that they got, the most frequent first
  std::vector<std::string> problems = {};  // of shader programs
};

struct Observation {
  std::string program = {};
  Ending ending = {};
  std::vector<SeenProcess> processes = {};
  std::vector<ProcessReport> reports = {};
  bool has_display = true;
};

}  // namespace glark::tool
