// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark transfer LARGE --from SMALL --to EDITED -o OUT: the edit of a sampling, on the scan that it was taken from.
#include <fmt/format.h>
#include <glark/stream.h>

#include <memory>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/console.h"
#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/stream/work_folder.h"

namespace glark::tool {
namespace {

struct Transfer {
  std::string input, from, to, output;
  stream::TransferOptions options;
  bool json = false;
};

void transfer(const Transfer& command) {
  stream::TransferOptions options = command.options;
  Progress progress("transferring to " + command.output);
  options.progress = [&](double fraction) { progress.show(fraction); };
  options.work = work_folder(command.output);
  const stream::TransferReport report =
      stream::transfer(command.input, command.from, command.to, command.output, options);
  if (report.points_away > report.points / 2)
    warn(fmt::format("{} of the {} points of {} lie away from all samples of {}; is it a sampling of this scan?",
                     report.points_away, report.points, command.input, command.from));
  Report printed;
  printed["points"] = report.points;
  printed["points_away"] = report.points_away;
  printed["deformed"] = report.is_deformed;
  printed["channels"] = report.channels;
  printed["seconds"] = progress.seconds();
  printed["peak_memory_bytes"] = peak_memory();
  print(printed, command.json);
}

}  // namespace

void add_transfer(CLI::App& app) {
  CLI::App* command = app.add_subcommand("transfer", "Transfer the edit of a sampling to the scan");
  const auto edit = std::make_shared<Transfer>();
  stream::TransferOptions& options = edit->options;
  command->add_option("LARGE", edit->input, "The scan: binary PLY, .las, .stl or .raw")->required();
  command->add_option("--from", edit->from, "The sampling of the scan, as glark sample wrote it")
      ->type_name("SMALL")
      ->required();
  command
      ->add_option("--to", edit->to,
                   "The edited sampling. Its points have the same order, or a property \"index\" that tells it")
      ->type_name("EDITED")
      ->required();
  command->add_option("-o,--output", edit->output, "The file to write, in the format of LARGE")
      ->type_name("OUT")
      ->required();
  command
      ->add_option("--neighbours", options.neighbours,
                   "Samples that a point follows, 3 to 64; more make colours smoother; default 12")
      ->check(between(3, 64));
  command->add_flag("--sharp", options.singular, "Keep sharp borders of colours");
  command->add_option("--threads", options.threads,
                      "Most threads; default: all of the machine. The result is the same");
  command->add_flag("--resume", options.resume, resume_help);
  command->add_flag("--json", edit->json, "Report as JSON on standard output");
  command->callback([edit] { transfer(*edit); });
}

}  // namespace glark::tool
