// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/stream/files/source_file.h"
#include "glark/clients/stream/files/with_vstree.h"
#include "glark/clients/stream/sample/assembly.h"
#include "glark/clients/stream/sample/in_core.h"
#include "glark/clients/stream/sample/pass/trim_memory.h"
#include "glark/clients/stream/sample/sample_and_publish.h"

namespace glark::stream {
namespace {

constexpr unsigned grid_levels = 7;  // the lattice has about 2^7 cubes along the scan
constexpr std::size_t least_memory = std::size_t{40} << 20;
constexpr std::size_t bytes_for_normals = 900;  // of a sample, while normals are estimated
constexpr std::size_t program_bytes = std::size_t{24} << 20;

void check(const SampleOptions& options) {
  if (options.target == 0 && !(options.error > 0 && options.error < 1))
    throw Error(Element::option, 0,
                fmt::format("glark-stream: error is {}; above 0 and below 1 is possible", options.error));
  if (options.memory < least_memory)
    throw Error(
        Element::option, 0,
        fmt::format("glark-stream: memory is {} bytes; {} (40 MiB) is the least", options.memory, least_memory));
}

// Collects samples and gives them to a writer in blocks.
class SampleWriter {
 public:
  SampleWriter(std::unique_ptr<PointWriter> writer, bool has_colours, bool keeps_all)
      : writer_(std::move(writer)), has_colours_(has_colours), keeps_all_(keeps_all) {}

  void add(const std::array<double, 3>& position, const ClusterNode& node) {
    positions_.insert(positions_.end(), position.begin(), position.end());
    normals_.insert(normals_.end(), node.normal.begin(), node.normal.end());
    if (has_colours_) channels_.insert(channels_.end(), node.colour.begin(), node.colour.begin() + 3);
    if (!keeps_all_ && positions_.size() == 3 * block) flush();
    ++count_;
  }
  // The samples agree on the side of the surface: the sides of clusters without normals are not known.
  void orient(unsigned threads) {
    std::vector<float> local;
    for (std::size_t i = 0; i < positions_.size(); ++i)
      local.push_back(static_cast<float>(positions_[i] - positions_[i % 3]));
    normals_ = with_vstree("glark-stream",
                           [&] { return vstree::estimate_normals({.positions = local}, {.threads = threads}); });
  }
  void finish() {
    flush();
    writer_->finish();
  }
  std::uint64_t count() const { return count_; }

 private:
  static constexpr std::size_t block = 4096;

  void flush() {
    if (!positions_.empty()) writer_->write({count_ - positions_.size() / 3, positions_, normals_, channels_});
    positions_.clear();
    normals_.clear();
    channels_.clear();
  }

  std::unique_ptr<PointWriter> writer_;
  bool has_colours_, keeps_all_;
  std::vector<double> positions_, channels_;
  std::vector<float> normals_;
  std::uint64_t count_ = 0;
};

SampleReport report_of(const Census& census, const Plan& plan) {
  SampleReport report;
  report.points = census.points;
  report.left_out = census.left_out;
  report.is_shuffled = plan.is_shuffled;
  report.cells.reserve(plan.cells.size());
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    const Cell& cell = plan.cells[i];
    report.cells.push_back({plan.corner(i), plan.side(i), cell.count, cell.first, cell.last, 0, 0, 0});
  }
  return report;
}

// All that the saved states depend on.
std::string identity_of(const Source& source, const SampleOptions& options) {
  return fmt::format("glark sample 2\n{}\n{} {} {} {} {}\n", source.identity, options.target, options.error,
                     options.memory, options.skip_invalid, options.allow_in_core);
}

// The second pass. Sets plan.is_shuffled if the unfinished cells do not fit into memory after all.
std::unique_ptr<TreeStore> make_trees(const PassInput& input, Plan& plan, const std::filesystem::path& temporary) {
  WorkFolder& folder = input.checkpoints.folder();
  auto trees = std::make_unique<TreeStore>(folder, temporary, plan.cells.size());
  // A run before may have found this out.
  plan.is_shuffled |= folder.load("shuffled", [](StateReader&) { return true; });
  if (!plan.is_shuffled && !stream_cells(input, *trees)) {
    plan.is_shuffled = true;
    folder.save("shuffled", [](StateWriter&) {});
    trees = std::make_unique<TreeStore>(folder, temporary, plan.cells.size());
  }
  if (plan.is_shuffled) sort_into_cells(input, temporary, *trees);
  return trees;
}

Census census_of(const Source& source, const ReadOptions& reading, const CensusOptions& options,
                 const common::Workers& workers, const Advance& advance, Checkpoints& checkpoints) {
  ReadOptions positions_only = reading;
  positions_only.normals = positions_only.channels = false;
  BlockSource points(source, positions_only, workers);
  return take_census(points, options, advance, checkpoints);
}

// Writes the samples to a new file, and notes in `report` which cells have them.
void write_samples(const Assembly& assembly, const Cut& cut, const Schema& schema, const SampleOptions& options,
                   const CreateWriter& create, SampleReport& report) {
  const PointKind kind(schema);
  const bool orients = !kind.has_normals && options.target * bytes_for_normals + program_bytes <= options.memory;
  SampleWriter writer(create(sampling_schema(schema, kind.has_colours())), kind.has_colours(), orients);
  assembly.select(
      cut, [&](const std::array<double, 3>& position, const ClusterNode& node) { writer.add(position, node); },
      report.cells);
  if (orients) writer.orient(options.threads);
  writer.finish();
  report.samples = writer.count();
}

[[noreturn]] void fail_without_points(const Source& source) {
  throw Error(Element::file, 0, source.name + ": it has no points; export it again");
}

}  // namespace

Source file_source(const std::filesystem::path& file, const std::string& format) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(file, missing))
    return {file.string(),
            [file, format](const ReadOptions& options) {
              ReadOptions with_format = options;
              with_format.format = format;
              return open_points(file, with_format);
            },
            {}};
  const FileState before = SourceFile(file).state();
  return {file.string(),
          [file, format, before](const ReadOptions& options) {
            SourceFile(file).require_unchanged(before);
            ReadOptions with_format = options;
            with_format.format = format;
            return open_points(file, with_format);
          },
          fmt::format("{} {} {} {}", before.size, before.seconds, before.nanoseconds, format)};
}

SampleReport sample(const Source& source, const SampleOptions& options, const std::filesystem::path& temporary,
                    const CreateWriter& create) {
  return sample_and_publish(source, options, temporary, create, [](const SampleReport&) {});
}

SampleReport sample_and_publish(const Source& source, const SampleOptions& options,
                                const std::filesystem::path& temporary, const CreateWriter& create,
                                const std::function<void(const SampleReport&)>& published) {
  check(options);
  require_work(options.work, options.resume);
  const common::Workers workers(options.threads);
  ReadOptions reading;
  reading.keep_invalid = options.skip_invalid;
  BlockSource points(source, reading, workers);
  if (points.count() == std::uint64_t{0}) fail_without_points(source);
  if (options.allow_in_core && points.count() && fits_in_core(*points.count(), points.schema().normals, options)) {
    SampleReport report = sample_in_core(points, options, create);
    published(report);
    return report;
  }

  const bool keeps_states = !options.work.empty() && points.can_seek() && points.count() && !source.identity.empty();
  WorkFolder folder(keeps_states ? options.work : std::filesystem::path(), identity_of(source, options),
                    options.resume);
  Checkpoints checkpoints(folder, points.count().value_or(0));
  Census census;
  const auto part_done = [&](double begin, double share) {
    return [&, begin, share](std::uint64_t done) {
      const auto all = static_cast<double>(std::max<std::uint64_t>(1, points.count().value_or(census.points)));
      if (options.progress) options.progress(std::min(1.0, begin + share * static_cast<double>(done) / all));
    };
  };
  const CensusOptions counting{choose_lattice(source, reading, grid_levels), most_cubes(options.memory),
                               workers.count()};
  census = census_of(source, reading, counting, workers, part_done(0, 0.3), checkpoints);
  if (census.points == 0) fail_without_points(source);
  if (census.cubes.empty())
    throw Error(Element::file, 0, source.name + ": no point has finite coordinates; export it again");
  Plan plan = make_plan(census, options);
  census.cubes = {};
  trim_memory(options.memory);
  const PassInput input{points, census, plan, workers, part_done(0.3, 0.65), checkpoints};
  const std::unique_ptr<TreeStore> trees = make_trees(input, plan, temporary);
  trim_memory(options.memory);
  const Assembly assembly(plan, *trees);
  const Cut cut = options.target > 0 ? assembly.cut_for(options.target)
                                     : Cut{.threshold = static_cast<float>(options.error * census.diagonal())};
  SampleReport report = report_of(census, plan);
  write_samples(assembly, cut, points.schema(), options, create, report);
  published(report);
  folder.finish();
  if (options.progress) options.progress(1);
  return report;
}

}  // namespace glark::stream
