// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark run [OPTIONS] [--] PROGRAM [ARGUMENTS]: runs an unmodified program with refinement.
// glark doctor [OPTIONS] [--seconds N] [--] PROGRAM [ARGUMENTS]: runs it for a while and says what was refined and why.
// glark info: describes the OpenGL of this machine.
// glark pattern A B C: draws a pattern.
// glark help [TOPIC]: explains an option or a reason.
// The commands for files are separate programs.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <unistd.h>

#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "glark/settings/terminal.h"
#include "glark/tool/completion.h"
#include "glark/tool/doctor/doctor.h"
#include "glark/tool/exec.h"
#include "glark/tool/help_topics.h"
#include "glark/tool/info/info.h"
#include "glark/tool/pattern/command.h"
#include "glark/tool/run.h"
#include "glark/tool/settings_pages.h"

namespace {

using glark::tool::exit_usage;

// A check of CLI11 returns an error text, which is empty if the value is valid.
CLI::Validator checked(const glark::settings::Setting& setting) {
  return CLI::Validator(
      [&](std::string& text) {
        glark::settings::Settings scratch;
        return setting.read(scratch, text) ? std::string()
                                           : fmt::format("\"{}\" is not valid; {} is needed", text, setting.needed);
      },
      std::string());
}

void describe_run(CLI::App& run, glark::tool::RunOptions& options) {
  using glark::settings::Kind;
  for (const glark::settings::Setting& setting : glark::settings::table()) {
    const std::string name = fmt::format("--{}", setting.key);
    const std::string help = fmt::format("{} (default: {})", setting.help, glark::settings::shown_default(setting));
    const auto keep = [&options, &setting](const std::vector<std::string>& values) {
      options[setting.key] = values;
      return true;
    };
    if (setting.kind == Kind::toggle) {
      run.add_flag_callback(
             name, [keep] { keep({"1"}); }, help)
          ->group(std::string(setting.group));
      continue;
    }
    CLI::Option* option = run.add_option(name, keep, help)->group(std::string(setting.group));
    option->check(checked(setting))->type_name(std::string(setting.value))->allow_extra_args(false)->expected(1);
    if (setting.kind == Kind::captures) option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  run.footer(
      "PROGRAM and everything after it are run as they are. Write -- before a program whose name begins with a dash.");
}

// Takes the program and its arguments off the end of `words` and returns them. The program begins after "--", or at the
// first word that is neither an option nor the value of one.
std::vector<std::string> take_program(const CLI::App& run, std::vector<std::string>& words) {
  auto word = words.begin() + 1;  // past the command
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

// CLI11 names an option that it does not know, but not the one that was meant.
std::string with_nearest_option(const std::string& problem, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::string key = word.starts_with("--") ? word.substr(2, word.find('=') - 2) : std::string();
    if (key.empty() || key == "seconds" || key == "help" || glark::settings::find_setting(key) != nullptr) continue;
    const std::string_view nearest = glark::settings::nearest_key(key);
    if (!nearest.empty()) return fmt::format("there is no option --{}; is --{} meant?", key, nearest);
  }
  return problem;
}

// `words` are the arguments of glark; the first one may be a command.
int complain(const std::string& problem, const CLI::App& app, const std::vector<std::string>& words) {
  const auto is_named = [&](const CLI::App* command) { return command->get_name() == words.front(); };
  const bool known = !words.empty() && !app.get_subcommands(is_named).empty();
  const std::string command = known ? words.front() : "run";
  glark::tool::say(fmt::format("{}; glark --help lists the commands, glark {} --help the options", problem, command));
  return exit_usage;
}

struct Commands {
  CLI::App app{"glark refines the triangles of unmodified OpenGL programs.", "glark"};
  CLI::App* run = nullptr;
  CLI::App* doctor = nullptr;
  CLI::App* info = nullptr;
  CLI::App* pattern = nullptr;
  CLI::App* help = nullptr;
  CLI::App* settings = nullptr;
  glark::tool::RunOptions options;
  double seconds = 10;  // of the doctor
  glark::tool::PatternOptions drawing;
  std::string topic;
  std::string page;
};

void describe(Commands& commands) {
  CLI::App& app = commands.app;
  app.set_version_flag("--version", "glark " GLARK_VERSION);
  commands.run =
      app.add_subcommand("run", "Run a program with refinement: glark run [OPTIONS] [--] PROGRAM [ARGUMENTS]");
  describe_run(*commands.run, commands.options);
  commands.doctor = app.add_subcommand(
      "doctor",
      "Run a program for a while and say what was refined and why: glark doctor [OPTIONS] [--] PROGRAM [ARGUMENTS]");
  describe_run(*commands.doctor, commands.options);
  commands.doctor->add_option("--seconds", commands.seconds, "Stop the program after so many seconds (default: 10)")
      ->check(CLI::Range(0.1, 86400.0))
      ->type_name("N");
  commands.info = app.add_subcommand(
      "info",
      "Describe the OpenGL of this machine and whether glark can refine with it; with a FILE, describe the file");
  commands.pattern =
      app.add_subcommand("pattern", "Draw the pattern of three edge depths as SVG: glark pattern A B C [-o FILE.svg]");
  glark::tool::describe_pattern(*commands.pattern, commands.drawing);
  commands.help = app.add_subcommand("help", "Explain an option, or why a draw stays unrefined: glark help [TOPIC]");
  commands.help->add_option("topic", commands.topic,
                            "An option without --, a reason of the statistics, a key of a rule");
  commands.settings = app.add_subcommand("settings", "Print the table of settings")->group("");
  commands.settings->add_option("--as", commands.page)
      ->required()
      ->check(CLI::IsMember({"markdown", "man", "rules", "causes", "bash", "zsh"}));
  for (const glark::tool::OtherCommand& command : glark::tool::other_commands())
    if (glark::tool::find_program(command.program)) app.add_subcommand(command.name, command.help);
}

// Without a topic: the commands, and what else there is.
int help(const CLI::App& app, const std::string& topic) {
  using namespace glark::tool;
  if (topic.empty()) {
    fmt::print("{}\nTopics of glark help:\n", app.help());
    for (const std::string& name : help_topics()) fmt::print("  {}\n", name);
    return 0;
  }
  for (const CLI::App* command : app.get_subcommands([&](const CLI::App* each) { return each->get_name() == topic; })) {
    fmt::print("{}", command->help());
    return 0;
  }
  if (const auto text = help_on(topic, glark::settings::has_colors(STDOUT_FILENO))) {
    fmt::print("{}", *text);
    return 0;
  }
  const std::string nearest = nearest_topic(topic);
  say(fmt::format("there is no topic {}; {}", topic,
                  nearest.empty() ? "glark help lists all" : fmt::format("is {} meant?", nearest)));
  return exit_usage;
}

// The help of a command. Those for files are separate programs, which know their own options.
int help_on_word(const CLI::App& app, char** argv) {
  char option[] = "--help";
  if (const char* program = glark::tool::program_of(std::span(argv + 2, argv + 3))) {
    char* words[] = {argv[0], argv[2], option, nullptr};
    return glark::tool::become(program, words);
  }
  return help(app, argv[2]);
}

std::string completion(const CLI::App& app, bool zsh) {
  using namespace glark::tool;
  std::vector<CommandLine> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); }))
    commands.push_back({command->get_name(), command->get_description()});
  return zsh ? zsh_completion(commands, help_topics()) : bash_completion(commands, help_topics());
}

int print_settings(const CLI::App& app, const std::string& page) {
  using namespace glark::tool;
  const std::string text = page == "man"      ? settings_as_manual()
                           : page == "bash"   ? completion(app, false)
                           : page == "zsh"    ? completion(app, true)
                           : page == "rules"  ? rules_as_markdown()
                           : page == "causes" ? causes_as_markdown()
                                              : settings_as_markdown();
  std::fputs(text.c_str(), stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (const char* program = glark::tool::program_of(std::span(argv + 1, argv + argc)))
    return glark::tool::become(program, argv);
  Commands commands;
  describe(commands);
  std::vector<std::string> words(argv + 1, argv + argc);
  // CLI11 would take a topic that is a command for that command.
  if (words.size() == 2 && words[0] == "help" && !words[1].starts_with("-")) return help_on_word(commands.app, argv);
  std::vector<std::string> program;
  if (!words.empty() && words.front() == "run") program = take_program(*commands.run, words);
  if (!words.empty() && words.front() == "doctor") program = take_program(*commands.doctor, words);
  try {
    commands.app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Success& wanted) {  // --help, --version
    return commands.app.exit(wanted);
  } catch (const CLI::ParseError& error) {
    return complain(with_nearest_option(error.what(), words), commands.app, words);
  }
  if (commands.info->parsed()) return glark::tool::info();
  if (commands.pattern->parsed()) return glark::tool::draw_pattern(commands.drawing);
  if (commands.settings->parsed()) return print_settings(commands.app, commands.page);
  if (commands.help->parsed()) return help(commands.app, commands.topic);
  if (!commands.run->parsed() && !commands.doctor->parsed())
    return complain("no command is given", commands.app, words);
  if (program.empty())
    return complain(fmt::format("no program to run is given; write: glark {} [OPTIONS] PROGRAM [ARGUMENTS]", words[0]),
                    commands.app, words);
  if (commands.doctor->parsed()) return glark::tool::doctor(commands.options, program, commands.seconds);
  return glark::tool::run(commands.options, program);
}
