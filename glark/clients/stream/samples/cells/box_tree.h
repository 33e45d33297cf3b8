// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A tree over the boxes of cells, which finds the cells near a place.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/stream/samples/cells/sample_cells.h"

namespace glark::stream {

// Boxes that follow one another lie close together, so eight of them have a common box one level up, and so on.
// Based on: Roussopoulos and Leifker 1985, packed R-trees; Roussopoulos, Kelley and Vincent 1995 for the search.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<CellBox>& boxes);

  // Calls visit(cell), near ones first, for the cells that may have a place nearer than worst(), the square of a
  // distance, which may become smaller from one cell to the next.
  template <class Worst, class Visit>
  void each_near(const common::Vector3f& point, const Worst& worst, const Visit& visit) const {
    each_near(levels_.size() - 1, 0, point, worst, visit);
  }

 private:
  static constexpr std::size_t width = 8;
  struct Child {
    float square = 0;
    std::size_t number = 0;
  };

  static float squared_distance(const CellBox& box, const common::Vector3f& p) {
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float away = std::max({box.low[k] - p[k], p[k] - box.high[k], 0.0F});
      sum += away * away;
    }
    return sum;
  }

  // Returns up to eight boxes from the first one on, the nearest one first. (std::sort of so small an array makes GCC 14
  // warn of its bounds.)
  static std::span<Child> sort_by_distance(const std::vector<CellBox>& boxes, std::size_t first,
                                           const common::Vector3f& point, std::array<Child, width>& children) {
    auto end = children.begin();
    for (std::size_t i = first; i < boxes.size() && end != children.end(); ++i, ++end) {
      const Child child = {squared_distance(boxes[i], point), i};
      const auto place = std::upper_bound(children.begin(), end, child,
                                          [](const Child& a, const Child& b) { return a.square < b.square; });
      std::move_backward(place, end, end + 1);
      *place = child;
    }
    return {children.begin(), end};
  }

  template <class Worst, class Visit>
  void each_near(std::size_t level, std::size_t first, const common::Vector3f& point, const Worst& worst,
                 const Visit& visit) const {
    const std::vector<CellBox>& boxes = levels_[level];
    std::array<Child, width> children;
    const std::span<Child> sorted = sort_by_distance(boxes, first, point, children);
    for (const Child& child : sorted) {
      if (child.square > worst()) break;
      if (level == 0)
        visit(static_cast<std::uint32_t>(child.number));
      else
        each_near(level - 1, width * child.number, point, worst, visit);
    }
  }

  std::vector<std::vector<CellBox>> levels_;  // the cells first, at most eight boxes last
};

inline BoxTree::BoxTree(const std::vector<CellBox>& boxes) : levels_{boxes} {
  while (levels_.back().size() > width) {
    const std::vector<CellBox>& below = levels_.back();
    std::vector<CellBox> level;
    for (std::size_t first = 0; first < below.size(); first += width) {
      CellBox box = below[first];
      for (std::size_t i = first; i < std::min(first + width, below.size()); ++i) {
        box.low = common::least(box.low, below[i].low);
        box.high = common::greatest(box.high, below[i].high);
      }
      level.push_back(box);
    }
    levels_.push_back(std::move(level));
  }
}

}  // namespace glark::stream
