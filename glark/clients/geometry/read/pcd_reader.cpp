// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/pcd_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "glark/clients/geometry/parse/ply_values.h"
#include "glark/clients/geometry/read/points/point_builder.h"
#include "glark/clients/geometry/read/points/point_counter.h"

namespace glark::geometry {
namespace {

using ply::Element;
using ply::Encoding;
using ply::Type;

constexpr std::uint64_t most_values = 1024;  // of a point; descriptors have hundreds

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    words.emplace_back(line.substr(0, line.find_first_of(" \t\r")));
    line.remove_prefix(words.back().size());
  }
}

struct Header {
  Element points{"point", 0, {}};
  Encoding encoding = Encoding::text;
};

class HeaderReader {
 public:
  explicit HeaderReader(Input& input) : input_(input) {}

  Header read() {
    std::string_view line;
    while (lines_.count("DATA") == 0) {
      if (!input_.line(line)) fail("it ends without a line DATA", "it is cut off, get it again");
      std::vector<std::string> words = words_of(line);
      if (words.empty() || words[0].starts_with('#')) continue;
      const std::string key = words[0];
      words.erase(words.begin());
      lines_[key] = std::move(words);
    }
    Header header;
    header.encoding = encoding();
    header.points.count = point_count();
    add_fields(header.points);
    return header;
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const char* remedy) const {
    throw Error(fmt::format("{}: PCD header: {}; {}", input_.name(), problem, remedy));
  }

  const std::vector<std::string>& values(const std::string& key) const {
    const auto found = lines_.find(key);
    if (found == lines_.end() || found->second.empty())
      fail("there is no line " + key, "check the format or export it again");
    return found->second;
  }

  std::uint64_t number(const std::string& word) const {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size())
      fail("\"" + word.substr(0, 40) + "\" is not a number", "repair the file or export it again");
    return number;
  }

  Encoding encoding() const {
    const std::string& data = values("DATA")[0];
    if (data == "ascii") return Encoding::text;
    if (data != "binary")
      fail("its DATA is " + data + ", which glark does not read",
           "convert it: pcl_convert_pcd_ascii_binary FILE OUT 1");
    return Encoding::little_endian;
  }

  std::uint64_t point_count() const {
    if (lines_.count("POINTS") > 0) return number(values("POINTS")[0]);
    const std::uint64_t width = number(values("WIDTH")[0]);
    const std::uint64_t height = lines_.count("HEIGHT") > 0 ? number(values("HEIGHT")[0]) : 1;
    if (height != 0 && width > UINT64_MAX / height) fail("WIDTH times HEIGHT is too large", "export it again");
    return width * height;
  }

  Type type_of(const std::string& field, const std::string& kind, std::uint64_t size) const {
    static const std::map<std::string, Type> types = {{"F4", Type::float32}, {"F8", Type::float64}, {"U1", Type::uint8},
                                                      {"U2", Type::uint16},  {"U4", Type::uint32},  {"I1", Type::int8},
                                                      {"I2", Type::int16},   {"I4", Type::int32}};
    const auto found = types.find(kind + std::to_string(size));
    if (found == types.end())
      fail(fmt::format("the field {} has the type {} of {} bytes, which glark does not read", field, kind, size),
           "export the file without it");
    return found->second;
  }

  void add_fields(Element& points) const {
    const std::vector<std::string>& names = values("FIELDS");
    const std::vector<std::string>& sizes = values("SIZE");
    const std::vector<std::string>& kinds = values("TYPE");
    const std::vector<std::string> once(names.size(), "1");
    const std::vector<std::string>& counts = lines_.count("COUNT") > 0 ? values("COUNT") : once;
    if (sizes.size() != names.size() || kinds.size() != names.size() || counts.size() != names.size())
      fail("FIELDS, SIZE, TYPE and COUNT have different lengths", "repair the file or export it again");
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::uint64_t count = number(counts[i]);
      if (count > most_values || points.properties.size() + count > most_values)
        fail(fmt::format("a point has more than {} values", most_values), "export it with fewer fields");
      for (std::uint64_t k = 0; k < count; ++k)
        points.properties.push_back({k == 0 ? names[i] : "_", type_of(names[i], kinds[i], number(sizes[i])), {}});
    }
  }

  Input& input_;
  std::map<std::string, std::vector<std::string>> lines_;
};

// A packed colour, 0xAARRGGBB. A float has it as its bits. A number that is no colour is black.
std::array<float, 4> unpacked(double value, Type type, bool has_alpha) {
  const bool is_colour = value >= -2147483648.0 && value <= 4294967295.0;
  const std::int64_t whole = is_colour ? static_cast<std::int64_t>(value) : 0;
  const auto bits = type == Type::float32 ? std::bit_cast<std::uint32_t>(static_cast<float>(value))
                                          : static_cast<std::uint32_t>(whole);
  const auto byte = [bits](unsigned shift) { return static_cast<float>((bits >> shift) & 0xffU); };
  return {byte(16), byte(8), byte(0), has_alpha ? byte(24) : opaque};
}

class Points {
 public:
  Points(const std::string& file, const Element& points) : points_(points) {
    for (const char* name : {"x", "y", "z"}) {
      position_.push_back(column(name));
      if (!position_.back())
        throw Error(
            fmt::format("{}: PCD header: there is no field {}; points need x, y and z, export it again", file, name));
    }
    for (const char* name : {"normal_x", "normal_y", "normal_z"}) normal_.push_back(column(name));
    attributes_.normals = normal_[0] && normal_[1] && normal_[2];
    has_alpha_ = column("rgba").has_value();
    colour_ = has_alpha_ ? column("rgba") : column("rgb");
    attributes_.colours = colour_.has_value();
  }

  const Attributes& attributes() const { return attributes_; }

  std::string unread() const {
    std::string names;
    for (std::size_t i = 0; i < points_.properties.size(); ++i)
      if (points_.properties[i].name != "_" && !is_read(i))
        names += (names.empty() ? "" : ", ") + points_.properties[i].name;
    return names;
  }

  void add(const std::vector<double>& values, PointSink& sink) const {
    Point point;
    bool needs_double = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position[axis] = values[*position_[axis]];
      needs_double |= points_.properties[*position_[axis]].type == Type::float64;
      if (attributes_.normals) point.normal[axis] = static_cast<float>(values[*normal_[axis]]);
    }
    if (colour_) point.colour = unpacked(values[*colour_], points_.properties[*colour_].type, has_alpha_);
    sink.add_point(point, needs_double);
  }

 private:
  std::optional<std::size_t> column(std::string_view name) const {
    for (std::size_t i = 0; i < points_.properties.size(); ++i)
      if (points_.properties[i].name == name) return i;
    return {};
  }

  bool is_read(std::size_t column) const {
    return std::count(position_.begin(), position_.end(), column) > 0 || colour_ == column ||
           (attributes_.normals && std::count(normal_.begin(), normal_.end(), column) > 0);
  }

  const Element& points_;
  std::vector<std::optional<std::size_t>> position_;
  std::vector<std::optional<std::size_t>> normal_;
  std::optional<std::size_t> colour_;
  bool has_alpha_ = false;
  Attributes attributes_;
};

// Returns whether more than blanks or zeros is left. The Point Cloud Library fills binary files up with zeros.
bool has_more(Input& input, Encoding encoding) {
  if (encoding == Encoding::text) return !input.word().empty();
  constexpr std::size_t block_size = std::size_t{1} << 16;
  for (std::span<const char> block = input.take(block_size); !block.empty(); block = input.take(block_size))
    if (std::any_of(block.begin(), block.end(), [](char byte) { return byte != 0; })) return true;
  return false;
}

// Sink: PointBuilder or PointCounter.
template <class Sink>
typename Sink::Result read_points(Input& input, const ReadOptions& options) {
  const Header header = HeaderReader(input).read();
  const Points points(input.name(), header.points);
  Sink sink(input.name(), "point", points.attributes(), options);
  const std::optional<std::uint64_t> left = input.remaining();
  const std::uint64_t least = header.points.least_size(header.encoding);
  if (left && (least == 0 || header.points.count > (*left + 1) / least))
    throw Error(
        fmt::format("{}: PCD header: it announces {} points, for which the file is too short; it is cut off, get "
                    "it again",
                    input.name(), header.points.count));
  sink.expect(header.points.count, 0);
  if (const std::string unread = points.unread(); !unread.empty()) sink.warn("fields that are not kept: " + unread);
  ply::Values values(input, header.encoding);
  std::vector<double> row(header.points.properties.size());
  for (std::uint64_t i = 0; i < header.points.count; ++i) {
    values.at(header.points, i);
    values.record(row);
    points.add(row, sink);
  }
  if (has_more(input, header.encoding))
    sink.warn("something follows the last point; the header may announce too little");
  return sink.finish();
}

}  // namespace

Reading read_pcd(Input& input, const ReadOptions& options) { return read_points<PointBuilder>(input, options); }

Summary summarise_pcd(Input& input, const ReadOptions& options) { return read_points<PointCounter>(input, options); }

}  // namespace glark::geometry
