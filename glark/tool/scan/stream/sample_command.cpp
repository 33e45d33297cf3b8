// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/stream/sample_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {

void describe(CLI::App& command, SampleCommand& sample) {
  stream::SampleOptions& options = sample.options;
  command.add_option("LARGE", sample.input, "Points: .ply, .las, .stl, .xyz, .pts or .raw (triples of floats)")
      ->required();
  command.add_option("-o,--output", sample.output, "The file to write: .ply, .las, .xyz, .pts or .raw")
      ->type_name("SMALL")
      ->required();
  CLI::Option* target =
      command.add_option("--target", options.target, "The most samples; the result has at most 1 % less")
          ->transform(whole_above_zero());
  command
      .add_option("--error", options.error,
                  "Without a target: the root mean square distance of a sample's points from their tangent planes, "
                  "relative to the bounding box's diagonal; default 1e-4")
      ->check(above_zero())
      ->excludes(target);
  command.add_option("--memory", options.memory, "The most memory, as 64MB or 1GB; default 256MB")
      ->transform(bytes_above_zero())
      ->type_name("BYTES");
  command.add_option("--threads", options.threads, "Most threads; default: all of the machine. The result is the same");
  command
      .add_option_function<std::string>(
          "--format", [&sample](const std::string& name) { sample.format = name; }, "The format of LARGE")
      ->type_name("NAME");
  command.add_flag("--skip-invalid", options.skip_invalid,
                   "Leave out points with NaN or infinite coordinates instead of stopping");
  command.add_flag("--text", sample.text, "Write PLY as text");
  command.add_flag("--json", sample.json, "Report as JSON on standard output");
}

void warn_without_normals(const std::string& output) {
  std::error_code error;
  if (std::filesystem::is_regular_file(output, error) && !stream::open_points(output)->schema().normals)
    warn(output + ": the format has no normals, so those of the samples are left out");
}

Report report_of(const SampleCommand& sample, const stream::SampleReport& report, double seconds) {
  const std::size_t target = sample.options.target;
  warn_without_normals(sample.output);
  if (report.left_out > 0)
    warn(fmt::format("{}: {} points with NaN or infinite coordinates are left out", sample.input, report.left_out));
  const std::uint64_t least = target - target / 100;
  if (report.samples < std::min<std::uint64_t>(least, report.points - report.left_out))
    warn(fmt::format("{}: {} samples instead of {}, because its points lie in so few places{}", sample.input,
                     report.samples, target,
                     report.in_core ? "" : " at the finest size that the memory allows; more --memory may give more"));
  if (report.is_shuffled)
    warn(sample.input + ": the order of its points has no coherence; they went through a temporary file of cells");
  Report printed;
  printed["points"] = report.points;
  printed["samples"] = report.samples;
  printed["cells"] = report.cells.size();
  printed["in_core"] = report.in_core;
  printed["shuffled"] = report.is_shuffled;
  printed["seconds"] = seconds;
  printed["peak_memory_bytes"] = peak_memory();
  return printed;
}

}  // namespace glark::tool
