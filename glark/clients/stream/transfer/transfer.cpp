// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/files/checkpoints.h"
#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/files/require_other_file.h"
#include "glark/clients/stream/format/layouts.h"
#include "glark/clients/stream/space/spatial_order.h"
#include "glark/clients/stream/transfer/deformation.h"
#include "glark/clients/stream/transfer/near_samples.h"
#include "glark/clients/stream/transfer/output_layout.h"
#include "glark/clients/stream/transfer/sampling.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t batch_size = 1 << 17, piece = 1 << 14;  // records

void check(const TransferOptions& options) {
  if (options.neighbours < 3 || options.neighbours > 64)
    throw Error(Element::option, 0,
                fmt::format("glark-stream: neighbours is {}; 3 to 64 are possible", options.neighbours));
}

// Copies records to records that may be larger.
void copy_records(std::span<const char> from, std::size_t size, std::size_t size_out, char* to) {
  for (std::size_t at = 0; at < from.size(); at += size, to += size_out) std::copy_n(&from[at], size, to);
}

class Transfer {
 public:
  Transfer(const Sampling& sampling, const SampleIndex& index, const OutputLayout& out, const TransferOptions& options,
           std::string file)
      : sampling_(sampling), index_(index), out_(out), options_(options), file_(std::move(file)) {}

  // Writes the edited points of some records, which are copies of those of the input.
  void apply(const Points& points, std::span<char> records) const {
    EditedPoints edited(points, sampling_, out_.channels().size());
    const std::vector<std::uint32_t> order = spatial_order(edited.local);
    NearSamples near(index_, sampling_.samples, options_.neighbours, sampling_.channels.size());
    for (std::size_t begin = 0; begin < order.size();) {
      const std::size_t end = gather(edited.local, order, begin, near);
      for (; begin < end; ++begin)
        if (is_finite(edited.local[order[begin]])) edit(order[begin], near, edited);
    }
    const Layout& layout = out_.layout();
    if (sampling_.is_deformed) encode(layout, file_, points.first, edited.positions, edited.normals, records);
    write_channels(edited.values, records);
  }

 private:
  struct EditedPoints {
    std::vector<double> positions;
    std::vector<float> normals;
    std::vector<EditedValue> values;  // [channels * points]
    std::vector<Vector3f> local;      // the positions before, relative to the origin of the sampling

    EditedPoints(const Points& points, const Sampling& sampling, std::size_t channels)
        : positions(points.positions.begin(), points.positions.end()),
          normals(points.normals.begin(), points.normals.end()),
          values(channels * points.size()),
          local(points.size()) {
      for (std::size_t i = 0; i < local.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) local[i][k] = static_cast<float>(positions[3 * i + k] - sampling.origin[k]);
    }
  };

  static bool is_finite(const Vector3f& p) { return std::isfinite(p.x + p.y + p.z); }

  // Gathers the samples around the next points that lie within the reach of the last search. Returns their end.
  static std::size_t gather(std::span<const Vector3f> points, const std::vector<std::uint32_t>& order,
                            std::size_t begin, NearSamples& near) {
    Vector3f low = points[order[begin]], high = low;
    if (!is_finite(low)) return begin + 1;
    const float most = 4 * near.reach() * near.reach();
    std::size_t end = begin + 1;
    for (; end < order.size(); ++end) {
      const Vector3f wider_low = common::least(low, points[order[end]]);
      const Vector3f wider_high = common::greatest(high, points[order[end]]);
      if (!(common::squared_distance(wider_low, wider_high) <= most)) break;
      low = wider_low;
      high = wider_high;
    }
    near.gather((low + high) * 0.5F);
    return end;
  }

  void edit(std::size_t i, NearSamples& near, EditedPoints& points) const {
    const Vector3f p = points.local[i];
    const std::span<const Neighbour> neighbours = near.find(p, options_.singular);
    interpolate(near.samples(), neighbours, points.values.data() + out_.channels().size() * i);
    if (!sampling_.is_deformed || stay(near.samples(), neighbours)) return;
    const bool has_normals = !points.normals.empty();
    const Vector3f normal = has_normals ? common::vector_at(std::span<const float>(points.normals), i) : Vector3f{};
    const Deformed moved = deform(near.samples(), p, normal, neighbours);
    for (std::size_t k = 0; k < 3; ++k) {
      points.positions[3 * i + k] += static_cast<double>(moved.position[k]) - static_cast<double>(p[k]);
      if (has_normals) points.normals[3 * i + k] = moved.normal[k];
    }
  }

  // Points whose neighbours did not move keep their coordinates to the bit.
  static bool stay(const Samples& samples, std::span<const Neighbour> neighbours) {
    return std::all_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& near) {
      return samples.before[near.index] == samples.after[near.index] &&
             samples.normals[near.index] == samples.normals_after[near.index];
    });
  }

  void interpolate(const Samples& samples, std::span<const Neighbour> near, EditedValue* values) const {
    const std::size_t width = sampling_.channels.size();
    for (const WrittenChannel& channel : out_.channels())
      *values++ = edited_value(samples, near, width, channel.column);
  }

  // Writes the channels of the points that an edited sample is near to. The records have the values before.
  void write_channels(const std::vector<EditedValue>& values, std::span<char> records) const {
    const Layout& layout = out_.layout();
    const std::size_t width = out_.channels().size();
    if (layout.points_per_record != 1) return;
    const Column column{layout.record_size, records.size() / layout.record_size, layout.swapped};
    std::vector<double> mixed(column.count);
    for (std::size_t k = 0; k < width; ++k) {
      const WrittenChannel& channel = out_.channels()[k];
      const auto is_kept = [&](std::size_t i) { return values[width * i + k].share == 0; };
      std::size_t kept = 0;
      for (std::size_t i = 0; i < column.count; ++i) kept += is_kept(i) ? 1 : 0;
      if (kept == column.count) continue;
      read_column(channel.field, column, records.data(), mixed.data(), 1);
      for (std::size_t i = 0; i < column.count; ++i)
        if (!is_kept(i)) mixed[i] = channel.scale * values[width * i + k].mixed_with(mixed[i] / channel.scale);
      write_column(channel.field, column, records.data(), mixed.data(), 1);
    }
  }

  const Sampling& sampling_;
  const SampleIndex& index_;
  const OutputLayout& out_;
  const TransferOptions& options_;
  const std::string file_;
};

// The output of a transfer, with the state that a later run continues from.
class Output {
 public:
  Output(const std::filesystem::path& file, WorkFolder& folder, const OutputLayout& layout)
      : folder_(folder), layout_(layout) {
    folder.require_same_disk(file);
    const bool is_begun = folder.load("done", [&](StateReader& state) { return state.get(state_); });
    if (!is_begun) state_ = {};
    const std::uint64_t kept = is_begun ? layout.header().size() + state_.done * layout.layout().record_size : 0;
    writing([&] {
      file_ = folder.is_used() ? std::make_unique<geometry::OutputFile>(file, folder.path("output"), kept)
                               : std::make_unique<geometry::OutputFile>(file);
      if (file_->is_direct()) throw Error(Element::file, 0, file.string() + ": is a pipe or a device; write to a file");
      if (!is_begun) file_->write(layout.header());
    });
  }

  std::uint64_t done() const { return state_.done; }
  void add(std::span<const char> records, std::size_t count) {
    add_to_box(records, count);
    writing([&] { file_->write({records.data(), records.size()}); });
    state_.done += count;
  }
  void save() {
    writing([&] { file_->flush(); });
    folder_.save("done", [&](StateWriter& state) { state.put(state_); });
  }
  // Copies what follows the records, and puts the file in its place.
  void finish(const SourceFile& from, std::uint64_t begin, OutputLayout& layout) {
    std::string bytes;
    writing([&] {
      for (; begin < from.size(); begin += bytes.size()) {
        bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(1 << 20, from.size() - begin)));
        from.read(begin, bytes);
        file_->write(bytes);
      }
      if (state_.done > 0) file_->overwrite(0, layout.final_header(state_.low, state_.high));
      file_->commit();
    });
    folder_.finish();
  }

 private:
  struct State {
    std::uint64_t done = 0;  // records
    std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  };

  // A LAS header stores the bounding box.
  void add_to_box(std::span<const char> records, std::size_t count) {
    if (!layout_.has_box()) return;
    PointArrays points;
    decode(layout_.layout(), records.data(), count, {.normals = false, .channels = false}, points);
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
      state_.low[i % 3] = std::min(state_.low[i % 3], points.positions[i]);
      state_.high[i % 3] = std::max(state_.high[i % 3], points.positions[i]);
    }
  }

  WorkFolder& folder_;
  const OutputLayout& layout_;
  std::unique_ptr<geometry::OutputFile> file_;
  State state_;
};

// All that the saved state depends on.
std::string identity_of(const FileState& large, const std::filesystem::path& from, const std::filesystem::path& to,
                        const TransferOptions& options) {
  const FileState before = SourceFile(from).state(), after = SourceFile(to).state();
  std::string identity = fmt::format("glark transfer 1\n{} {}\n", options.neighbours, options.singular);
  for (const FileState& state : {large, before, after})
    identity += fmt::format("{} {} {}\n", state.size, state.seconds, state.nanoseconds);
  return identity;
}

std::vector<std::string> names_of(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  return names;
}

// The records of the scan are copied, whatever the name of the output says.
void require_same_format(const std::filesystem::path& output, const SourceFile& large, const std::string& format) {
  if (format_of(output, "") == format && !is_compressed(output)) return;
  throw Error(Element::file, 0,
              fmt::format("{}: the output has the format of {}; name it with the ending {}", output.string(),
                          large.name(), format));
}

// The layout of the scan and of the output, but for channels that the edit adds.
Layout binary_layout(const SourceFile& file, const std::string& format, const std::filesystem::path& output) {
  const std::optional<Layout> layout = layout_of(file, format);
  if (!layout || is_compressed(file.name()))
    throw Error(Element::file, 0,
                file.name() +
                    ": is text or compressed, and an edit is transferred to binary files; convert it to "
                    "binary PLY first");
  require_same_format(output, file, format);
  return *layout;
}

}  // namespace

TransferReport transfer(const std::filesystem::path& large, const std::filesystem::path& from,
                        const std::filesystem::path& to, const std::filesystem::path& output,
                        const TransferOptions& options) {
  check(options);
  require_work(options.work, options.resume);
  require_name(output, "the output");
  require_other_file(output, {large, from, to});
  const SourceFile file(large);
  const FileState before = file.state();
  const std::string format = format_of(large, "");
  const Layout layout = binary_layout(file, format, output);
  const common::Workers workers(options.threads);
  const Sampling sampling = read_sampling(from, to, workers);
  const SampleIndex index(sampling.samples.before);
  OutputLayout out(file, layout, format, sampling.channels);
  const Transfer edit(sampling, index, out, options, output.string());
  WorkFolder folder(options.work, identity_of(before, from, to, options), options.resume);
  Checkpoints checkpoints(folder, layout.records);
  Output written(output, folder, out);
  checkpoints.begin(written.done());
  const std::size_t size = layout.record_size, size_out = out.layout().record_size;
  std::vector<char> records(batch_size * size), edited(batch_size * size_out);
  while (written.done() < layout.records) {
    const std::uint64_t done = written.done();
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(batch_size, layout.records - done));
    file.read(layout.begin + done * size, std::span(records).first(count * size));
    workers.in_pieces(count, piece, [&](std::size_t begin, std::size_t end) {
      copy_records(std::span(records).subspan(begin * size, (end - begin) * size), size, size_out,
                   &edited[begin * size_out]);
      PointArrays points;
      decode(layout, &records[begin * size], end - begin, {.channels = false}, points);
      edit.apply(points.points((done + begin) * layout.points_per_record),
                 std::span(edited).subspan(begin * size_out, (end - begin) * size_out));
    });
    written.add(std::span(edited).first(count * size_out), count);
    if (checkpoints.is_due(written.done())) written.save();
    if (options.progress) options.progress(static_cast<double>(written.done()) / static_cast<double>(layout.records));
  }
  file.require_unchanged(before);
  written.finish(file, layout.begin + layout.size(), out);
  return {layout.points(), sampling.is_deformed, names_of(sampling.channels)};
}

}  // namespace glark::stream
