// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/scene/obj_vertices.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace glark::geometry {
namespace {

constexpr std::string_view spaces = " \t\r\n\\";  // a line goes on after a backslash

// Returns the line with those that continue it, and removes it from the text.
std::string_view take_line(std::string_view& text) {
  std::size_t end = std::min(text.find('\n'), text.size());
  while (end < text.size()) {
    const std::string_view line = text.substr(0, end);
    const std::size_t last = line.find_last_not_of(" \t\r");
    if (last == std::string_view::npos || line[last] != '\\') break;
    end = std::min(text.find('\n', end + 1), text.size());
  }
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(spaces), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(spaces));
  line.remove_prefix(word.size());
  return word;
}

class Scan {
 public:
  explicit Scan(bool with_loose) : with_loose_(with_loose) {}

  void add(std::string_view line) {
    const std::string_view keyword = next_word(line);
    if (keyword == "v") add_vertex(line);
    if (!with_loose_ || (keyword != "f" && keyword != "l" && keyword != "p")) return;
    has_faces_ |= keyword == "f";
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) use(word);
  }

  ObjVertices finish() {
    used_.resize(positions_.size());
    for (std::size_t i = 0; has_faces_ && i < positions_.size(); ++i)
      if (!used_[i]) result_.loose.push_back(positions_[i]);
    return std::move(result_);
  }

 private:
  void add_vertex(std::string_view line) {
    std::array<double, 3> position{};
    std::size_t words = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line), ++words)
      if (words < 3 && with_loose_) fast_float::from_chars(word.data(), word.data() + word.size(), position[words]);
    ++(words >= 6 ? result_.with_colour : result_.without_colour);
    if (with_loose_) positions_.push_back(position);
  }

  // A negative index counts from the last vertex so far.
  void use(std::string_view word) {
    std::int64_t index = 0;
    if (std::from_chars(word.data(), word.data() + word.size(), index).ec != std::errc()) return;
    if (index < 0) index += static_cast<std::int64_t>(positions_.size()) + 1;
    if (index < 1 || index > (std::int64_t{1} << 32)) return;
    const auto vertex = static_cast<std::size_t>(index - 1);
    if (vertex >= used_.size()) used_.resize(std::max(vertex + 1, 2 * used_.size()));
    used_[vertex] = true;
  }

  bool with_loose_, has_faces_ = false;
  ObjVertices result_;
  std::vector<std::array<double, 3>> positions_;
  std::vector<bool> used_;
};

}  // namespace

ObjVertices obj_vertices(std::string_view text, bool with_loose) {
  Scan scan(with_loose);
  while (!text.empty()) scan.add(take_line(text));
  return scan.finish();
}

}  // namespace glark::geometry
