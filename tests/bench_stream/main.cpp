// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-bench-stream: makes scans, and measures sampling and transfer.
#include <fmt/format.h>

#include <glark/stream.h>
#include <sys/resource.h>
#include <time.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>

#include "tests/bench_stream/edits.h"
#include "tests/bench_stream/generator.h"
#include "tests/bench_stream/quality.h"

namespace {

using namespace glark;

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peak_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

// Runs a step, and prints a row of a table.
template <class Step>
void measure(const std::string& name, std::uint64_t points, const Step& step) {
  const auto begun = std::chrono::steady_clock::now();
  const double cpu = cpu_seconds();
  const std::string note = step();
  const double used = cpu_seconds() - cpu;
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  const double millions = static_cast<double>(points) / 1e6;
  fmt::print("| {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {} |\n", name, millions, used, wall, millions / used,
             peak_mib(), note);
}

struct Sampling {
  std::filesystem::path scan, small;
  std::size_t target = 200000, memory = std::size_t{64} << 20;
  unsigned threads = 0;
};

void sample(const Sampling& run) {
  const std::uint64_t points = stream::open_points(run.scan)->count().value_or(0);
  measure("sample " + run.scan.filename().string(), points, [&] {
    const stream::SampleReport report =
        stream::sample(stream::file_source(run.scan),
                       {.target = run.target, .memory = run.memory, .threads = run.threads, .allow_in_core = false},
                       run.small.parent_path(),
                       [&](const stream::Schema& schema) { return stream::create_points(run.small, schema); });
    return fmt::format("{} samples, {} cells{}", report.samples, report.cells.size(),
                       report.is_shuffled ? ", shuffled" : "");
  });
}

void transfer(const Sampling& run, const std::string& edit) {
  const bench::Box box = bench::box_of(run.scan);
  const std::filesystem::path edited = run.small.string() + ".edited.ply",
                              out = run.scan.string() + ".edited" + run.scan.extension().string();
  bench::write_edited(edit, box, run.small, edited);
  const std::uint64_t points = stream::open_points(run.scan)->count().value_or(0);
  measure("transfer, " + edit, points, [&] {
    stream::transfer(run.scan, run.small, edited, out, {.threads = run.threads});
    return std::string();
  });
  fmt::print("RMS of {}: {:.5f} % of the diagonal\n", edit, 100 * bench::error_of(edit, box, run.scan, out));
  std::filesystem::remove(edited);
  std::filesystem::remove(out);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes scans, and measures sampling and transfer", "glark-bench-stream");
  app.require_subcommand(1);
  bench::ScanOptions scan;
  std::filesystem::path model, file;
  CLI::App* generate = app.add_subcommand("generate", "Make a scan of a model");
  generate->add_option("MODEL", model, "A mesh")->required();
  generate->add_option("-o", file, "The scan to write")->required();
  generate->add_option("--points", scan.points, "Its points");
  generate->add_flag("--shuffled", scan.shuffled, "In no order");
  generate->callback([&] { bench::write_scan(bench::ScanGenerator(model, scan), scan.points, file); });

  CLI::App* quality = app.add_subcommand("quality", "Measure the distance of a scan from a sampling");
  std::uint64_t step = 1;
  quality->add_option("SCAN", file)->required();
  quality->add_option("SMALL", model, "The sampling")->required();
  quality->add_option("--step", step, "Measure each N-th point");
  quality->callback(
      [&] { fmt::print("RMS distance: {:.6f} % of the diagonal\n", 100 * bench::distance_of(file, model, step)); });

  Sampling run;
  std::string edit = "bend";
  CLI::App* sampled = app.add_subcommand("sample", "Measure the sampling of a scan");
  CLI::App* transferred = app.add_subcommand("transfer", "Measure the transfer of an edit");
  for (CLI::App* command : {sampled, transferred}) {
    command->add_option("SCAN", run.scan)->required();
    command->add_option("SMALL", run.small, "The sampling")->required();
    command->add_option("--threads", run.threads);
  }
  sampled->add_option("--target", run.target);
  sampled->add_option("--memory", run.memory)->transform(CLI::AsSizeValue(false));
  transferred->add_option("--edit", edit, "none, bend, twist or inflate");
  sampled->callback([&] { sample(run); });
  transferred->callback([&] { transfer(run, edit); });
  try {
    fmt::print(
        "| step | M points | CPU s | wall s | M points / CPU s | peak MiB | result |\n|---|---|---|---|---|---|---|\n");
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glark-bench-stream: %s\n", error.what());
    return 1;
  }
  return 0;
}
