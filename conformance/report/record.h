// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "conformance/suite/verdict.h"

namespace glark::conformance {

// The result of a case after a run.
struct Record {
  std::string name;
  Verdict verdict = Verdict::missing;  // until the case's process reports an end
  Verdict seen = Verdict::missing;     // before the baseline looked at it
  double seconds = 0;
  std::vector<std::string> messages;
  std::vector<std::string> images;    // paths of PNG files, relative to the report's directory
  std::vector<std::string> commands;  // of OpenGL that it has called, without "gl", if they are noted
  std::string output;                 // what its process wrote to stdout and stderr
  bool is_over = false;
};

// The machine and the implementation, as their contexts describe them.
using Environment = std::map<std::string, std::string>;

}  // namespace glark::conformance
