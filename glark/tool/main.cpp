// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark run [options] [--] PROGRAM ARGUMENTS: runs an unmodified program with refinement.
// glark info: says what refinement finds on this machine.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "glark/tool/info.h"
#include "glark/tool/run.h"

namespace {

using glark::tool::exit_usage;

// CLI11's own check type: an error text, empty when the value is good.
template <class T>
CLI::Validator checked(std::optional<T> (*parse)(std::string_view), std::string_view needed) {
  return CLI::Validator(
      [=](std::string& text) {
        return parse(text) ? std::string() : '"' + text + "\" is not valid; " + std::string(needed) + " is needed";
      },
      std::string());
}

void describe_measures(CLI::App& run, glark::tool::RunOptions& options) {
  using namespace glark::settings;
  run.add_option(
         "--edge-pixels", options.edge_pixels,
         "Each edge as deep as its length on the screen wants: the longest segment, in pixels; instead of --level")
      ->check(checked(parse_edge_pixels, needed_edge_pixels()))
      ->type_name("P");
  run.add_option("--curvature", options.curvature,
                 "Each edge as deep as the normals at its ends differ: the greatest turn of a segment, in degrees")
      ->check(checked(parse_curvature, needed_curvature()))
      ->type_name("DEGREES");
  run.add_option("--budget", options.budget, "Refined triangles a frame that --edge-pixels and --curvature give way to")
      ->check(checked(parse_budget, needed_budget()))
      ->type_name("N");
}

void describe_run(CLI::App& run, glark::tool::RunOptions& options) {
  using namespace glark::settings;
  run.add_option("--level", options.level, "Uniform level of refinement, 0 to 11")
      ->check(checked(parse_level, needed_level()))
      ->type_name("N");
  run.add_option("--max-level", options.max_level, "Deepest level that patterns are made for, 0 to 11")
      ->check(checked(parse_level, needed_level()))
      ->type_name("N");
  run.add_option("--refine", options.refine,
                 "linear (vertex stage on every refined vertex), outputs (interpolate its results) or pn (curved)")
      ->check(checked(parse_refinement, needed_refinement()))
      ->type_name("KIND");
  describe_measures(run, options);
  run.add_flag("--wireframe", options.wireframe, "Draw the refined triangles as lines");
  run.add_option("--capture", options.captures, "Write that frame, counted from 1, as an image; may be repeated")
      ->check(checked(parse_captures, needed_captures()))
      ->type_name("FRAME:FILE.png")
      ->allow_extra_args(false);
  run.add_option("--log", options.log, "Most verbose messages wanted: error, warning, info or debug")
      ->check(checked(parse_log_level, needed_log_level()))
      ->type_name("LEVEL");
  run.add_option("--stats", options.statistics, "Write statistics of the run")->type_name("FILE.json");
  run.footer(
      "PROGRAM and all that follows it are run as they are. Write -- before a program whose name begins with a dash.");
}

// The program of `glark run` begins at "--" or at the first word that is neither an option nor its value; what follows is not
// for us to parse. Leaves the words before it in `words`.
std::vector<std::string> take_program(const CLI::App& run, std::vector<std::string>& words) {
  auto word = words.begin() + 1;  // past "run"
  for (; word != words.end() && word->starts_with("-") && *word != "--"; ++word) {
    const CLI::Option* option = run.get_option_no_throw(word->substr(0, word->find('=')));
    const bool value_follows =
        option != nullptr && option->get_items_expected_min() > 0 && word->find('=') == std::string::npos;
    if (value_follows && word + 1 != words.end()) ++word;
  }
  const auto program = word != words.end() && *word == "--" ? word + 1 : word;
  std::vector<std::string> taken(program, words.end());
  words.erase(word, words.end());
  return taken;
}

int complain(const std::string& problem) {
  std::fprintf(stderr, "glark: %s; glark --help lists the commands, glark run --help the options\n", problem.c_str());
  return exit_usage;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("glark refines the triangles of unmodified OpenGL programs.", "glark");
  app.set_version_flag("--version", "glark " GLARK_VERSION);
  glark::tool::RunOptions options;
  CLI::App* run =
      app.add_subcommand("run", "Run a program with refinement: glark run [options] [--] PROGRAM [ARGUMENTS]");
  describe_run(*run, options);
  CLI::App* info = app.add_subcommand("info", "Say what OpenGL is here and whether glark can refine with it");

  std::vector<std::string> words(argv + 1, argv + argc);
  std::vector<std::string> program;
  if (!words.empty() && words.front() == "run") program = take_program(*run, words);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Success& wanted) {  // --help, --version
    return app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return complain(error.what());
  }
  if (info->parsed()) return glark::tool::info();
  if (!run->parsed()) return complain("no command is given");
  if (program.empty()) return complain("no program to run is given; write: glark run [options] PROGRAM [ARGUMENTS]");
  return glark::tool::run(options, program);
}
