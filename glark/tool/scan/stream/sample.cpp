// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark sample LARGE -o SMALL: samples of a scan of any size, or more samples of a region.
#include <memory>
#include <stdexcept>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/stream/region.h"
#include "glark/tool/scan/stream/sample_command.h"
#include "glark/tool/scan/stream/work_folder.h"

namespace glark::tool {
namespace {

// A sampling, or the refinement of one.
struct Sample : SampleCommand {
  std::string region, from, to, edited_output;  // of a refinement
};

void refine(const Sample& command) {
  if (command.from.empty()) throw std::runtime_error("--refine needs --from SMALL, the sampling to refine");
  stream::RefineFiles files;
  files.large = command.input;
  files.from = command.from;
  files.cells = command.from + ".cells";
  files.to = command.to.empty() ? command.from : command.to;
  files.output = command.output;
  files.edited_output = command.edited_output;
  stream::RefineOptions options;
  options.target = command.options.target;
  options.error = command.options.error;
  options.memory = command.options.memory;
  options.threads = command.options.threads;
  const Progress progress("refining " + command.from);
  const stream::RefineReport report = stream::refine(files, parse_region(command.region), options);
  warn_without_normals(command.output);
  Report printed;
  printed["points_read"] = report.points_read;
  printed["points"] = report.points;
  printed["new_samples"] = report.samples;
  printed["seconds"] = progress.seconds();
  printed["peak_memory_bytes"] = peak_memory();
  print(printed, command.json);
}

void sample(const Sample& command) {
  if (!command.region.empty()) return refine(command);
  if (!command.from.empty() || !command.to.empty() || !command.edited_output.empty())
    throw std::runtime_error("--from, --to and --edited-output belong to --refine");
  stream::SampleOptions options = command.options;
  Progress progress("sampling " + command.input);
  options.progress = [&](double fraction) { progress.show(fraction); };
  options.work = work_folder(command.output);
  const stream::SampleReport report =
      stream::sample_file(command.input, command.output, options, {.large = command.format, .text = command.text});
  print(report_of(command, report, progress.seconds()), command.json);
}

void describe_refinement(CLI::App& command, Sample& sampling) {
  command
      .add_option("--refine", sampling.region,
                  "Take more samples of a region: box:X,Y,Z,X,Y,Z, sphere:X,Y,Z,R, or channel:NAME for the samples "
                  "whose property is not zero")
      ->type_name("REGION");
  command.add_option("--from", sampling.from, "With --refine: the sampling, whose index is SMALL.cells")
      ->type_name("SMALL");
  command.add_option("--to", sampling.to, "With --refine: the edited sampling, in which the region lies")
      ->type_name("EDITED");
  command
      .add_option("--edited-output", sampling.edited_output,
                  "With --refine: the edited sampling and the new samples, deformed and coloured as those around them")
      ->type_name("OUT");
}

}  // namespace

void add_sample(CLI::App& app) {
  CLI::App* command = app.add_subcommand("sample", "Sample a scan of any size");
  const auto sampling = std::make_shared<Sample>();
  describe(*command, *sampling);
  describe_refinement(*command, *sampling);
  command->add_flag("--resume", sampling->options.resume, resume_help);
  command->callback([sampling] { sample(*sampling); });
}

}  // namespace glark::tool
