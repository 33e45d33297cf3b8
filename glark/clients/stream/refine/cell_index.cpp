// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The index of a sampling is text: a line for the scan, and a line for each cell.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/write/output_file.h"
#include "glark/clients/stream/refine/index_text.h"

namespace glark::stream {
namespace {

constexpr std::string_view first_words = "glark cells 1";
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
  void end() const {
    if (line_.find_first_not_of(' ') != std::string_view::npos) fail(fmt::format("\"{}\" is too much", line_));
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
  for (double& coordinate : cell.corner) coordinate = words.next<double>("corner of a cell");
  cell.side = words.next<double>("side of a cell");
  cell.points = words.next<std::uint64_t>("number of points");
  cell.first = words.next<std::uint64_t>("first point");
  cell.last = words.next<std::uint64_t>("last point");
  cell.error = words.next<double>("error of a cell");
  words.end();
  const double sum = cell.corner[0] + cell.corner[1] + cell.corner[2] + cell.error;
  if (!std::isfinite(sum) || !(cell.side >= 0) || !std::isfinite(cell.side))
    words.fail("the cube or the error of a cell is not finite");
  if (cell.first > cell.last || cell.last >= index.points || cell.points > cell.last - cell.first + 1)
    words.fail(fmt::format("a cell has {} points from {} to {}, the scan has {}", cell.points, cell.first, cell.last,
                           index.points));
  return cell;
}

}  // namespace

std::string index_text(const CellIndex& index) {
  std::string text = fmt::format("{}\n{} {} {}\n", first_words, index.bytes, index.points, index.cells.size());
  for (const SampledCell& cell : index.cells)
    text += fmt::format("{} {} {} {} {} {} {} {}\n", cell.corner[0], cell.corner[1], cell.corner[2], cell.side,
                        cell.points, cell.first, cell.last, cell.error);
  return text;
}

CellIndex parse_index(std::string_view text, const std::string& file) {
  CellIndex index;
  std::size_t number = 0;
  std::string place;
  const auto next_line = [&] {
    place = fmt::format("{}: line {}", file, ++number);
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) Words(text, place).fail("the file ends here");
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    return line;
  };
  if (next_line() != first_words)
    throw Error(Element::file, 0,
                file + ": does not begin with \"glark cells 1\"; name the .cells file that glark sample wrote");
  Words words(next_line(), place);
  index.bytes = words.next<std::uint64_t>("size of the scan");
  index.points = words.next<std::uint64_t>("number of points");
  const auto cells = words.next<std::uint64_t>("number of cells");
  words.end();
  if (cells > most_cells) words.fail(fmt::format("{} cells are too many", cells));
  for (std::uint64_t i = 0; i < cells; ++i) {
    const std::string_view line = next_line();
    index.cells.push_back(parse_cell(Words(line, place), index));
  }
  if (!text.empty()) Words(text, place).fail("lines follow the last cell");
  return index;
}

void write_cells(const std::filesystem::path& file, const CellIndex& index) {
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
