// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace glark::test {

struct Outcome {
  int status = -1;     // of exit; -1 if the process was killed
  std::string output;  // standard output and error
};

// A shell command.
Outcome run(const std::string& command);
// The same with libGLARK.so preloaded into `program`; `environment` is "NAME=value ..." or empty.
Outcome run_preloaded(const std::string& program, const std::string& environment = "");

std::string read_file(const std::string& path);

}  // namespace glark::test
