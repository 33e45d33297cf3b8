// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/edit/sampling.h"

#include <algorithm>
#include <utility>

#include "glark/clients/stream/edit/same_order.h"
#include "glark/clients/stream/edit/sample_pairs.h"
#include "glark/clients/stream/edit/sampling_in_cells.h"
#include "glark/clients/stream/edit/turned_normals.h"
#include "glark/clients/stream/files/with_vstree.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t tree_bytes_a_sample = 16, estimating_bytes_a_sample = 900;
constexpr std::size_t least_text = 8;  // bytes of a point

struct FileContents {
  std::vector<double> positions, channels;
  std::vector<float> normals;
  Schema schema;

  void reserve(std::size_t count) {
    positions.reserve(3 * count);
    if (schema.normals) normals.reserve(3 * count);
    channels.reserve(schema.channels.size() * count);
  }
};

// Throws Error for a file that cannot be read, or for coordinates with which floats cannot compute.
FileContents read_file(const std::filesystem::path& file) {
  const std::unique_ptr<PointReader> reader = open_points(file);
  FileContents all;
  all.schema = reader->schema();
  if (reader->count() && reader->can_seek()) all.reserve(static_cast<std::size_t>(*reader->count()));
  for (Points points = reader->read(); points.size() > 0; points = reader->read()) {
    all.positions.insert(all.positions.end(), points.positions.begin(), points.positions.end());
    all.normals.insert(all.normals.end(), points.normals.begin(), points.normals.end());
    all.channels.insert(all.channels.end(), points.channels.begin(), points.channels.end());
  }
  require_within_floats(all.positions, 0, file.string());
  return all;
}

// For each sample, its place in the edited file.
std::vector<std::size_t> places_of(const FileContents& to, const std::string& file, std::size_t count) {
  std::vector<std::size_t> places(count, none);
  const std::size_t index = channel_index(to.schema, "index"), width = to.schema.channels.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double sample = index == none ? static_cast<double>(i) : to.channels[width * i + index];
    if (!(sample >= 0 && sample < static_cast<double>(count)) || places[static_cast<std::size_t>(sample)] != none)
      fail_for_index(file, i, sample, count);
    places[static_cast<std::size_t>(sample)] = i;
  }
  return places;
}

// For each sample, whether a channel has another value than in `from`. Nothing if no sample has.
std::vector<std::uint8_t> edited_samples(const FileContents& from, const FileContents& to, std::size_t channel,
                                         const std::vector<std::size_t>& places) {
  const std::size_t old = channel_index(from.schema, to.schema.channels[channel].name);
  std::vector<std::uint8_t> edited(places.size(), 1);
  if (old == none) return edited;
  const std::size_t width = to.schema.channels.size(), old_width = from.schema.channels.size();
  bool is_edited = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    edited[i] = to.channels[width * places[i] + channel] != from.channels[old_width * i + old] ? 1 : 0;
    is_edited |= edited[i] != 0;
  }
  return is_edited ? edited : std::vector<std::uint8_t>();
}

// Normals that the file lacks are estimated.
std::vector<float> normals_of(const FileContents& before, const Samples& samples, const std::string& file,
                              const common::Workers& workers) {
  if (!before.normals.empty()) return before.normals;
  std::vector<float> positions;
  for (const Vector3f& p : samples.before) positions.insert(positions.end(), {p.x, p.y, p.z});
  const vstree::NormalOptions options{.threads = static_cast<unsigned>(workers.count())};
  return with_vstree(file, [&] { return vstree::estimate_normals({.positions = positions}, options); });
}

// Which channels were edited, and of which samples.
struct EditedChannels {
  std::vector<std::size_t> columns;  // of the edited file; the other channels keep the values of the scan
  std::vector<std::vector<std::uint8_t>> where;
};

EditedChannels edited_channels(const FileContents& before, const FileContents& after,
                               const std::vector<std::size_t>& places) {
  EditedChannels edited;
  for (std::size_t k = 0; k < after.schema.channels.size(); ++k) {
    if (after.schema.channels[k].name == "index") continue;
    std::vector<std::uint8_t> there = edited_samples(before, after, k, places);
    if (there.empty()) continue;
    edited.columns.push_back(k);
    edited.where.push_back(std::move(there));
  }
  return edited;
}

Samples samples_of(const FileContents& before, const FileContents& after, const std::vector<std::size_t>& places,
                   const EditedChannels& edited, const std::array<double, 3>& origin) {
  const auto relative = [&](const std::vector<double>& all, std::size_t i) {
    return Vector3f{static_cast<float>(all[3 * i] - origin[0]), static_cast<float>(all[3 * i + 1] - origin[1]),
                    static_cast<float>(all[3 * i + 2] - origin[2])};
  };
  const std::size_t channels = edited.columns.size(), width = after.schema.channels.size();
  Samples samples;
  samples.resize(places.size(), channels);
  for (std::size_t i = 0; i < places.size(); ++i) {
    samples.before[i] = relative(before.positions, i);
    samples.after[i] = relative(after.positions, places[i]);
    for (std::size_t k = 0; k < channels; ++k) {
      samples.values[channels * i + k] = static_cast<float>(after.channels[width * places[i] + edited.columns[k]]);
      samples.is_edited[channels * i + k] = edited.where[k][i];
    }
  }
  return samples;
}

// The sampling, but for its index and the turned normals.
struct Contents {
  Sampling sampling;
  Samples samples;
  bool has_indices = false;
};

Contents read_contents(const SamplingFiles& files, const common::Workers& workers) {
  const FileContents before = read_file(files.from), after = read_file(files.to);
  const std::size_t count = before.positions.size() / 3;
  require_same_count(files.from, count, files.to, after.positions.size() / 3);
  Contents contents;
  std::copy_n(before.positions.begin(), 3, contents.sampling.origin.begin());
  const std::vector<std::size_t> places = places_of(after, files.to.string(), count);
  const EditedChannels edited = edited_channels(before, after, places);
  for (const std::size_t k : edited.columns) contents.sampling.channels.push_back(after.schema.channels[k]);
  Samples& samples = contents.samples;
  samples = samples_of(before, after, places, edited, contents.sampling.origin);
  contents.sampling.is_deformed = samples.before != samples.after;
  const std::vector<float> normals = normals_of(before, samples, files.from.string(), workers);
  for (std::size_t i = 0; i < count; ++i)
    samples.normals[i] = common::unit(common::vector_at(std::span<const float>(normals), i));
  samples.normals_after = samples.normals;
  contents.has_indices = channel_index(after.schema, "index") != none;
  return contents;
}

Sampling read_into_memory(const SamplingFiles& files, const common::Workers& workers) {
  Contents contents = read_contents(files, workers);
  auto store = std::make_unique<SamplesInMemory>(std::move(contents.samples));
  if (contents.sampling.is_deformed) {
    if (!contents.has_indices) {
      const Samples& samples = store->samples();
      TriedSamples tried(samples.size());
      for (std::size_t i = 0; i < samples.size(); ++i) tried.add(i, samples.before[i], samples.after[i]);
      tried.require_same_order(*store, files.to.string());
    }
    turn_normals(*store, workers);
  }
  contents.sampling.store = std::move(store);
  return std::move(contents.sampling);
}

// The points of a file; of a text, at most so many.
std::size_t most_points(const std::filesystem::path& file, const PointReader& reader) {
  if (reader.count()) return static_cast<std::size_t>(*reader.count());
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return error ? 0 : static_cast<std::size_t>(size) / least_text;
}

}  // namespace

// A text or a compressed file may have fewer points than it says, so its arrays grow to twice their size.
SamplingBytes bytes_in_memory(const SamplingFiles& files) {
  SamplingBytes bytes;
  std::size_t samples = 0, channels = 0;
  for (const std::filesystem::path& file : {files.from, files.to}) {
    const std::unique_ptr<PointReader> reader = open_points(file);
    const Schema& schema = reader->schema();
    const std::size_t point =
        3 * sizeof(double) + sizeof(double) * schema.channels.size() + (schema.normals ? sizeof(Vector3f) : 0);
    samples = most_points(file, *reader);
    channels = schema.channels.size();
    bytes.reading += samples * point * (reader->can_seek() ? 1 : 2);
    if (file == files.from && !schema.normals) bytes.reading += samples * estimating_bytes_a_sample;
  }
  const std::size_t sample = 4 * sizeof(Vector3f) + channels * (sizeof(float) + 1);
  bytes.reading += samples * (sample + sizeof(std::size_t) + sizeof(Vector3f) + channels);
  bytes.kept = samples * (sample + tree_bytes_a_sample);
  return bytes;
}

Sampling read_sampling(const SamplingFiles& files, const SamplingMemory& memory, const common::Workers& workers) {
  if (bytes_in_memory(files).reading <= memory.sampling) return read_into_memory(files, workers);
  return read_into_cells(files, memory, workers);
}

}  // namespace glark::stream
