// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-scan: the commands of `glark` that work on files of points and triangles. It is a separate program, because its
// libraries would slow down the start of `glark run`.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "glark/clients/common/named_files.h"
#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/complaint.h"

using glark::tool::complain;
using glark::tool::exit_failure;
using glark::tool::exit_usage;

namespace {

// Ends as the signal ends a program, but leaves no file that only this run knows.
void end_by(int number) {
  glark::common::NamedFiles::unlink_all();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

// A signal that was ignored before, as by nohup, stays ignored.
void end_clean_by_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(number, end_by) == SIG_IGN) std::signal(number, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
  end_clean_by_signals();
  CLI::App app("glark: points and triangles in files", "glark");
  app.require_subcommand(1);
  glark::tool::add_info(app);
#if GLARK_HAS_VSTREE
  glark::tool::add_simplify(app);
#endif
#if GLARK_HAS_RECONSTRUCT
  glark::tool::add_reconstruct(app);
#endif
#if GLARK_HAS_SURFEL
  glark::tool::add_strip(app);
#endif
#if GLARK_HAS_STREAM
  glark::tool::add_sample(app);
  glark::tool::add_transfer(app);
#endif
#if GLARK_HAS_EDIT
  glark::tool::add_edit(app);
#endif
#if GLARK_HAS_MAPS
  glark::tool::add_bake(app);
#endif
  try {
    app.parse(argc, argv);
    if (std::fflush(stdout) != 0) return complain("the report cannot be written to standard output", exit_failure);
  } catch (const CLI::Success& wanted) {  // --help
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + "; glark COMMAND --help lists the options", exit_usage);
  } catch (const std::bad_alloc&) {
    return complain("the memory is too small for this file; split it into tiles or thin it first", exit_failure);
  } catch (const std::exception& error) {
    return complain(error.what(), exit_failure);
  }
  return 0;
}
