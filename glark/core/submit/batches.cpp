// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/submit/batches.h"

#include <vector>

#include "glark/core/capture/record_texels.h"
#include "glark/core/pattern/pool.h"
#include "glark/core/refine/attribute_locations.h"

namespace glark::submit {
namespace {

constexpr int batch = refine::triangles_a_batch;
constexpr std::int64_t texel_bytes = 16;

struct Vertex {
  pattern::LatticeVertex lattice;
  std::uint16_t triangle;  // in its batch
  std::uint16_t unused;
};

// All words of the records, in whole texels.
core::BufferTexels::Range texels_of(const BatchDraw& draw) {
  core::BufferTexels::Range range = capture::record_texels(draw.layout, draw.triangles);
  range.size = (range.size + texel_bytes - 1) / texel_bytes * texel_bytes;
  range.format = GL_RGBA32F;
  return range;
}

}  // namespace

void Batches::build(unsigned level) {
  Grid& grid = grids_.at(level);
  const pattern::Pool pool = pattern::build_pool(refine::deepest_batched);
  const pattern::Piece& piece =
      pool.pieces.at(static_cast<std::size_t>(pattern::uniform_piece(static_cast<int>(level))));
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;
  for (int triangle = 0; triangle < batch; ++triangle) {
    const auto first = static_cast<std::uint16_t>(vertices.size());
    for (std::uint32_t i = 0; i < piece.vertex_count; ++i) {
      vertices.push_back({pool.vertices.at(piece.base_vertex + i), static_cast<std::uint16_t>(triangle), 0});
    }
    for (std::uint32_t i = 0; i < piece.index_count; ++i) {
      indices.push_back(static_cast<std::uint16_t>(first + pool.indices.at(piece.first_index + i)));
    }
  }
  grid.index_count = static_cast<GLsizei>(piece.index_count);
  grid.vertices.allocate(gl_, static_cast<std::int64_t>(vertices.size() * sizeof(Vertex)), vertices.data(),
                         GL_STATIC_DRAW);
  grid.indices.allocate(gl_, static_cast<std::int64_t>(indices.size() * sizeof(indices[0])), indices.data(),
                        GL_STATIC_DRAW);
  gl_.GenVertexArrays(1, &grid.vertex_array);
  gl_.BindVertexArray(grid.vertex_array);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, grid.indices.name());
  gl_.EnableVertexAttribArray(refine::lattice_location);
  gl_.VertexAttribFormat(refine::lattice_location, 3, GL_UNSIGNED_SHORT, GL_FALSE, 0);
  gl_.VertexAttribBinding(refine::lattice_location, 0);
  gl_.BindVertexBuffer(0, grid.vertices.name(), 0, sizeof(Vertex));
}

void Batches::draw(const BatchDraw& draw) {
  const Grid& grid = grids_.at(draw.level);
  gl_.BindVertexArray(grid.vertex_array);
  const core::BufferTexels::Range range = texels_of(draw);
  texels_.bind({&range, 1});
  const auto count = static_cast<GLsizei>(draw.triangles.count);
  const GLsizei whole = count / batch;
  const auto issue = [&](GLsizei first, GLsizei triangles, GLsizei instances) {
    const GLint word = core::BufferTexels::first_word(range) + first * draw.layout.triangle_words();
    gl_.ProgramUniform1i(draw.program.name, draw.program.batch_word, word);
    gl_.DrawElementsInstanced(GL_TRIANGLES, triangles * grid.index_count, GL_UNSIGNED_SHORT, nullptr, instances);
  };
  if (whole > 0) {
    issue(0, batch, whole);
  }
  if (count % batch > 0) {
    issue(whole * batch, count % batch, 1);
  }
  texels_.unbind();
}

void Batches::release() {
  for (Grid& grid : grids_) {
    gl_.DeleteVertexArrays(1, &grid.vertex_array);
    grid.vertices.release(gl_);
    grid.indices.release(gl_);
    grid = {};
  }
  texels_.release();
}

}  // namespace glark::submit
