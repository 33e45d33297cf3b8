// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/sample_steps.h"

#include <fmt/format.h>

#include "glark/clients/stream/files/with_vstree.h"

namespace glark::stream {
namespace {

constexpr unsigned grid_levels = 7;  // the lattice has about 2^7 cubes along the scan
constexpr std::size_t least_memory = std::size_t{40} << 20;
constexpr std::size_t bytes_for_normals = 900;  // of a sample, while normals are estimated
constexpr std::size_t bytes_of_program = std::size_t{24} << 20;

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

[[noreturn]] void fail_without_points(const std::string& source) {
  throw Error(Element::file, 0, source + ": it has no points; export it again");
}

}  // namespace

void require_valid(const SampleOptions& options) {
  if (options.target == 0 && !(options.error > 0 && options.error < 1))
    throw Error(Element::option, 0,
                fmt::format("glark-stream: error is {}; above 0 and below 1 is possible", options.error));
  if (options.memory < least_memory)
    throw Error(
        Element::option, 0,
        fmt::format("glark-stream: memory is {} bytes; {} (40 MiB) is the least", options.memory, least_memory));
}

ReadOptions reading_options(const SampleOptions& options) {
  ReadOptions reading;
  reading.keep_invalid = options.skip_invalid;
  return reading;
}

bool is_sampled_in_core(const BlockSource& source, const SampleOptions& options) {
  if (source.count() == std::uint64_t{0}) fail_without_points(source.name());
  return options.allow_in_core && source.count() && fits_in_core(*source.count(), source.schema().normals, options);
}

CensusOptions counting_options(const Source& source, const SampleOptions& options, std::size_t threads) {
  return {choose_lattice(source, reading_options(options), grid_levels), most_cubes(options.memory), threads};
}

void require_points(const Census& census, const std::string& source) {
  if (census.points == 0) fail_without_points(source);
  if (census.cubes.empty())
    throw Error(Element::file, 0, source + ": no point has finite coordinates; export it again");
}

Cut cut_of(const Assembly& assembly, const Census& census, const SampleOptions& options) {
  return options.target > 0 ? assembly.cut_for(options.target)
                            : Cut{.threshold = static_cast<float>(options.error * census.diagonal())};
}

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

void write_samples(const Assembly& assembly, const Cut& cut, const SelectCell& select_cell, const Schema& source,
                   const SampleOptions& options, const CreateWriter& create, SampleReport& report) {
  const PointKind kind(source);
  const bool orients = !kind.has_normals && options.target * bytes_for_normals + bytes_of_program <= options.memory;
  SampleWriter writer(create(sampling_schema(source, kind.has_colours())), kind.has_colours(), orients);
  assembly.select(
      cut, select_cell,
      [&](const std::array<double, 3>& position, const ClusterNode& node) { writer.add(position, node); },
      report.cells);
  if (orients) writer.orient(options.threads);
  writer.finish();
  report.samples = writer.count();
}

}  // namespace glark::stream
