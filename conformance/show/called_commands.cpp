// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/show/called_commands.h"

#include <algorithm>

namespace glark::conformance {
namespace {

GladGLContext made_by;  // the functions that make the calls

struct Called {
  const char* name;
  bool is_called;
};

#include "conformance/called_commands.inc"

}  // namespace

CalledCommands::CalledCommands() {
  for (Called& each : called_commands) each.is_called = false;
  observer = this;
}

CalledCommands::~CalledCommands() { observer = nullptr; }

void CalledCommands::loaded(GladGLContext& functions) {
  made_by = functions;
  note_each_call(functions);
}

std::vector<std::string> CalledCommands::names() const {
  std::vector<std::string> names;
  for (const Called& each : called_commands)
    if (each.is_called) names.emplace_back(each.name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace glark::conformance
