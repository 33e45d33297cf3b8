// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark edit SCAN: edits a scan of any size by its sampling, in a session that stays on the disk.
#include <fmt/format.h>
#include <glark/edit.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/console.h"
#include "glark/tool/scan/edit/prompt.h"
#include "glark/tool/scan/edit/script.h"
#include "glark/tool/scan/edit/session_names.h"
#include "glark/tool/scan/edit/window.h"
#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {
namespace {

struct Edit {
  std::string input, script, output, folder;
  edit::SessionOptions options;
  int width = 1024, height = 768;  // of the window, in pixels
  bool window = false, json = false;
};

std::filesystem::path folder_of(const Edit& command) {
  return command.folder.empty() ? session_folder(command.input) : std::filesystem::path(command.folder);
}

std::vector<std::string> window_arguments(const Edit& command) {
  std::vector<std::string> arguments{
      "--session=" + folder_of(command).string(),         fmt::format("--target={}", command.options.target),
      fmt::format("--memory={}", command.options.memory), fmt::format("--threads={}", command.options.threads),
      fmt::format("--width={}", command.width),           fmt::format("--height={}", command.height)};
  if (!command.output.empty()) arguments.push_back("--output=" + command.output);
  arguments.insert(arguments.end(), {"--", command.input});
  return arguments;
}

edit::Session open_session(const Edit& command) {
  Progress progress("sampling " + command.input);
  edit::SessionOptions options = command.options;
  options.progress = [&](double fraction) { progress.show(fraction); };
  edit::Session session(command.input, folder_of(command), options);
  if (session.has_dropped_line())
    warn(folder_of(command).string() + ": the last operation was not complete, and is left out");
  return session;
}

// Returns the seconds of the slowest operation.
double run(const std::vector<ScriptLine>& script, const std::string& file, edit::Session& session) {
  Progress progress("editing");
  double slowest = 0;
  for (std::size_t k = 0; k < script.size(); ++k) {
    const double begun = progress.seconds();
    try {
      session.apply(script[k].operation);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: line {}: {}; the session has the {} operations before", file,
                                           script[k].number, error.what(), k));
    }
    slowest = std::max(slowest, progress.seconds() - begun);
    progress.show(static_cast<double>(k + 1) / static_cast<double>(script.size()));
  }
  return slowest;
}

edit::SaveReport save(const edit::Session& session, const std::string& output) {
  Progress progress("transferring to " + output);
  return session.save(output, [&](double fraction) { progress.show(fraction); });
}

void edit_scan(const Edit& command) {
  if (command.window || (command.script.empty() && can_open_window())) become_window(window_arguments(command));
  const Progress whole("editing " + command.input);
  std::vector<ScriptLine> script;
  const bool has_script = !command.script.empty() && command.script != "-";
  std::error_code error;
  if (has_script && !command.output.empty() && std::filesystem::equivalent(command.script, command.output, error))
    throw std::runtime_error(command.output + ": is the script, which would be lost; write to another file");
  if (has_script) script = read_script(command.script);
  edit::Session session = open_session(command);
  Report printed;
  if (has_script)
    printed["slowest_operation_seconds"] = run(script, command.script, session);
  else
    edit_by_prompt(session, [&](const std::string& output) { save(session, output); });
  printed["samples"] = session.editor().size();
  printed["operations"] = session.operations();
  printed["replayed"] = session.replayed();
  if (!command.output.empty()) {
    const edit::SaveReport report = save(session, command.output);
    printed["points"] = report.points;
    printed["deformed"] = report.is_deformed;
    printed["painted"] = report.is_painted;
  }
  printed["seconds"] = whole.seconds();
  printed["peak_memory_bytes"] = peak_memory();
  print(printed, command.json);
}

std::string operations() {
  std::string text = "Operations, one in each line:\n";
  for (const edit::Form& form : edit::forms()) text += fmt::format("  {}\n      {}\n", form.form, form.help);
  return text + "Lengths are in the scan's unit. Lines that begin with # are comments.";
}

}  // namespace

void add_edit(CLI::App& app) {
  CLI::App* command = app.add_subcommand("edit", "Edit a scan of any size by its sampling");
  const auto wanted = std::make_shared<Edit>();
  edit::SessionOptions& options = wanted->options;
  command->add_option("SCAN", wanted->input, "The scan: binary PLY, .las, .stl or .raw")->required();
  CLI::Option* script =
      command
          ->add_option(
              "--script", wanted->script,
              "A file with an operation in each line; - is standard input. Default: a window on a terminal with a "
              "display, else standard input")
          ->type_name("FILE");
  command->add_flag("--window", wanted->window, "Edit in a window, also without a terminal")->excludes(script);
  command->add_option("--width", wanted->width, "Width of the window in pixels; default 1024")
      ->check(CLI::Range(1, largest_side));
  command->add_option("--height", wanted->height, "Height of the window in pixels; default 768")
      ->check(CLI::Range(1, largest_side));
  command->add_option("-o,--output", wanted->output, "The file to write at the end, in the format of SCAN")
      ->type_name("OUT");
  command->add_option("--session", wanted->folder, "The folder of the session; default: SCAN with the ending .edit")
      ->type_name("FOLDER");
  command->add_option("--target", options.target, "The most samples of a new session; default 200000")
      ->transform(whole_above_zero());
  command->add_option("--memory", options.memory, "The most memory for the sampling, as 64MB or 1GB; default 256MB")
      ->transform(bytes_above_zero())
      ->type_name("BYTES");
  command->add_option("--threads", options.threads,
                      "Most threads; default: all of the machine. The result is the same");
  command->add_flag("--json", wanted->json, "Report as JSON on standard output");
  command->footer(operations());
  command->callback([wanted] { edit_scan(*wanted); });
}

}  // namespace glark::tool
