// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/output_layout.h"

#include <fmt/format.h>

namespace glark::stream {
namespace {

double range_of(Number type) { return type == Number::uint8 ? 255 : type == Number::uint16 ? 65535 : 1; }

bool is_colour(const std::string& name) {
  return name == "red" || name == "green" || name == "blue" || name == "alpha";
}

}  // namespace

OutputLayout::OutputLayout(const SourceFile& file, const Layout& from, const std::string& format,
                           const std::vector<Channel>& channels)
    : layout_(from), header_(static_cast<std::size_t>(from.begin), '\0') {
  file.read(0, header_);
  for (std::size_t k = 0; k < channels.size(); ++k) add(file, format, channels[k], k);
  if (format == ".las") las_ = read_las_header(file);
}

std::string OutputLayout::final_header(const std::array<double, 3>& low, const std::array<double, 3>& high) {
  if (!las_) return header_;
  las_->least = low;
  las_->greatest = high;
  patch_las_header(*las_, header_);
  return header_;
}

void OutputLayout::add(const SourceFile& file, const std::string& format, const Channel& channel, std::size_t column) {
  std::size_t at = channel_index(layout_.schema, channel.name);
  if (at == none) {
    if (format != ".ply")
      throw Error(Element::file, 0,
                  fmt::format("{}: its records have no {}, which the edited sampling has; convert the file to PLY, or "
                              "remove the channel from the sampling",
                              file.name(), channel.name));
    at = layout_.channels.size();
    layout_.schema.channels.push_back(channel);
    layout_.channels.push_back({.offset = layout_.record_size, .type = channel.type});
    layout_.record_size += static_cast<std::uint32_t>(size_of(channel.type));
    layout_.point_size = layout_.record_size;
    add_property(channel);
  }
  const Field& field = layout_.channels[at];
  const double scale =
      is_colour(channel.name) ? range_of(layout_.schema.channels[at].type) / range_of(channel.type) : 1;
  channels_.push_back({column, field, scale});
}

// Adds a line after the last property of the element vertex.
void OutputLayout::add_property(const Channel& channel) {
  std::size_t at = header_.find("\nelement vertex") + 1;
  for (;;) {
    const std::size_t next = header_.find('\n', at) + 1;
    const std::string_view line = std::string_view(header_).substr(next);
    at = next;
    if (line.starts_with("element") || line.starts_with("end_header")) break;
  }
  header_.insert(at, fmt::format("property {} {}\n", name_of(channel.type), channel.name));
}

}  // namespace glark::stream
