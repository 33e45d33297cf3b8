// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "conformance/platform/platform.h"

namespace glark::conformance {

struct RunOptions {
  std::string platform = "osmesa";
  Api api = Api::gl_compat;
  unsigned seed = 1;
  int jobs = 1;
  int seconds = 60;  // that one case may compute
  int cases_in_process = 1;
  int retries = 0;  // of a case that fails; if it passes then, it is a flake
  bool is_verbose = false;
  bool notes_commands = false;  // in the report: which commands of OpenGL each case calls
  std::string report;           // directory, or empty
  std::string implementation;   // a library to preload into the processes of cases, or empty
};

}  // namespace glark::conformance
