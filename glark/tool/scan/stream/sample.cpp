// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark sample LARGE -o SMALL: samples of a scan of any size, or more samples of a region.
#include <fmt/format.h>

#include <glark/stream.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/console.h"
#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/stream/region.h"
#include "glark/tool/scan/stream/work_folder.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {
namespace {

struct Sample {
  std::string input, output, format;
  std::string region, from, to, edited_output;  // of a refinement
  stream::SampleOptions options;
  bool text = false, json = false;
};

// Not every format has normals, which a sampling always has.
void warn_without_normals(const std::string& output) {
  std::error_code error;
  if (std::filesystem::is_regular_file(output, error) && !stream::open_points(output)->schema().normals)
    warn(output + ": the format has no normals, so those of the samples are left out");
}

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
  const std::filesystem::path output = command.output;
  stream::SampleOptions options = command.options;
  Progress progress("sampling " + command.input);
  options.progress = [&](double fraction) { progress.show(fraction); };
  options.work = work_folder(output);
  const stream::SampleReport report =
      stream::sample_file(command.input, output, options, {.large = command.format, .text = command.text});
  warn_without_normals(command.output);
  if (report.left_out > 0)
    warn(fmt::format("{}: {} points with NaN or infinite coordinates are left out", command.input, report.left_out));
  const std::uint64_t least = options.target - options.target / 100;
  if (report.samples < std::min<std::uint64_t>(least, report.points - report.left_out))
    warn(fmt::format("{}: {} samples instead of {}, because its points lie in so few places{}", command.input,
                     report.samples, options.target,
                     report.in_core ? "" : " at the finest size that the memory allows; more --memory may give more"));
  if (report.is_shuffled)
    warn(command.input + ": the order of its points has no coherence; they went through a temporary file of cells");
  Report printed;
  printed["points"] = report.points;
  printed["samples"] = report.samples;
  printed["cells"] = report.cells.size();
  printed["in_core"] = report.in_core;
  printed["shuffled"] = report.is_shuffled;
  printed["seconds"] = progress.seconds();
  printed["peak_memory_bytes"] = peak_memory();
  print(printed, command.json);
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
  stream::SampleOptions& options = sampling->options;
  command->add_option("LARGE", sampling->input, "Points: .ply, .las, .stl, .xyz, .pts or .raw (triples of floats)")
      ->required();
  command->add_option("-o,--output", sampling->output, "The file to write: .ply, .las, .xyz, .pts or .raw")
      ->type_name("SMALL")
      ->required();
  CLI::Option* target =
      command->add_option("--target", options.target, "The most samples; the result has at most 1 % less")
          ->transform(whole_above_zero());
  command
      ->add_option("--error", options.error,
                   "Without a target: the root mean square distance of a sample's points from their tangent planes, "
                   "relative to the bounding box's diagonal; default 1e-4")
      ->check(above_zero())
      ->excludes(target);
  command->add_option("--memory", options.memory, "The most memory, as 64MB or 1GB; default 256MB")
      ->transform(bytes_above_zero())
      ->type_name("BYTES");
  command->add_option("--threads", options.threads,
                      "Most threads; default: all of the machine. The result is the same");
  command
      ->add_option_function<std::string>(
          "--format", [sampling](const std::string& name) { sampling->format = name; }, "The format of LARGE")
      ->type_name("NAME");
  command->add_flag("--skip-invalid", options.skip_invalid,
                    "Leave out points with NaN or infinite coordinates instead of stopping");
  describe_refinement(*command, *sampling);
  command->add_flag("--resume", options.resume, resume_help);
  command->add_flag("--text", sampling->text, "Write PLY as text");
  command->add_flag("--json", sampling->json, "Report as JSON on standard output");
  command->callback([sampling] { sample(*sampling); });
}

}  // namespace glark::tool
