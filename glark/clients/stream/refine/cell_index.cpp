// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The index of a sampling is text: a line for the scan, a line for each cell, and a checksum of all these lines. Version 1
// had no checksum, and is still read.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>

#include "glark/clients/common/fnv.h"
#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/write/output_file.h"
#include "glark/clients/stream/refine/index_text.h"

namespace glark::stream {
namespace {

constexpr std::string_view first_words = "glark cells ", version_1 = "glark cells 1", version_2 = "glark cells 2";
constexpr std::string_view checksum_word = "checksum ";
constexpr std::size_t most_cells = std::size_t{1} << 24;

// The numbers of a line, one after the other.
class Words {
 public:
  Words(std::string_view line, const std::string& place) : line_(line), place_(place) {}

  template <class Number>
  Number next(const char* what) {
    while (line_.starts_with(' ')) line_.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(line_.data(), line_.data() + line_.size(), number);
    if (error != std::errc() || (end != line_.data() + line_.size() && *end != ' '))
      fail(fmt::format("\"{}\" is not the {}", line_.substr(0, 20), what));
    line_.remove_prefix(static_cast<std::size_t>(end - line_.data()));
    return number;
  }
  double finite(const char* what) {
    const auto number = next<double>(what);
    if (!std::isfinite(number)) fail(fmt::format("the {} is {}, which is not finite", what, number));
    return number;
  }
  double not_negative(const char* what) {
    const double number = finite(what);
    if (number < 0) fail(fmt::format("the {} is {}, which is below 0", what, number));
    return number;
  }
  bool at_end() const { return line_.find_first_not_of(' ') == std::string_view::npos; }
  void end() const {
    if (!at_end()) fail(fmt::format("\"{}\" is too much", line_));
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(Element::file, 0, place_ + ": " + problem + "; the index is damaged, sample the scan again");
  }

 private:
  std::string_view line_;
  const std::string& place_;
};

SampledCell parse_cell(Words words, const CellIndex& index) {
  SampledCell cell;
  for (double& coordinate : cell.corner) coordinate = words.finite("corner of a cell");
  cell.side = words.not_negative("side of a cell");
  cell.points = words.next<std::uint64_t>("number of points");
  cell.first = words.next<std::uint64_t>("first point");
  cell.last = words.next<std::uint64_t>("last point");
  cell.error = words.not_negative("error of a cell");
  words.end();
  if (cell.points == 0 || cell.first > cell.last || cell.last >= index.points ||
      cell.points > cell.last - cell.first + 1)
    words.fail(fmt::format("a cell has {} points from {} to {}, the scan has {}", cell.points, cell.first, cell.last,
                           index.points));
  return cell;
}

// Checks what only all cells together tell: they are cubes of one octree, and no point is in two of them.
class CellTotals {
 public:
  explicit CellTotals(std::uint64_t scan_points) : most_(scan_points) {}

  void add(const SampledCell& cell, const Words& words) {
    if (cell.side > 0 && side_ > 0 && !is_power_of_two(cell.side / side_))
      words.fail(
          fmt::format("the side of the cell is {}, which is no side in an octree with a cube of {}", cell.side, side_));
    if (cell.side > 0) side_ = cell.side;
    if (cell.points > most_ - points_)
      words.fail(
          fmt::format("the cells up to here have {} and {} points, the scan has {}", points_, cell.points, most_));
    points_ += cell.points;
  }

 private:
  static bool is_power_of_two(double ratio) {
    int exponent = 0;
    return std::frexp(ratio, &exponent) == 0.5;
  }

  std::uint64_t most_;
  std::uint64_t points_ = 0;
  double side_ = 0;  // of the last cell
};

std::string checksum_of(std::string_view text) {
  return fmt::format("{}{:016x}", checksum_word, common::add_to_fnv(common::fnv_of_nothing, text));
}

// The lines of a text, and where each one is, for messages.
class Lines {
 public:
  Lines(std::string_view text, const std::string& file) : text_(text), rest_(text), file_(file) {}

  std::string_view next() {
    place_ = fmt::format("{}: line {}", file_, ++number_);
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) Words(rest_, place_).fail("the file ends here");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }
  const std::string& place() const { return place_; }
  std::string_view rest() const { return rest_; }
  std::string_view read() const { return text_.substr(0, text_.size() - rest_.size()); }

 private:
  std::string_view text_, rest_;
  const std::string& file_;
  std::size_t number_ = 0;
  std::string place_;
};

void require_checksum(Lines& lines) {
  const std::string wanted = checksum_of(lines.read());
  const std::string_view line = lines.next();
  if (line != wanted)
    Words(line, lines.place())
        .fail(fmt::format("the line is \"{}\", the lines above give \"{}\"", line.substr(0, 40), wanted));
}

}  // namespace

std::string index_text(const CellIndex& index) {
  std::string text =
      fmt::format("{}\n{} {} {} {}\n", version_2, index.bytes, index.points, index.cells.size(), index.samples);
  for (const SampledCell& cell : index.cells)
    text += fmt::format("{} {} {} {} {} {} {} {}\n", cell.corner[0], cell.corner[1], cell.corner[2], cell.side,
                        cell.points, cell.first, cell.last, cell.error);
  text += checksum_of(text) + "\n";
  return text;
}

CellIndex parse_index(std::string_view text, const std::string& file) {
  CellIndex index;
  Lines lines(text, file);
  const std::string_view version = lines.next();
  if (version != version_1 && version != version_2)
    throw Error(Element::file, 0,
                file + ": does not begin with \"glark cells 2\"; name the .cells file that glark sample wrote");
  const std::string_view scan = lines.next();
  Words words(scan, lines.place());
  index.bytes = words.next<std::uint64_t>("size of the scan");
  index.points = words.next<std::uint64_t>("number of points");
  const auto cells = words.next<std::uint64_t>("number of cells");
  if (!words.at_end()) index.samples = words.next<std::uint64_t>("number of samples");  // early versions have none
  words.end();
  if (cells > most_cells) words.fail(fmt::format("{} cells are too many", cells));
  CellTotals totals(index.points);
  for (std::uint64_t i = 0; i < cells; ++i) {
    const std::string_view text_of_cell = lines.next();
    const Words line(text_of_cell, lines.place());
    index.cells.push_back(parse_cell(line, index));
    totals.add(index.cells.back(), line);
  }
  if (version == version_2) require_checksum(lines);
  if (!lines.rest().empty()) Words(lines.rest(), lines.place()).fail("lines follow the last one");
  return index;
}

void require_replaceable_index(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::none)
    throw Error(Element::file, 0,
                fmt::format("{}: cannot be written: {}; name the sampling otherwise", file.string(), error.message()));
  if (!std::filesystem::is_regular_file(status)) return;
  std::ifstream stream(file, std::ios::binary);
  std::string begin(first_words.size(), '\0');
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin == first_words) return;
  throw Error(Element::file, 0,
              file.string() +
                  ": the index of the sampling goes here, but the file is no index and would be lost; move it away, or "
                  "choose another name for the sampling");
}

void write_cells(const std::filesystem::path& file, const CellIndex& index) {
  require_replaceable_index(file);
  try {
    geometry::OutputFile output(file);
    output.write(index_text(index));
    output.commit();
  } catch (const std::runtime_error& error) {
    throw Error(Element::file, 0, error.what());
  }
}

CellIndex read_cells(const std::filesystem::path& file) {
  try {
    geometry::Input input = geometry::open_input(file);
    std::string text;
    for (std::string_view line; input.line(line);) {
      text += line;
      text += '\n';
    }
    return parse_index(text, file.string());
  } catch (const geometry::Error& error) {
    throw Error(Element::file, 0, error.what());
  }
}

}  // namespace glark::stream
