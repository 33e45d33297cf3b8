// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <set>
#include <stdexcept>
#include <utility>

namespace glark::pattern {
namespace {

const Piece& piece_of(const Pool& pool, int number) { return pool.pieces[static_cast<std::size_t>(number)]; }

// Average misses per triangle of a first-in-first-out vertex cache.
double cache_miss_ratio(const Pool& pool, const Piece& piece, std::size_t entries) {
  std::deque<std::uint16_t> cache;
  int misses = 0;
  for (std::size_t k = 0; k < piece.index_count; ++k) {
    std::uint16_t index = pool.indices[piece.first_index + k];
    if (std::find(cache.begin(), cache.end(), index) != cache.end()) continue;
    ++misses;
    cache.push_back(index);
    if (cache.size() > entries) cache.pop_front();
  }
  return 3.0 * misses / piece.index_count;
}

// Boubekeur 2007, ch. 7 reports 26 MB on the GPU and less than 4 kB on the CPU at level 10.
TEST(Pool, StaysSmall) {
  EXPECT_LE(build_pool(10).gpu_bytes(), 2'000'000u);
  EXPECT_LE(build_pool(11).gpu_bytes(), 4'000'000u);
  EXPECT_LE(sizeof(PieceTable), 4000u);
  RecordProperty("bytes_level_10", static_cast<int>(build_pool(10).gpu_bytes()));
}

TEST(Pool, RejectsALevelAboveEleven) { EXPECT_THROW(build_pool(12), std::invalid_argument); }

TEST(Pool, IndicesStayWithinTheirPiece) {
  Pool pool = build_pool(11);
  for (const Piece& piece : pool.pieces) {
    EXPECT_EQ(piece.index_count % 3, 0u);
    ASSERT_LE(piece.first_index + piece.index_count, pool.indices.size());
    ASSERT_LE(static_cast<std::size_t>(piece.base_vertex + piece.vertex_count), pool.vertices.size());
    for (std::size_t k = 0; k < piece.index_count; ++k)
      ASSERT_LT(pool.indices[piece.first_index + k], piece.vertex_count);
  }
}

TEST(Pool, LeavesOutWhatItsLevelDoesNotReach) {
  Pool pool = build_pool(3);
  EXPECT_NE(piece_of(pool, uniform_piece(3)).index_count, 0u);
  EXPECT_EQ(piece_of(pool, uniform_piece(4)).index_count, 0u);
  EXPECT_EQ(piece_of(pool, interior_piece(4)).index_count, 0u);
  EXPECT_EQ(piece_of(pool, skirt_piece(3, 4)).index_count, 0u);
  EXPECT_EQ(piece_of(pool, fan_piece(0, 4)).index_count, 0u);
}

TEST(Pool, PiecesHaveTheTrianglesTheyNeed) {
  Pool pool = build_pool(11);
  EXPECT_EQ(piece_of(pool, uniform_piece(8)).index_count, 3u * 65536);
  EXPECT_EQ(piece_of(pool, uniform_piece(8)).vertex_count, 33153u);
  EXPECT_EQ(piece_of(pool, interior_piece(6)).index_count, 3u * 61 * 61);
  EXPECT_EQ(piece_of(pool, skirt_piece(3, 5)).index_count, 3u * (32 + 5));
  EXPECT_EQ(piece_of(pool, fan_piece(2, 3)).index_count, 3u * (4 + 8 - 1));
}

TEST(Pool, InteriorIsThePrefixOfUniform) {
  Pool pool = build_pool(6);
  for (int m = 2; m <= 6; ++m) {
    EXPECT_EQ(piece_of(pool, interior_piece(m)).first_index, piece_of(pool, uniform_piece(m)).first_index);
    EXPECT_EQ(piece_of(pool, interior_piece(m)).base_vertex, piece_of(pool, uniform_piece(m)).base_vertex);
  }
}

TEST(Pool, SkirtsAreMirrorSymmetric) {
  Pool pool = build_pool(11);
  for (int number = first_skirt; number < first_fan; ++number) {
    const Piece& piece = piece_of(pool, number);
    std::set<std::pair<int, int>> points;
    std::set<std::pair<int, int>> mirrored;
    for (std::size_t k = 0; k < piece.index_count; ++k) {
      LatticeVertex p = pool.vertices[piece.base_vertex + pool.indices[piece.first_index + k]];
      points.insert({p.u, p.v});
      mirrored.insert({lattice_one - p.u - p.v, p.v});
    }
    EXPECT_EQ(points, mirrored) << number;
  }
}

TEST(Pool, UniformReusesCachedVertices) {
  Pool pool = build_pool(8);
  for (std::size_t entries : {16u, 24u, 32u}) {
    EXPECT_LE(cache_miss_ratio(pool, piece_of(pool, uniform_piece(6)), entries), 0.65) << entries;
    EXPECT_LE(cache_miss_ratio(pool, piece_of(pool, uniform_piece(8)), entries), 0.62) << entries;
  }
}

}  // namespace
}  // namespace glark::pattern
