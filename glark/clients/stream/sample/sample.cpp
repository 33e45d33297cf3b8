// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "glark/clients/stream/files/source_file.h"
#include "glark/clients/stream/files/trim_memory.h"
#include "glark/clients/stream/files/work_folder.h"
#include "glark/clients/stream/sample/sample_and_publish.h"
#include "glark/clients/stream/sample/sample_steps.h"

namespace glark::stream {
namespace {

// All that the saved states depend on.
std::string identity_of(const Source& source, const SampleOptions& options) {
  return fmt::format("glark sample 2\n{}\n{} {} {} {} {}\n", source.identity, options.target, options.error,
                     options.memory, options.skip_invalid, options.allow_in_core);
}

// The second pass. Sets plan.is_shuffled if the unfinished cells do not fit into memory after all.
std::unique_ptr<TreeStore> make_trees(const PassInput& input, Plan& plan, const std::filesystem::path& temporary) {
  common::WorkFolder& folder = input.checkpoints.folder();
  auto trees = std::make_unique<TreeStore>(folder, temporary, plan.cells.size());
  // A run before may have found this out.
  plan.is_shuffled |= folder.load("shuffled", [](common::StateReader&) { return true; });
  if (!plan.is_shuffled && !stream_cells(input, *trees)) {
    plan.is_shuffled = true;
    folder.save("shuffled", [](common::StateWriter&) {});
    trees = std::make_unique<TreeStore>(folder, temporary, plan.cells.size());
  }
  if (plan.is_shuffled) sort_into_cells(input, temporary, *trees);
  return trees;
}

Census census_of(const Source& source, const ReadOptions& reading, const CensusOptions& options,
                 const common::Workers& workers, const Advance& advance, common::Checkpoints& checkpoints) {
  ReadOptions positions_only = reading;
  positions_only.normals = positions_only.channels = false;
  BlockSource points(source, positions_only, workers);
  return take_census(points, options, advance, checkpoints);
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
  require_valid(options);
  require_work(options.work, options.resume);
  const common::Workers workers(options.threads);
  const ReadOptions reading = reading_options(options);
  BlockSource points(source, reading, workers);
  if (is_sampled_in_core(points, options)) {
    SampleReport report = sample_in_core(points, options, create);
    published(report);
    return report;
  }

  const bool keeps_states = !options.work.empty() && points.can_seek() && points.count() && !source.identity.empty();
  WorkFolder folder(keeps_states ? options.work : std::filesystem::path(), identity_of(source, options),
                    options.resume);
  common::Checkpoints checkpoints(folder, points.count().value_or(0));
  Census census;
  const auto part_done = [&](double begin, double share) {
    return [&, begin, share](std::uint64_t done) {
      const auto all = static_cast<double>(std::max<std::uint64_t>(1, points.count().value_or(census.points)));
      if (options.progress) options.progress(std::min(1.0, begin + share * static_cast<double>(done) / all));
    };
  };
  const CensusOptions counting = counting_options(source, options, workers.count());
  census = census_of(source, reading, counting, workers, part_done(0, 0.3), checkpoints);
  require_points(census, source.name);
  Plan plan = make_plan(census, options);
  census.cubes = {};
  trim_memory(options.memory);
  const PassInput input{points, census, plan, workers, part_done(0.3, 0.65), checkpoints};
  const std::unique_ptr<TreeStore> trees = make_trees(input, plan, temporary);
  trim_memory(options.memory);
  Divisions divisions;
  for (std::size_t cell = 0; cell < plan.cells.size(); ++cell) add_divisions(*trees, cell, divisions);
  const Assembly assembly(plan, *trees, divisions);
  const auto select_cell = [&](std::size_t cell, Chooser& chooser, CellSamples& samples) {
    select_in_cell(plan, *trees, cell, chooser, samples);
  };
  SampleReport report = report_of(census, plan);
  write_samples(assembly, cut_of(assembly, census, options), select_cell, points.schema(), options, create, report);
  published(report);
  folder.finish();
  if (options.progress) options.progress(1);
  return report;
}

}  // namespace glark::stream
