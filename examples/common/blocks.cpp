// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "examples/common/blocks.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace lesson {
namespace {

using Cell = std::array<int, 3>;  // column from the left, row from below, layer from the back

class Builder {
 public:
  explicit Builder(std::vector<std::string_view> rows) : rows_(std::move(rows)) {}

  void add_block(const Cell& block) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell neighbour = block;
        neighbour[axis] += 2 * side - 1;
        if (!is_block(neighbour)) add_wall(block, axis, side);
      }
    }
  }

  bool is_block(const Cell& c) const {
    if (c[0] < 0 || c[0] >= width() || c[1] < 0 || c[1] >= height() || c[2] != 0) return false;
    return rows_[static_cast<std::size_t>(height() - 1 - c[1])][static_cast<std::size_t>(c[0])] == 'X';
  }

  int width() const { return static_cast<int>(rows_[0].size()); }
  int height() const { return static_cast<int>(rows_.size()); }

  BlockMesh mesh;

 private:
  void add_wall(const Cell& block, std::size_t axis, int side) {
    // The two directions along the wall. Swapped, they turn the wall round.
    const std::size_t u = (axis + (side == 1 ? 1U : 2U)) % 3;
    const std::size_t v = 3 - axis - u;
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
      Cell at = block;
      at[axis] += side;
      at[u] += i == 1 || i == 2 ? 1 : 0;
      at[v] += i >= 2 ? 1 : 0;
      corners[i] = vertex(at);
    }
    mesh.triangles.insert(mesh.triangles.end(),
                          {corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]});
  }

  std::uint32_t vertex(const Cell& at) {
    const auto [found, is_new] = vertices_.try_emplace(at, static_cast<std::uint32_t>(vertices_.size()));
    if (is_new) {
      const std::array<float, 3> middle = {0.5F * static_cast<float>(width()), 0.5F * static_cast<float>(height()),
                                           0.5F};
      for (std::size_t k = 0; k < 3; ++k) mesh.positions.push_back(static_cast<float>(at[k]) - middle[k]);
    }
    return found->second;
  }

  std::vector<std::string_view> rows_;  // the top row first
  std::map<Cell, std::uint32_t> vertices_;
};

// Empty lines do not count.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (!line.empty()) lines.push_back(line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return lines;
}

}  // namespace

BlockMesh make_blocks(std::string_view drawing) {
  Builder builder(lines_of(drawing));
  for (int y = 0; y < builder.height(); ++y)
    for (int x = 0; x < builder.width(); ++x)
      if (builder.is_block({x, y, 0})) builder.add_block({x, y, 0});
  return builder.mesh;
}

}  // namespace lesson
