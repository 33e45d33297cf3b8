// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Source: Boubekeur 2007, ch. 4.5.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/files/require_other_file.h"
#include "glark/clients/stream/files/source_file.h"
#include "glark/clients/stream/refine/index_text.h"
#include "glark/clients/stream/refine/region_points.h"
#include "glark/clients/stream/samples/near_samples.h"
#include "glark/clients/stream/transfer/deformation.h"

namespace glark::stream {
namespace {

using common::Vector3f;

// Reads points in memory. They belong to the source.
class MemoryReader final : public PointReader {
 public:
  MemoryReader(const RegionPoints& points, const std::string& name, const ReadOptions& options)
      : points_(points), name_(name), options_(options), schema_(points.schema) {
    schema_.normals = schema_.normals && options.normals;
    if (!options.channels) schema_.channels.clear();
  }
  const std::string& name() const override { return name_; }
  const Schema& schema() const override { return schema_; }
  std::optional<std::uint64_t> count() const override { return points_.positions.size() / 3; }
  bool can_seek() const override { return true; }
  void seek(std::uint64_t point) override { next_ = static_cast<std::size_t>(point); }
  Points read(std::size_t most) override {
    const std::size_t size = std::min(most, points_.positions.size() / 3 - next_);
    const std::size_t width = points_.schema.channels.size();
    Points result{next_, std::span(points_.positions).subspan(3 * next_, 3 * size), {}, {}};
    if (schema_.normals) result.normals = std::span(points_.normals).subspan(3 * next_, 3 * size);
    if (options_.channels) result.channels = std::span(points_.channels).subspan(width * next_, width * size);
    next_ += size;
    return result;
  }

 private:
  const RegionPoints& points_;
  const std::string& name_;
  ReadOptions options_;
  Schema schema_;
  std::size_t next_ = 0;
};

// Keeps what is written.
class MemoryWriter final : public PointWriter {
 public:
  MemoryWriter(const Schema& schema, RegionPoints& to) : to_(to) { to_.schema = schema; }
  const Schema& schema() const override { return to_.schema; }
  void write(const Points& points) override {
    to_.positions.insert(to_.positions.end(), points.positions.begin(), points.positions.end());
    to_.normals.insert(to_.normals.end(), points.normals.begin(), points.normals.end());
    to_.channels.insert(to_.channels.end(), points.channels.begin(), points.channels.end());
  }
  void finish() override {}

 private:
  RegionPoints& to_;
};

// The edit at each new sample.
struct EditedSamples {
  std::vector<double> positions;
  std::vector<float> normals;
  std::vector<EditedValue> values;  // of the sampling's edited channels
};

EditedSamples edit_of(const RegionPoints& added, const Sampling& sampling, const RefineOptions& options) {
  const std::size_t width = sampling.channels.size();
  NearSamples near(*sampling.store, options.neighbours);
  EditedSamples edited{added.positions, added.normals, {}};
  for (std::size_t i = 0; i < added.positions.size() / 3; ++i) {
    Vector3f p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<float>(added.positions[3 * i + k] - sampling.origin[k]);
    const std::span<const Neighbour> neighbours = near.find(p, false);
    for (std::size_t k = 0; k < width; ++k) edited.values.push_back(edited_value(near.samples(), neighbours, width, k));
    if (!sampling.is_deformed) continue;
    const Deformed moved =
        deform(near.samples(), p, common::vector_at(std::span<const float>(added.normals), i), neighbours);
    for (std::size_t k = 0; k < 3; ++k) {
      edited.positions[3 * i + k] += static_cast<double>(moved.position[k]) - static_cast<double>(p[k]);
      edited.normals[3 * i + k] = moved.normal[k];
    }
  }
  return edited;
}

// Copies a sampling to a file, and adds new samples. value(i, channel) is the value of a new sample.
template <class Value>
void write_with(const std::filesystem::path& from, const std::filesystem::path& to,
                const std::vector<double>& positions, const std::vector<float>& normals, const Value& value) {
  const std::unique_ptr<PointReader> reader = open_points(from);
  const Schema& schema = reader->schema();
  const std::unique_ptr<PointWriter> writer = create_points(to, schema);
  std::uint64_t count = 0;
  for (Points points = reader->read(); points.size() > 0; points = reader->read()) {
    writer->write(points);
    count += points.size();
  }
  std::vector<double> channels;
  for (std::size_t i = 0; i < positions.size() / 3; ++i)
    for (const Channel& channel : schema.channels)
      channels.push_back(channel.name == "index" ? static_cast<double>(count + i) : value(i, channel));
  writer->write(
      {count, positions, schema.normals ? std::span<const float>(normals) : std::span<const float>{}, channels});
  writer->finish();
}

std::size_t index_in(const std::vector<Channel>& channels, const std::string& name) {
  for (std::size_t k = 0; k < channels.size(); ++k)
    if (channels[k].name == name) return k;
  return none;
}

void check(const RefineOptions& options) {
  if (options.neighbours < 3 || options.neighbours > 64)
    throw Error(Element::option, 0,
                fmt::format("glark-stream: neighbours is {}; 3 to 64 are possible", options.neighbours));
}

void check(const RefineFiles& files) {
  for (const std::filesystem::path& output : {files.output, files.edited_output})
    require_other_file(output, {files.large, files.cells, files.from, files.to});
  require_other_file(files.output, {files.edited_output});
}

SampleOptions sample_options(const RefineOptions& options) {
  SampleOptions sampling;
  sampling.target = options.target;
  sampling.error = options.error;
  sampling.memory = options.memory;
  sampling.threads = options.threads;
  return sampling;
}

// Half of the memory: the points of the region get the other one. Small samplings stay in memory in any case.
std::size_t sampling_memory(std::size_t memory) { return std::max(memory / 2, std::size_t{16} << 20); }

}  // namespace

RefineReport refine(const RefineFiles& files, const Region& region, const RefineOptions& options) {
  check(options);
  require_name(files.output, "the output");
  check(files);
  require_replaceable_index(files.output.string() + ".cells");
  const common::Workers workers(options.threads);
  CellIndex index = read_cells(files.cells);
  if (const SourceFile scan(files.large); scan.size() != index.bytes)
    throw Error(Element::file, 0,
                fmt::format("{}: has {} bytes, its index was made for {}; sample the scan again", scan.name(),
                            scan.size(), index.bytes));
  const Sampling sampling = read_sampling({files.from, files.to, files.output.parent_path()},
                                          {sampling_memory(options.memory), options.memory}, workers);
  const std::size_t samples = sampling.store->size();
  if (index.samples != 0 && index.samples != samples)
    throw Error(Element::file, 0,
                fmt::format("{}: is the index of a sampling with {} samples, {} has {}; sample the scan again",
                            files.cells.string(), index.samples, files.from.string(), samples));
  const std::vector<bool> is_inside = samples_in(region, sampling, files.to.string());
  const RegionPoints points = read_region(files.large, index, sampling, is_inside, options.memory, workers);
  if (points.positions.empty() && points.samples > 0)
    throw Error(
        Element::option, 0,
        fmt::format("{}: all {} points of the region are samples already", files.large.string(), points.samples));
  if (points.positions.empty())
    throw Error(Element::file, 0,
                files.large.string() + ": has no points in the region; the sampling may be that of another scan");
  const std::string name = files.large.string();
  const Source source{
      name, [&](const ReadOptions& reading) { return std::make_unique<MemoryReader>(points, name, reading); }, {}};
  RegionPoints added;
  sample(source, sample_options(options), files.output.parent_path(),
         [&](const Schema& schema) { return std::make_unique<MemoryWriter>(schema, added); });
  const auto value_of = [&](std::size_t i, const Channel& channel) {
    const std::size_t k = channel_index(added.schema, channel.name);
    return k == none ? 0.0 : added.channels[added.schema.channels.size() * i + k];
  };
  if (!files.edited_output.empty()) {
    const EditedSamples edited = edit_of(added, sampling, options);
    write_with(files.to, files.edited_output, edited.positions, edited.normals,
               [&](std::size_t i, const Channel& channel) {
                 const std::size_t k = index_in(sampling.channels, channel.name);
                 const double own = value_of(i, channel);
                 return k == none ? own : edited.values[sampling.channels.size() * i + k].mixed_with(own);
               });
  }
  write_with(files.from, files.output, added.positions, added.normals, value_of);
  index.samples = samples + added.positions.size() / 3;
  write_cells(files.output.string() + ".cells", index);
  return {points.points_read, points.positions.size() / 3 + points.samples, added.positions.size() / 3};
}

}  // namespace glark::stream
