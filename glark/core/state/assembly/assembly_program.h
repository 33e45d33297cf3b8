// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Assembly vertex programs (ARB_vertex_program) of a share group.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "glark/core/state/assembly/program_parameters.h"

namespace glark::core {

// A program object of the application.
struct AssemblyProgram {
  std::mutex mutex;               // guards the members below
  bool refused = false;           // GL refused the last text
  std::uint64_t text_epoch = 0;   // the epoch in which the text was read; 0: read it again
  std::uint64_t text_number = 0;  // equal numbers mean equal texts, also of programs with other names
  std::string text;
  ProgramParameters local;

  std::uint64_t current_text_number() {
    const std::lock_guard lock(mutex);
    return text_number;
  }
  std::string current_text() {
    const std::lock_guard lock(mutex);
    return refused ? std::string() : text;
  }
};

struct AssemblyPrograms {
  std::unordered_map<GLuint, std::shared_ptr<AssemblyProgram>> by_name;  // guarded by the group's mutex
  std::atomic<std::uint64_t> texts{0};                                   // read so far
  std::atomic<std::uint64_t> epoch{1};  // changes when a call that is not followed may have changed any program
};

}  // namespace glark::core
