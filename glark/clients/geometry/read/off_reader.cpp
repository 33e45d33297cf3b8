// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/off_reader.h"

#include <fmt/format.h>

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glark/clients/geometry/measure/topology.h"
#include "glark/clients/geometry/read/points/point_builder.h"

namespace glark::geometry {
namespace {

constexpr std::size_t most_numbers = 3 + 1 + 3 + 4 + 2;  // of a vertex

bool is_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

// The words of a line.
class Words {
 public:
  explicit Words(std::string_view line) : next_(line.data()), end_(line.data() + line.size()) { skip_space(); }

  bool empty() const { return next_ == end_; }
  // Returns the first word without removing it.
  std::string_view first() const {
    return {next_, static_cast<std::size_t>(std::find_if(next_, end_, is_space) - next_)};
  }
  // Removes letters, and the space after them.
  void remove(std::size_t letters) {
    next_ += letters;
    skip_space();
  }

  std::size_t count() const {
    std::size_t count = 0;
    for (Words rest = *this; !rest.empty(); rest.remove(rest.first().size())) ++count;
    return count;
  }

  // Removes a number, or returns nothing if the first word is none. A number beyond a double becomes infinite.
  std::optional<double> number() {
    double value = 0;
    const char* const begin = next_ < end_ && *next_ == '+' ? next_ + 1 : next_;
    const auto [after, error] = fast_float::from_chars(begin, end_, value);
    if (error == std::errc::result_out_of_range)
      value = std::numeric_limits<double>::infinity();
    else if (error != std::errc())
      return {};
    return went_to(after) ? std::optional(value) : std::nullopt;
  }

  // Removes a whole number, or returns nothing if the first word is none.
  std::optional<std::uint64_t> whole_number() {
    std::uint64_t value = 0;
    const auto [after, error] = std::from_chars(next_, end_, value);
    return error == std::errc() && went_to(after) ? std::optional(value) : std::nullopt;
  }

 private:
  bool went_to(const char* after) {
    if (after != end_ && !is_space(*after)) return false;
    next_ = after;
    skip_space();
    return true;
  }
  void skip_space() {
    while (next_ < end_ && is_space(*next_)) ++next_;
  }

  const char* next_;
  const char* end_;
};

// What the first lines announce.
struct OffHeader {
  bool texture_coordinates = false, colours = false, normals = false;
  bool is_homogeneous = false;  // a fourth coordinate divides the others
  bool has_dimension = false;
  std::uint64_t dimension = 3;
  std::uint64_t points = 0, faces = 0;
  bool ends_alone = false;  // the number of faces is the only one in its line
};

bool remove_prefix(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

class OffReader {
 public:
  OffReader(Input& input, const ReadOptions& options) : input_(input), options_(options) {}

  Reading read() {
    read_header();
    read_points();
    for (std::uint64_t face = 0; face < header_.faces; ++face) read_face(face);
    if (has_more_numbers_) sink_->warn("the vertices have more numbers than the header announces; these are not kept");
    if (has_face_colours_) sink_->warn("the colours of the faces are not kept");
    if (next_line()) sink_->warn("something follows the last face; the header may announce too little");
    Reading reading = sink_->finish();
    if (!reading.geometry.triangles.empty() && !options_.all_points) join_identical_points(reading.geometry);
    return reading;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(input_.name() + ": OFF " + what); }

  // Returns the words of the next line that is more than a comment, or nothing at the end of the file. They are valid
  // until the next call.
  std::optional<Words> next_line() {
    std::string_view line;
    while (input_.line(line)) {
      if (const auto* comment = static_cast<const char*>(std::memchr(line.data(), '#', line.size())))
        line = line.substr(0, static_cast<std::size_t>(comment - line.data()));
      if (const Words words(line); !words.empty()) return words;
    }
    return {};
  }

  void read_header() {
    std::optional<Words> words = next_line();
    if (words) read_keyword(*words);
    if (header_.has_dimension) header_.dimension = count(words);
    header_.points = count(words);
    header_.faces = count(words);
    if (header_.dimension < 1 || header_.dimension > 3)
      fail(
          fmt::format("header: the points have {} coordinates, glark reads 1 to 3; export them so", header_.dimension));
    if (header_.points == 0) throw Error(input_.name() + ": it has no points; export it again");
    const double least = 2.0 * static_cast<double>(header_.points) *
                         static_cast<double>(header_.dimension);             // bytes: "0 0 0" and its end
    const double least_of_faces = 2.0 * static_cast<double>(header_.faces);  // bytes: "0" and its end
    if (const std::optional<std::uint64_t> left = input_.remaining();
        left && std::max(least, least_of_faces) > static_cast<double>(*left) + 1)
      fail(
          fmt::format("header: it announces {} points and {} faces, for which the file is too short; it is cut off or "
                      "its header wrong, get it again",
                      header_.points, header_.faces));
  }

  // Removes the keyword, which may be missing. In some files, a number follows it without a space.
  void read_keyword(Words& words) {
    std::string_view word = words.first();
    if (remove_prefix(word, "\xEF\xBB\xBF")) words.remove(3);  // the byte order mark
    header_.texture_coordinates = remove_prefix(word, "ST");
    header_.colours = remove_prefix(word, "C");
    header_.normals = remove_prefix(word, "N");
    header_.is_homogeneous = remove_prefix(word, "4");
    header_.has_dimension = remove_prefix(word, "n");
    if (!remove_prefix(word, "OFF") && !remove_prefix(word, "off")) {
      header_ = {};
      word = words.first();
    }
    if (!word.empty() && (word[0] < '0' || word[0] > '9'))
      throw Error(fmt::format("{}: is not a valid OFF file: it begins with \"{}\"; check the format or export it again",
                              input_.name(), words.first().substr(0, 40)));
    words.remove(words.first().size() - word.size());
    if (words.first() == "BINARY")
      throw Error(input_.name() + ": is a binary OFF file, which glark does not read; export it as text");
  }

  // Removes a number of the header. It may be in one of the next lines.
  std::uint64_t count(std::optional<Words>& words) {
    while (words && words->empty()) {
      words = next_line();
      if (words) header_.ends_alone = words->count() == 1;
    }
    if (!words) fail("header: the file ends here; it is cut off, get it again");
    const std::optional<std::uint64_t> number = words->whole_number();
    if (!number)
      fail(fmt::format("header: \"{}\" is not a count; export the file again", words->first().substr(0, 40)));
    return *number;
  }

  void read_points() {
    std::optional<Words> words = next_line();
    // The number of edges may be in a line of its own. It is not needed.
    if (words && header_.ends_alone && header_.dimension > 1 && words->count() == 1) words = next_line();
    if (words) choose_columns(words->count());
    const Attributes attributes{header_.normals, colour_width_ >= 3, header_.texture_coordinates};
    sink_.emplace(input_.name(), "vertex", attributes, options_, ColourRange::by_greatest);
    sink_->expect(header_.points, header_.faces);
    for (std::uint64_t i = 0; i < header_.points; ++i, words = next_line()) {
      if (!words)
        fail(fmt::format("vertex {}: the file ends here, its header announces {} points; it is cut off, get it again",
                         i, header_.points));
      read_point(*words, i);
      if (i + 1 == header_.points) break;
    }
  }

  // Decides by the first vertex how many numbers a colour has.
  void choose_columns(std::size_t numbers) {
    const std::size_t others = header_.dimension + (header_.is_homogeneous ? 1 : 0) + (header_.normals ? 3 : 0) +
                               (header_.texture_coordinates ? 2 : 0);
    if (header_.colours && numbers > others) colour_width_ = std::min<std::size_t>(numbers - others, 4);
    width_ = others + colour_width_;
  }

  void read_point(Words& words, std::uint64_t index) {
    std::array<double, most_numbers> numbers{};
    for (std::size_t i = 0; i < width_; ++i) {
      if (words.empty())
        fail(fmt::format("vertex {}: its line has {} numbers, {} are due; the file is damaged, get it again", index, i,
                         width_));
      const std::optional<double> number = words.number();
      if (!number)
        fail(fmt::format("vertex {}: \"{}\" is not a number; the file is damaged, get it again", index,
                         words.first().substr(0, 40)));
      numbers[i] = *number;
    }
    has_more_numbers_ |= !words.empty();
    sink_->add_point(point_of(numbers), true);
  }

  Point point_of(const std::array<double, most_numbers>& numbers) const {
    Point point;
    std::size_t next = header_.dimension;
    std::copy_n(numbers.begin(), next, point.position.begin());
    if (header_.is_homogeneous) {
      for (double& coordinate : point.position) coordinate /= numbers[next];
      ++next;
    }
    const auto take = [&](auto& values, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(numbers[next++]);
    };
    if (header_.normals) take(point.normal, 3);
    take(point.colour, colour_width_ >= 3 ? colour_width_ : 0);
    if (header_.texture_coordinates) {
      next = width_ - 2;
      take(point.texture_coordinate, 2);
    }
    return point;
  }

  void read_face(std::uint64_t face) {
    std::optional<Words> words = next_line();
    if (!words)
      fail(fmt::format("face {}: the file ends here, its header announces {} faces; it is cut off, get it again", face,
                       header_.faces));
    const std::optional<std::uint64_t> count = words->whole_number();
    if (!count) fail_at_index(face, *words, "is no number of corners");
    corners_.clear();
    while (corners_.size() < *count) {
      if (words->empty())
        fail(fmt::format("face {}: it announces {} corners, its line has {}; the file is damaged, get it again", face,
                         *count, corners_.size()));
      const std::optional<std::uint64_t> corner = words->whole_number();
      if (!corner) fail_at_index(face, *words, "is no index of a point");
      if (*corner >= header_.points)
        fail(fmt::format(
            "face {}: it has the corner {}, but there are only {} points; the file is damaged, get it again", face,
            *corner, header_.points));
      corners_.push_back(static_cast<std::int64_t>(*corner));
    }
    has_face_colours_ |= !words->empty();
    sink_->add_polygon(corners_);
  }

  [[noreturn]] void fail_at_index(std::uint64_t face, const Words& words, const char* what) const {
    fail(fmt::format("face {}: \"{}\" {}; export the file again", face, words.first().substr(0, 40), what));
  }

  Input& input_;
  const ReadOptions& options_;
  OffHeader header_;
  std::size_t colour_width_ = 0;  // numbers of a colour; it is only read if there are three or four
  std::size_t width_ = 0;         // numbers of a vertex
  std::optional<PointBuilder> sink_;
  std::vector<std::int64_t> corners_;
  bool has_more_numbers_ = false, has_face_colours_ = false;
};

}  // namespace

Reading read_off(Input& input, const ReadOptions& options) { return OffReader(input, options).read(); }

}  // namespace glark::geometry
