// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/contour/sheets.h"

#include "glark/clients/common/disjoint_sets.h"

namespace glark::reconstruct {
namespace {

// The number of the edge between two neighbouring corners.
unsigned edge_between(unsigned a, unsigned b) {
  for (unsigned edge = 0; edge < 12; ++edge) {
    const CellEdge ends = edge_of_cell(edge);
    if ((ends.from == a && ends.to == b) || (ends.from == b && ends.to == a)) return edge;
  }
  return 12;
}

// Joins the crossed edges of one face. `corners` go around the face.
void join_face(unsigned inside, const std::array<unsigned, 4>& corners, common::DisjointSets& joined) {
  const auto is_inside = [&](unsigned i) { return ((inside >> corners[i % 4]) & 1) != 0; };
  std::array<unsigned, 4> crossed{};
  unsigned count = 0;
  for (unsigned i = 0; i < 4; ++i) {
    if (is_inside(i) != is_inside(i + 1)) crossed[count++] = edge_between(corners[i], corners[(i + 1) % 4]);
  }
  if (count == 2) joined.join(crossed[0], crossed[1]);
  if (count != 4) return;
  const unsigned first = is_inside(0) ? 0 : 1;  // an inside corner; its two edges are joined
  joined.join(crossed[(first + 3) % 4], crossed[first]);
  joined.join(crossed[first + 1], crossed[first + 2]);
}

Sheets make(unsigned inside) {
  common::DisjointSets joined(12);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = 1U << ((axis + 1) % 3), v = 1U << ((axis + 2) % 3);
    for (const unsigned low : {0U, 1U << axis}) join_face(inside, {low, low | u, low | u | v, low | v}, joined);
  }
  Sheets sheets;
  sheets.of_edge.fill(no_sheet);
  std::array<std::uint8_t, 12> number{};
  number.fill(no_sheet);
  for (unsigned edge = 0; edge < 12; ++edge) {
    const CellEdge ends = edge_of_cell(edge);
    if (((inside >> ends.from) & 1) == ((inside >> ends.to) & 1)) continue;
    std::uint8_t& mine = number[joined.find(edge)];
    if (mine == no_sheet) mine = sheets.count++;
    sheets.of_edge[edge] = mine;
  }
  return sheets;
}

}  // namespace

CellEdge edge_of_cell(unsigned edge) {
  const unsigned axis = edge / 4;
  const unsigned u = (axis + 1) % 3, v = (axis + 2) % 3;
  const unsigned from = ((edge & 1) << u) | (((edge >> 1) & 1) << v);
  return {from, from | (1U << axis)};
}

const Sheets& sheets_of(unsigned inside) {
  static const auto all = [] {
    std::array<Sheets, 256> table;
    for (unsigned i = 0; i < 256; ++i) table[i] = make(i);
    return table;
  }();
  return all[inside];
}

}  // namespace glark::reconstruct
