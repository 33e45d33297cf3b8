// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/stream/transfer_command.h"

#include <fmt/format.h>

#include <filesystem>

#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {

void describe(CLI::App& command, TransferCommand& transfer) {
  command.add_option("LARGE", transfer.input, "The scan: binary PLY, .las, .stl or .raw")->required();
  command.add_option("--from", transfer.from, "The sampling of the scan, as glark sample wrote it")
      ->type_name("SMALL")
      ->required();
  command
      .add_option("--to", transfer.to,
                  "The edited sampling. Its points have the same order, or a property \"index\" that tells it")
      ->type_name("EDITED")
      ->required();
  command.add_option("-o,--output", transfer.output, "The file to write, in the format of LARGE")
      ->type_name("OUT")
      ->required();
  command
      .add_option("--neighbours", transfer.options.neighbours,
                  "Samples that a point follows, 3 to 64; more make colours smoother; default 12")
      ->check(between(3, 64));
  command.add_flag("--sharp", transfer.options.singular, "Keep sharp borders of colours");
  command
      .add_option(
          "--memory", transfer.options.memory,
          "The most memory, as 64MB or 1GB; default 256MB. A sampling that does not fit lies in cells on the disk; "
          "the result is the same")
      ->transform(bytes_above_zero())
      ->type_name("BYTES");
  command.add_option("--threads", transfer.options.threads,
                     "Most threads; default: all of the machine. The result is the same");
  command.add_flag("--json", transfer.json, "Report as JSON on standard output");
}

namespace {

// LAS may have its waveforms in a file of their own, whose name is that of the points.
void warn_of_waveforms(const TransferCommand& transfer) {
  namespace fs = std::filesystem;
  const auto beside = [](fs::path file) { return file.replace_extension(".wdp").string(); };
  std::error_code error;
  if (fs::path(transfer.input).extension() != ".las" || !fs::is_regular_file(beside(transfer.input), error)) return;
  if (fs::exists(beside(transfer.output), error)) return;
  warn(fmt::format("{}: the waveforms of {} are not copied; copy them to {}", beside(transfer.input), transfer.input,
                   beside(transfer.output)));
}

}  // namespace

Report report_of(const TransferCommand& transfer, const stream::TransferReport& report, double seconds) {
  if (report.points_away > report.points / 2)
    warn(fmt::format("{} of the {} points of {} lie away from all samples of {}; is it a sampling of this scan?",
                     report.points_away, report.points, transfer.input, transfer.from));
  warn_of_waveforms(transfer);
  if (report.cells_on_disk > 0)
    warn(fmt::format(
        "{}: the sampling does not fit into the memory of {} bytes, so its {} cells are in a temporary file; "
        "more --memory takes less time",
        transfer.from, transfer.options.memory, report.cells_on_disk));
  Report printed;
  printed["points"] = report.points;
  printed["points_away"] = report.points_away;
  printed["cells_on_disk"] = report.cells_on_disk;
  printed["deformed"] = report.is_deformed;
  printed["channels"] = report.channels;
  printed["seconds"] = seconds;
  printed["peak_memory_bytes"] = peak_memory();
  return printed;
}

}  // namespace glark::tool
