// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/format/las_header.h"
#include "glark/clients/stream/format/layouts.h"
#include "glark/clients/stream/transfer/deformation.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t batch_size = 1 << 16, piece = 1 << 10;  // points

void check(const TransferOptions& options) {
  if (options.neighbours < 3 || options.neighbours > 64)
    throw Error(Element::option, 0,
                fmt::format("glark-stream: neighbours is {}; 3 to 64 are possible", options.neighbours));
}

// A channel that is written: its column in the sampling, and its field in the records.
struct WrittenChannel {
  std::size_t column = 0;
  Field field;
  double scale = 1;  // from the numbers of the sampling to those of the file
};

double range_of(Number type) { return type == Number::uint8 ? 255 : type == Number::uint16 ? 65535 : 1; }

bool is_colour(const std::string& name) {
  return name == "red" || name == "green" || name == "blue" || name == "alpha";
}

// The layout of the output, whose records may have further channels, and its header.
class OutputLayout {
 public:
  OutputLayout(const SourceFile& file, const Layout& from, const std::string& format, const Sampling& sampling)
      : layout_(from), header_(static_cast<std::size_t>(from.begin), '\0') {
    file.read(0, header_);
    for (std::size_t k = 0; k < sampling.channels.size(); ++k) add(file, format, sampling.channels[k], k);
    if (format == ".las") las_ = read_las_header(file);
  }
  const Layout& layout() const { return layout_; }
  const std::vector<WrittenChannel>& channels() const { return channels_; }
  std::string_view header() const { return header_; }

  // The header with the bounding box of the new positions, for formats that have one.
  std::string final_header(const std::array<double, 3>& low, const std::array<double, 3>& high) {
    if (!las_) return header_;
    las_->least = low;
    las_->greatest = high;
    patch_las_header(*las_, header_);
    return header_;
  }

 private:
  void add(const SourceFile& file, const std::string& format, const Channel& channel, std::size_t column) {
    std::size_t at = channel_index(layout_.schema, channel.name);
    if (at == none) {
      if (format != ".ply")
        throw Error(
            Element::file, 0,
            fmt::format("{}: its records have no {}, which the edited sampling has; convert the file to PLY, or "
                        "remove the channel from the sampling",
                        file.name(), channel.name));
      at = layout_.channels.size();
      layout_.schema.channels.push_back(channel);
      layout_.channels.push_back({.offset = layout_.record_size, .type = channel.type});
      layout_.record_size += static_cast<std::uint32_t>(size_of(channel.type));
      add_property(channel);
    }
    const Field& field = layout_.channels[at];
    const double scale = is_colour(channel.name) ? range_of(field.type) / range_of(channel.type) : 1;
    channels_.push_back({column, field, scale});
  }

  // Adds a line after the last property of the element vertex.
  void add_property(const Channel& channel) {
    std::size_t at = header_.find("\nelement vertex") + 1;
    for (;;) {
      const std::size_t next = header_.find('\n', at) + 1;
      const std::string_view line = std::string_view(header_).substr(next);
      at = next;
      if (line.starts_with("element") || line.starts_with("end_header")) break;
    }
    header_.insert(at, fmt::format("property {} {}\n", name_of(channel.type), channel.name));
  }

  Layout layout_;
  std::string header_;
  std::vector<WrittenChannel> channels_;
  std::optional<LasHeader> las_;
};

class Transfer {
 public:
  Transfer(const Sampling& sampling, const Neighbours& neighbours, const OutputLayout& out, const std::string& file)
      : sampling_(sampling), neighbours_(neighbours), out_(out), file_(file) {}

  // Writes the edited points of some records, which are copies of those of the input.
  void apply(const Points& points, std::span<char> records) const {
    std::vector<double> positions(points.positions.begin(), points.positions.end());
    std::vector<float> normals(points.normals.begin(), points.normals.end());
    std::vector<double> values(out_.channels().size() * points.size());
    std::vector<Neighbour> near;
    for (std::size_t i = 0; i < points.size(); ++i) {
      Vector3f p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<float>(positions[3 * i + k] - sampling_.origin[k]);
      if (!std::isfinite(p.x + p.y + p.z)) continue;  // stays as it is
      neighbours_.find(p, near);
      interpolate(near, &values[out_.channels().size() * i]);
      if (!sampling_.is_deformed) continue;
      const Vector3f normal = normals.empty() ? Vector3f{} : common::vector_at(std::span<const float>(normals), i);
      const Deformed moved = deform(sampling_, p, normal, near);
      for (std::size_t k = 0; k < 3; ++k) {
        positions[3 * i + k] += static_cast<double>(moved.position[k]) - static_cast<double>(p[k]);
        if (!normals.empty()) normals[3 * i + k] = moved.normal[k];
      }
    }
    const Layout& layout = out_.layout();
    if (sampling_.is_deformed) encode(layout, file_, points.first, positions, normals, records);
    write_channels(values, records);
  }

 private:
  // Source: Boubekeur 2007, ch. 4.4.1.
  void interpolate(std::span<const Neighbour> near, double* values) const {
    const std::size_t width = sampling_.channels.size();
    for (const WrittenChannel& channel : out_.channels()) {
      double sum = 0, weights = 0;
      for (const Neighbour& neighbour : near) {
        sum += static_cast<double>(neighbour.weight * sampling_.values[width * neighbour.index + channel.column]);
        weights += static_cast<double>(neighbour.weight);
      }
      *values++ = channel.scale * sum / weights;
    }
  }

  void write_channels(const std::vector<double>& values, std::span<char> records) const {
    const Layout& layout = out_.layout();
    const std::size_t width = out_.channels().size();
    const Column column{layout.record_size, records.size() / layout.record_size, layout.swapped};
    for (std::size_t k = 0; k < width && layout.points_per_record == 1; ++k)
      write_column(out_.channels()[k].field, column, records.data(), &values[k], width);
  }

  const Sampling& sampling_;
  const Neighbours& neighbours_;
  const OutputLayout& out_;
  const std::string& file_;
};

// The box of what is written, for the header.
class Bounds {
 public:
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  void add(const PointArrays& points) {
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], points.positions[i]);
      high[i % 3] = std::max(high[i % 3], points.positions[i]);
    }
  }
};

void copy_rest(const SourceFile& file, std::uint64_t begin, WriterFile& output) {
  std::string bytes;
  for (; begin < file.size(); begin += bytes.size()) {
    bytes.resize(static_cast<std::size_t>(std::min<std::uint64_t>(1 << 20, file.size() - begin)));
    file.read(begin, bytes);
    output.add(bytes);
  }
}

}  // namespace

TransferReport transfer(const std::filesystem::path& large, const std::filesystem::path& from,
                        const std::filesystem::path& to, const std::filesystem::path& output,
                        const TransferOptions& options) {
  check(options);
  const SourceFile file(large);
  const FileState before = file.state();
  const std::string format = format_of(large, "");
  const std::optional<Layout> layout = layout_of(file, format);
  if (!layout || is_compressed(large))
    throw Error(Element::file, 0,
                large.string() +
                    ": is text or compressed, and an edit is transferred to binary files; convert it to "
                    "binary PLY first");
  const Sampling sampling = read_sampling(from, to, options.threads);
  const Neighbours neighbours(sampling, options.neighbours, options.singular);
  OutputLayout out(file, *layout, format, sampling);
  const Transfer edit(sampling, neighbours, out, output.string());
  const common::Workers workers(options.threads);
  WriterFile written({output, {}, 0, {}});
  written.add(out.header());
  Bounds bounds;
  const std::size_t size = layout->record_size, size_out = out.layout().record_size;
  std::vector<char> records(batch_size * size), edited(batch_size * size_out);
  for (std::uint64_t done = 0; done < layout->records;) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(batch_size, layout->records - done));
    file.read(layout->begin + done * size, std::span(records).first(count * size));
    workers.in_pieces(count, piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) std::copy_n(&records[i * size], size, &edited[i * size_out]);
      PointArrays points;
      decode(*layout, &records[begin * size], end - begin, {.channels = false}, points);
      edit.apply(points.points((done + begin) * layout->points_per_record),
                 std::span(edited).subspan(begin * size_out, (end - begin) * size_out));
    });
    if (format == ".las") {
      PointArrays points;
      decode(out.layout(), edited.data(), count, {.normals = false, .channels = false}, points);
      bounds.add(points);
    }
    written.add({edited.data(), count * size_out});
    done += count;
    if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(layout->records));
  }
  copy_rest(file, layout->begin + layout->size(), written);
  file.require_unchanged(before);
  written.finish(layout->records > 0 ? out.final_header(bounds.low, bounds.high) : "");
  TransferReport report{layout->points(), sampling.is_deformed, {}};
  for (const Channel& channel : sampling.channels) report.channels.push_back(channel.name);
  return report;
}

}  // namespace glark::stream
