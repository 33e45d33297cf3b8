// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark run [options] [--] PROGRAM ARGUMENTS: runs an unmodified program with refinement.
// glark info: says what refinement finds on this machine.
// Commands for files are programs of their own.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "glark/tool/exec.h"
#include "glark/tool/info.h"
#include "glark/tool/run.h"

namespace {

using glark::tool::exit_usage;

// CLI11's own check type: an error text, empty when the value is good.
CLI::Validator checked(const glark::settings::Setting& setting) {
  return CLI::Validator(
      [&](std::string& text) {
        glark::settings::Settings scratch;
        return setting.read(scratch, text)
                   ? std::string()
                   : '"' + text + "\" is not valid; " + std::string(setting.needed) + " is needed";
      },
      std::string());
}

void describe_run(CLI::App& run, glark::tool::RunOptions& options) {
  using glark::settings::Kind;
  for (const glark::settings::Setting& setting : glark::settings::table()) {
    const std::string name = "--" + std::string(setting.key);
    const auto keep = [&options, &setting](const std::vector<std::string>& values) {
      options[setting.key] = values;
      return true;
    };
    if (setting.kind == Kind::toggle) {
      run.add_flag_callback(
          name, [keep] { keep({"1"}); }, std::string(setting.help));
      continue;
    }
    CLI::Option* option = run.add_option(name, keep, std::string(setting.help));
    option->check(checked(setting))->type_name(std::string(setting.value))->allow_extra_args(false);
    if (setting.kind == Kind::captures)
      option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    else
      option->expected(1);
  }
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
  if (const char* program = glark::tool::program_of(std::span(argv + 1, argv + argc)))
    return glark::tool::become(program, argv);
  CLI::App app("glark refines the triangles of unmodified OpenGL programs.", "glark");
  app.set_version_flag("--version", "glark " GLARK_VERSION);
  glark::tool::RunOptions options;
  CLI::App* run =
      app.add_subcommand("run", "Run a program with refinement: glark run [options] [--] PROGRAM [ARGUMENTS]");
  describe_run(*run, options);
  CLI::App* info = app.add_subcommand(
      "info",
      "Say what OpenGL is here and whether glark can refine with it; with a FILE, what points and triangles it has");
  for (const glark::tool::OtherCommand& command : glark::tool::other_commands())
    if (glark::tool::find_program(command.program)) app.add_subcommand(command.name, command.help);

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
