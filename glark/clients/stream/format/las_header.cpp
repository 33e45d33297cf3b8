// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/format/las_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace glark::stream {
namespace {

constexpr std::array<std::uint16_t, 11> record_sizes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr std::uint16_t size_of_12 = 227, size_of_14 = 375;

template <class Value>
Value value_at(std::span<const char> bytes, std::size_t offset) {
  Value value;
  std::memcpy(&value, &bytes[offset], sizeof(Value));
  return value;
}
template <class Value>
void put(std::span<char> bytes, std::size_t offset, Value value) {
  std::memcpy(&bytes[offset], &value, sizeof(Value));
}

[[noreturn]] void fail(const std::string& file, const std::string& problem) {
  throw Error(Element::file, 0, file + ": LAS header: " + problem);
}

void check(const LasHeader& header, std::uint64_t size) {
  const std::string& file = header.file;
  if (header.point_format >= record_sizes.size())
    fail(file, fmt::format("point format {}; 0 to 10 are known, convert the file", header.point_format));
  if (header.record_size < record_sizes[header.point_format])
    fail(file, fmt::format("records of {} bytes are too short for point format {} ({}); get the file again",
                           header.record_size, header.point_format, record_sizes[header.point_format]));
  if (header.points_begin < header.header_size || header.points_begin > size)
    fail(file, fmt::format("the points begin at byte {}, which is in the header or after the end; get the file again",
                           header.points_begin));
  if (header.points > (size - header.points_begin) / header.record_size)
    fail(file, fmt::format("it announces {} points, for which the file is too short ({} bytes); it is cut off, get it "
                           "again",
                           header.points, size));
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(header.scale[axis] > 0) || !std::isfinite(header.scale[axis]) || !std::isfinite(header.offset[axis]))
      fail(file, fmt::format("the scale {} or the offset {} of an axis is no size; get the file again",
                             header.scale[axis], header.offset[axis]));
}

// Adds fields of a record, one after the other.
class Fields {
 public:
  explicit Fields(Layout& layout) : layout_(layout) {}
  void add(const char* name, Number type, std::uint32_t offset, std::uint8_t mask = 0xFF) {
    layout_.channels.push_back({.offset = offset, .type = type, .mask = mask});
    layout_.schema.channels.push_back({name, type});
  }
  void add_colour(std::uint32_t offset) {
    for (const char* name : {"red", "green", "blue"}) {
      add(name, Number::uint16, offset);
      offset += 2;
    }
  }

 private:
  Layout& layout_;
};

}  // namespace

LasHeader parse_las_header(const std::string& file, std::span<const char> bytes, std::uint64_t size) {
  if (bytes.size() >= 8 && std::string_view(bytes.data(), 8) == "ASTM-E57")
    throw Error(Element::file, 0, file + ": is an E57 file, which no library of Debian reads; convert it to LAS first");
  if (bytes.size() < 4 || std::string_view(bytes.data(), 4) != "LASF")
    throw Error(Element::file, 0,
                file +
                    ": is not a LAS file: it does not begin with \"LASF\"; check the format, or give the file the "
                    "ending it should have");
  if (bytes.size() < size_of_12) fail(file, "the file ends within it; it is cut off, get it again");
  LasHeader header;
  header.file = file;
  const auto major = value_at<std::uint8_t>(bytes, 24);
  header.minor = value_at<std::uint8_t>(bytes, 25);
  if (major != 1 || header.minor > 4)
    fail(file, fmt::format("version {}.{}; 1.0 to 1.4 are known, convert the file", major, header.minor));
  header.header_size = value_at<std::uint16_t>(bytes, 94);
  header.points_begin = value_at<std::uint32_t>(bytes, 96);
  const auto format = value_at<std::uint8_t>(bytes, 104);
  if ((format & 0xC0U) != 0)
    fail(file,
         "the points are compressed (LAZ), and no library of Debian reads them; decompress the file first: laszip "
         "-i scan.laz -o scan.las, or pdal translate");
  header.point_format = format;
  header.record_size = value_at<std::uint16_t>(bytes, 105);
  header.points = value_at<std::uint32_t>(bytes, 107);
  const std::uint16_t needed = header.minor == 4 ? size_of_14 : size_of_12;
  if (header.header_size < needed || bytes.size() < needed)
    fail(file, fmt::format("it has {} bytes; version 1.{} has {}, get the file again", header.header_size, header.minor,
                           needed));
  // Version 1.4 has two counts. The one with 32 bits is for programs that read earlier versions; it is 0 where they cannot
  // read the file.
  if (const auto points = header.minor == 4 ? value_at<std::uint64_t>(bytes, 247) : 0; points != 0)
    header.points = points;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scale[axis] = value_at<double>(bytes, 131 + 8 * axis);
    header.offset[axis] = value_at<double>(bytes, 155 + 8 * axis);
    header.greatest[axis] = value_at<double>(bytes, 179 + 16 * axis);
    header.least[axis] = value_at<double>(bytes, 187 + 16 * axis);
  }
  check(header, size);
  return header;
}

LasHeader read_las_header(const SourceFile& file) {
  std::array<char, longest_las_header> bytes{};
  const std::size_t have = std::min<std::uint64_t>(bytes.size(), file.size());
  file.read(0, std::span(bytes).first(have));
  return parse_las_header(file.name(), std::span(bytes).first(have), file.size());
}

void read_byte_colours(const SourceFile& file, Layout& layout) {
  constexpr std::uint64_t blocks = 32, block = 512;
  const std::size_t red = channel_index(layout.schema, "red");
  if (red == none || layout.records == 0) return;
  std::vector<char> records;
  std::uint16_t greatest = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const std::uint64_t first = layout.records / blocks * i;
    const std::uint64_t count = std::min(block, layout.records - first);
    records.resize(static_cast<std::size_t>(count * layout.record_size));
    file.read(layout.begin + first * layout.record_size, records);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t channel = red; channel < red + 3; ++channel)
        greatest = std::max(greatest,
                            value_at<std::uint16_t>(records, k * layout.record_size + layout.channels[channel].offset));
  }
  if (greatest == 0 || greatest > 255) return;
  for (std::size_t channel = red; channel < red + 3; ++channel) layout.schema.channels[channel].type = Number::uint8;
}

Layout las_layout(const LasHeader& header) {
  Layout layout;
  layout.element = "point";
  layout.begin = header.points_begin;
  layout.records = header.points;
  layout.record_size = layout.point_size = header.record_size;
  layout.schema.position = Number::float64;
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    layout.position[axis] = {
        .offset = 4 * axis, .type = Number::int32, .scale = header.scale[axis], .shift = header.offset[axis]};
  Fields fields(layout);
  const unsigned format = header.point_format;
  fields.add("intensity", Number::uint16, 12);
  if (format < 6) {
    fields.add("classification", Number::uint8, 15, 0x1F);  // the other bits are flags
    fields.add("scan_angle", Number::int8, 16);
    fields.add("user_data", Number::uint8, 17);
    fields.add("point_source", Number::uint16, 18);
    const bool has_time = format != 0 && format != 2;
    if (has_time) fields.add("gps_time", Number::float64, 20);
    if (format == 2 || format == 3 || format == 5) fields.add_colour(has_time ? 28 : 20);
    return layout;
  }
  fields.add("classification", Number::uint8, 16);
  fields.add("user_data", Number::uint8, 17);
  fields.add("scan_angle", Number::int16, 18);
  fields.add("point_source", Number::uint16, 20);
  fields.add("gps_time", Number::float64, 22);
  if (format == 7 || format == 8 || format == 10) fields.add_colour(30);
  if (format == 8 || format == 10) fields.add("near_infrared", Number::uint16, 36);
  return layout;
}

unsigned las_format_for(const Schema& schema) {
  if (channel_index(schema, "gps_time") != none) return 7;
  return channel_index(schema, "red") != none ? 2 : 0;
}

std::vector<char> las_header_bytes(const LasHeader& header) {
  const bool is_new = header.point_format >= 6;
  std::vector<char> bytes(is_new ? size_of_14 : size_of_12);
  const std::span<char> all(bytes);
  std::memcpy(bytes.data(), "LASF", 4);
  put<std::uint16_t>(all, 6, is_new ? 0x10 : 0);  // bit 4: a coordinate system, if there is one, is WKT
  put<std::uint8_t>(all, 24, 1);
  put<std::uint8_t>(all, 25, is_new ? 4 : 2);
  std::memcpy(&bytes[58], "glark", 5);
  put<std::uint16_t>(all, 94, static_cast<std::uint16_t>(bytes.size()));
  put<std::uint32_t>(all, 96, static_cast<std::uint32_t>(bytes.size()));
  put<std::uint8_t>(all, 104, static_cast<std::uint8_t>(header.point_format));
  put<std::uint16_t>(all, 105, record_sizes[header.point_format]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put<double>(all, 131 + 8 * axis, header.scale[axis]);
    put<double>(all, 155 + 8 * axis, header.offset[axis]);
  }
  return bytes;
}

void patch_las_header(const LasHeader& header, std::span<char> bytes) {
  const bool has_legacy_count = header.points <= std::numeric_limits<std::uint32_t>::max() && header.point_format < 6;
  put<std::uint32_t>(bytes, 107, has_legacy_count ? static_cast<std::uint32_t>(header.points) : 0);
  if (bytes.size() >= size_of_14 && bytes[25] == 4) put<std::uint64_t>(bytes, 247, header.points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put<double>(bytes, 179 + 16 * axis, header.greatest[axis]);
    put<double>(bytes, 187 + 16 * axis, header.least[axis]);
  }
}

}  // namespace glark::stream
