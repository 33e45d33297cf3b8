// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/contour/thin_cells.h"

#include <algorithm>

#include "glark/clients/reconstruct/contour/sheets.h"

namespace glark::reconstruct {
namespace {

constexpr float length_cost = 0.25F;  // of a line as long as a cell, relative to the cosine of its ends' normals

Float4 place_of(unsigned corner) {
  return Float4{static_cast<float>(corner & 1U), static_cast<float>((corner >> 1U) & 1U),
                static_cast<float>(corner >> 2U), 0};
}

// The best set of lines between the crossings begin .. end, for all such ranges. Its ends have the most similar normals.
class BestLines {
 public:
  explicit BestLines(const std::vector<FaceCrossing>& around)
      : around_(around), count_(around.size()), score_((count_ + 1) * (count_ + 1)), partner_(score_.size()) {
    for (std::size_t size = 2; size <= count_; size += 2) {
      for (std::size_t begin = 0; begin + size <= count_; ++begin) choose(begin, begin + size);
    }
  }

  void collect(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& other) const {
    if (begin == end) return;
    const std::size_t with = partner_[at(begin, end)];
    other[begin] = static_cast<std::uint32_t>(with);
    other[with] = static_cast<std::uint32_t>(begin);
    collect(begin + 1, with, other);
    collect(with + 1, end, other);
  }

 private:
  std::size_t at(std::size_t begin, std::size_t end) const { return begin * (count_ + 1) + end; }

  float line(std::size_t a, std::size_t b) const {
    const Float4 along = around_[a].point - around_[b].point;
    return dot(around_[a].normal, around_[b].normal) - length_cost * std::sqrt(dot(along, along));
  }

  void choose(std::size_t begin, std::size_t end) {
    for (std::size_t with = begin + 1; with < end; with += 2) {
      const float score = line(begin, with) + score_[at(begin + 1, with)] + score_[at(with + 1, end)];
      if (with > begin + 1 && score <= score_[at(begin, end)]) continue;
      score_[at(begin, end)] = score;
      partner_[at(begin, end)] = with;
    }
  }

  const std::vector<FaceCrossing>& around_;
  std::size_t count_;
  std::vector<float> score_;
  std::vector<std::size_t> partner_;
};

// Returns the number of the edge between two neighbouring corners.
unsigned edge_between(unsigned a, unsigned b) {
  unsigned edge = 0;
  while (edge_of_cell(edge).from != std::min(a, b) || edge_of_cell(edge).to != std::max(a, b)) ++edge;
  return edge;
}

}  // namespace

std::vector<std::uint32_t> lines_of_face(const std::vector<FaceCrossing>& around) {
  std::vector<std::uint32_t> other(around.size());
  BestLines(around).collect(0, around.size(), other);
  return other;
}

ThinCell::ThinCell(const CellIndex& cell, const std::array<float, 8>& values, const ThinEdges& edges) : cell_(cell) {
  for (unsigned i = 0; i < 8; ++i) inside_ |= values[i] < 0 ? 1U << i : 0U;
  gather_crossings(values, edges);
  DisjointSets joined(points_.size());
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = 1U << ((axis + 1) % 3), v = 1U << ((axis + 2) % 3);
    for (const unsigned low : {0U, 1U << axis}) join_face({low, low | u, low | u | v, low | v}, joined);
  }
  number_sheets(joined);
}

void ThinCell::gather_crossings(const std::array<float, 8>& values, const ThinEdges& edges) {
  for (unsigned edge = 0; edge < 12; ++edge) {
    const CellEdge ends = edge_of_cell(edge);
    const unsigned axis = edge / 4;
    CellIndex corner = cell_;
    for (unsigned i = 0; i < 3; ++i) corner[i] += static_cast<std::int32_t>((ends.from >> i) & 1U);
    for (const Crossing& crossing : edges.find(corner, axis)) {
      points_.push_back(place_of(ends.from));
      points_.back()[static_cast<int>(axis)] += crossing.at;
      normals_.push_back(Float4(crossing.normal));
    }
    if (points_.size() == begins_[edge] && is_inside(ends.from) != is_inside(ends.to)) {
      points_.push_back(place_of(ends.from));
      points_.back()[static_cast<int>(axis)] += values[ends.from] / (values[ends.from] - values[ends.to]);
      normals_.push_back(Float4{});
    }
    begins_[edge + 1] = static_cast<std::uint32_t>(points_.size());
  }
}

// The corners go around the face, in the same order for both cells of the face.
void ThinCell::join_face(const std::array<unsigned, 4>& corners, DisjointSets& joined) const {
  std::vector<FaceCrossing> around;
  bool is_looked_at = true;
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned from = corners[i], edge = edge_between(from, corners[(i + 1) % 4]);
    const std::uint32_t count = crossings_of(edge);
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t number = begins_[edge] + (edge_of_cell(edge).from == from ? k : count - 1 - k);
      around.push_back({number, points_[number], normals_[number]});
      is_looked_at &= dot(normals_[number], normals_[number]) > 0;
    }
  }
  std::vector<std::uint32_t> other = lines_of_face(around);
  // Where a cell beside may not be thin, the rule of sheets_of() applies: inside corners on a diagonal are apart.
  if (!is_looked_at && around.size() == 4)
    other = is_inside(corners[0]) ? std::vector{3U, 2U, 1U, 0U} : std::vector{1U, 0U, 3U, 2U};
  for (std::uint32_t i = 0; i < around.size(); ++i) joined.join(around[i].number, around[other[i]].number);
}

void ThinCell::number_sheets(DisjointSets& joined) {
  sheet_.resize(points_.size());
  for (std::uint32_t i = 0; i < sheet_.size(); ++i) {
    const std::uint32_t first = joined.find(i);
    if (first == i) {
      sheet_[i] = static_cast<std::uint32_t>(sheets_.size());
      sheets_.push_back(Float4{});
    }
    sheet_[i] = sheet_[first];
    sheets_[sheet_[i]] += points_[i] + Float4{0, 0, 0, 1};
  }
  for (Float4& sheet : sheets_) sheet = without_fourth(sheet / sheet[3]);
}

namespace {

// Collects cells that have all their corners.
class Collection {
 public:
  Collection(const ThinEdges& edges, const Blocks& blocks) : edges_(edges), blocks_(blocks) {}

  void add(const CellIndex& cell) {
    if (*std::min_element(cell.begin(), cell.end()) < 0 || known_.insert(key_of(cell), count_) != count_) return;
    ++count_;
    std::array<float, 8> values{};
    for (unsigned i = 0; i < 8; ++i) {
      values[i] =
          value_at({cell[0] + static_cast<std::int32_t>(i & 1U), cell[1] + static_cast<std::int32_t>((i >> 1U) & 1U),
                    cell[2] + static_cast<std::int32_t>(i >> 2U)});
      if (values[i] == no_value) return;
    }
    cells_.emplace_back(cell, values, edges_);
  }

  // Adds the cells around an edge.
  void add_around(const ThinEdges::Edge& edge) {
    for (std::int32_t which = 0; which < 4; ++which) {
      CellIndex cell = edge.corner;
      cell[(edge.axis + 1) % 3] -= which % 2;
      cell[(edge.axis + 2) % 3] -= which / 2;
      add(cell);
    }
  }

  // Adds the cells of faces, beginning at the edge, each of whose edges is crossed once.
  void add_beside(const ThinEdges::Edge& edge) {
    for (unsigned i = 1; i < 3; ++i) {
      const unsigned other = (edge.axis + i) % 3;
      CellIndex along = edge.corner, across = edge.corner;
      ++along[edge.axis];
      ++across[other];
      if (edges_.find(edge.corner, other).empty() || edges_.find(along, other).empty() ||
          edges_.find(across, edge.axis).empty())
        continue;
      CellIndex cell = edge.corner;
      add(cell);
      --cell[3 - edge.axis - other];
      add(cell);
    }
  }

  std::vector<ThinCell> take() { return std::move(cells_); }

 private:
  float value_at(const CellIndex& corner) const {
    const std::uint32_t block = blocks_.find({corner[0] / block_side, corner[1] / block_side, corner[2] / block_side});
    if (block == CellTable::absent) return no_value;
    return blocks_
        .values[block][corner_in_block(corner[0] % block_side, corner[1] % block_side, corner[2] % block_side)];
  }

  const ThinEdges& edges_;
  const Blocks& blocks_;
  CellTable known_;
  std::uint32_t count_ = 0;
  std::vector<ThinCell> cells_;
};

}  // namespace

std::vector<ThinCell> thin_cells(const ThinEdges& edges, const Blocks& blocks) {
  Collection cells(edges, blocks);
  for (const ThinEdges::Edge& edge : edges.all()) {
    if (edges.find(edge.corner, edge.axis).size() > 1) cells.add_around(edge);
    cells.add_beside(edge);
  }
  return cells.take();
}

}  // namespace glark::reconstruct
