// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The state of an abstract run of the vertex stage.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "glark/core/refine/soundness/memory.h"
#include "glark/core/refine/soundness/notes.h"

namespace glark::refine {

// A loop or a switch that is being executed.
struct Breakable {
  bool loop = false;
  Value control = {};  // what decides whether the rest is executed
  Memory::State at_break{{}, true};
  Memory::State at_continue{{}, true};
};

// A call of a function of the application.
struct Call {
  std::size_t unit = 0;
  Shape result = {};
  Value control = {};  // what decides whether the rest is executed, after a return
  Memory::State at_return{{}, true};
  std::vector<Breakable> breakables = {};
};

struct Run {
  explicit Run(std::size_t units) : notes(units) {}

  Memory memory;
  Notes notes;
  std::set<std::string> constants;  // attributes that are the same at all corners
  Value control;                    // the conditions around the current statement
  std::vector<Call> calls;
  std::size_t steps = 0;

  Place place(int line) const { return {calls.back().unit, line}; }
  // Everything that decides whether the current statement is executed.
  Value whole_control() const {
    Value value = worse(control, calls.back().control);
    for (const Breakable& breakable : calls.back().breakables) value = worse(value, breakable.control);
    return value;
  }
};

}  // namespace glark::refine
