// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/quadtrees.h"

#include <algorithm>
#include <utility>

#include "glark/clients/vstree/simplify/shapes.h"
#include "glark/clients/vstree/tree/cells.h"

namespace glark::vstree {
namespace {

constexpr float boundary_weight = 16;  // of a plane at the boundary, relative to a sample
constexpr unsigned most_levels = 6;    // the most levels of a grid, so that its sums fit into the cache
enum PartKind : std::uint8_t { empty, filled, divided };

// Returns a number from 1 to 2. So some of several equal flat rectangles are divided before others.
float uneven(std::size_t i) {
  return 1 + static_cast<float>((static_cast<std::uint32_t>(i) * 2654435761U) >> 8) * 0x1p-24F;
}

std::size_t cells_of(unsigned levels) { return std::size_t{1} << (2 * levels); }
std::size_t quads_of(unsigned levels) { return cells_of(levels) / 3; }

}  // namespace

// Sums over samples, and over their tangent planes n x + d = 0 relative to the origin of a frame.
struct alignas(64) Quadtrees::Sums {
  Float4 squares{};   // squares of n; the fourth is the square of d
  Float4 products{};  // n_x n_y, n_y n_z, n_z n_x
  Float4 offsets{};   // n d
  Float4 points{};    // the fourth is the number of points

  void add(Float4 point, Float4 normal) {
    normal[3] = -dot(normal, point);
    point[3] = 1;
    squares += normal * normal;
    products += normal * __builtin_shufflevector(normal, normal, 1, 2, 0, 3);
    offsets += normal * splat<3>(normal);
    points += point;
  }
  // Adds a plane without a sample.
  void add_boundary(Float4 point, Float4 normal) {
    normal[3] = -dot(normal, point);
    const Float4 weighted = normal * boundary_weight;
    squares += normal * weighted;
    products += without_fourth(weighted * __builtin_shufflevector(normal, normal, 1, 2, 0, 3));
    offsets += weighted * splat<3>(normal);
  }
  // Boundary planes leave out the fourth number of the products, which otherwise is that of the squares.
  bool has_boundary() const { return squares[3] != products[3]; }
  Sums operator+(const Sums& other) const {
    return {squares + other.squares, products + other.products, offsets + other.offsets, points + other.points};
  }
  float count() const { return points[3]; }
  // Returns the sum of the squared distances of the best point from the planes. The best point lies on the line through
  // the centroid along the frame's normal. `square`: the squared extent.
  float error(float square) const {
    const Float4 x = without_fourth(points / splat<3>(points));
    const Float4 yzx = __builtin_shufflevector(x, x, 1, 2, 0, 3), zxy = __builtin_shufflevector(x, x, 2, 0, 1, 3);
    const Float4 others = __builtin_shufflevector(products, products, 2, 0, 1, 3);
    const Float4 gradient = squares * x + products * yzx + others * zxy + offsets;
    const float here = dot(x, gradient + offsets) + squares[3];
    if (has_boundary()) return error_at_boundary(x, here, square);
    const float step = gradient[2] * gradient[2] / (squares[2] + 1e-20F);
    return std::max(0.0F, here - step) + flat_share * square * count();
  }
  // The best point moves also along the surface, as to a straight boundary. `here`: the error at the centroid.
  float error_at_boundary(Float4 centroid, float here, float square) const {
    Shape shape;
    shape.radius = std::sqrt(square) / 2;
    shape.quadric = quadric();
    shape.quadric.constant = here;
    for (Float4& row : shape.quadric.rows) row[3] += dot(without_fourth(row), centroid);
    return std::max(0.0F, shape.quadric.error_at(shape.best_step(most_step_at_boundary))) +
           flat_share * square * count();
  }
  Quadric quadric() const {
    Quadric result;
    result.rows[0] = Float4{squares[0], products[0], products[2], offsets[0]};
    result.rows[1] = Float4{products[0], squares[1], products[1], offsets[1]};
    result.rows[2] = Float4{products[2], products[1], squares[2], offsets[2]};
    result.constant = squares[3];
    return result;
  }
  Shape in_space(const LocalFrame& frame) const {
    const Float4(&c)[3] = frame.columns;
    Float4 axes[3];
    for (int i = 0; i < 3; ++i) axes[i] = Float4{c[0][i], c[1][i], c[2][i], 0};
    const Float4 rows[3] = {
        squares[0] * axes[0] + products[0] * axes[1] + products[2] * axes[2] + Float4{0, 0, 0, offsets[0]},
        products[0] * axes[0] + squares[1] * axes[1] + products[1] * axes[2] + Float4{0, 0, 0, offsets[1]},
        products[2] * axes[0] + products[1] * axes[1] + squares[2] * axes[2] + Float4{0, 0, 0, offsets[2]}};
    Shape shape;
    shape.sum = frame.origin * count() + Float4{0, 0, 0, count()};
    shape.radius = std::sqrt(frame.size[0] * frame.size[0] + frame.size[1] * frame.size[1]) / 2;
    for (int i = 0; i < 3; ++i)
      shape.quadric.rows[i] = axes[0][i] * rows[0] + axes[1][i] * rows[1] + axes[2][i] * rows[2];
    shape.quadric.constant = squares[3];
    return shape;
  }
};

Quadtrees::Quadtrees(const Nodes& layer, std::span<const Record> sorted, std::size_t samples,
                     const BoundaryPlanes* boundary, const Workers& workers)
    : nodes_(layer.nodes),
      boundary_(boundary),
      samples_(samples),
      most_samples_(samples < 3 ? samples : 4 * samples),
      part_of_(sorted.size()),
      leaf_parts_(layer.nodes.size(), none) {
  for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    if (!node.is_leaf()) continue;
    const std::span<const Record> records = sorted.subspan(node.begin, node.size());
    if (node.kind == Kind::transition) {
      add_grid({layer.frames[node.frame], records, std::numeric_limits<float>::infinity(), i, 0, 0, 0});
      continue;
    }
    leaf_parts_[i] = static_cast<std::uint32_t>(kinds_.size());
    for (const Record& record : records) part_of_[record.index()] = leaf_parts_[i];
    kinds_.push_back(filled);
  }
  transition_nodes_ = grids_.size();
  std::vector<Sums> wholes;
  for (std::size_t done = 0; done < grids_.size();) {
    const std::size_t first = std::exchange(done, grids_.size());
    std::vector<Rest> rests(done - first);
    wholes.resize(done);
    workers.each(rests.size(), 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) rests[i] = fill(grids_[first + i], wholes[first + i]);
    });
    for (Rest& rest : rests) {
      if (rest.grids.empty()) continue;
      rests_.push_back(std::move(rest));
      for (const Grid& grid : rests_.back().grids) {
        kinds_[grid.parent] = divided;
        add_grid(grid);
      }
    }
  }
  find_volume_errors(sorted, wholes);
}

void Quadtrees::add_grid(Grid grid) {
  grid.levels = 0;
  while (grid.levels < most_levels && (grid.records.size() >> (2 * grid.levels)) > samples_) ++grid.levels;
  grid.first_part = static_cast<std::uint32_t>(kinds_.size());
  grid.first_quad = static_cast<std::uint32_t>(quads_.size());
  kinds_.resize(kinds_.size() + cells_of(grid.levels));
  quads_.resize(quads_.size() + quads_of(grid.levels));
  grids_.push_back(grid);
}

Quadtrees::Rest Quadtrees::fill(const Grid& grid, Sums& whole) {
  const LocalFrame frame = grid.frame;
  const unsigned shift = quadtree_levels - grid.levels;
  std::vector<Sums> cells(cells_of(grid.levels));
  for (const Record& record : grid.records) {
    const Float4 point = frame.inside(record.point());
    const auto [u, v] = frame.cell(point);
    const std::uint32_t key = every_second_bit(u >> shift) | (every_second_bit(v >> shift) << 1);
    cells[key].add(point, frame.turn(record.normal));
    part_of_[record.index()] = grid.first_part + key;
    if (boundary_ == nullptr) continue;
    boundary_->at(record.index(), [&](Float4 normal) { cells[key].add_boundary(point, frame.turn(normal)); });
  }
  float most = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    kinds_[grid.first_part + i] = cells[i].count() > 0 ? filled : empty;
    most = std::max(most, cells[i].count());
  }
  Rest rest;
  if (most > static_cast<float>(most_samples_)) rest = divide(grid, cells);
  put_together(grid, cells);
  whole = cells[0];
  return rest;
}

// Samples at one position of the frame stay one part.
Quadtrees::Rest Quadtrees::divide(const Grid& grid, std::span<const Sums> cells) const {
  Rest rest;
  std::vector<std::vector<Record>> records(cells.size());
  for (const Record& record : grid.records) {
    const std::uint32_t cell = part_of_[record.index()] - grid.first_part;
    if (cells[cell].count() > static_cast<float>(most_samples_)) records[cell].push_back(record);
  }
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (records[i].empty()) continue;
    Grid part = grid;
    part.frame.fit(records[i]);
    if (part.frame.scale[0] == 0 && part.frame.scale[1] == 0) continue;
    const float a = grid.frame.size[0], b = grid.frame.size[1];
    part.most_error = cells[i].error(std::ldexp(a * a + b * b, -2 * static_cast<int>(grid.levels)));
    part.parent = grid.first_part + static_cast<std::uint32_t>(i);
    rest.grids.push_back(part);
    begins.push_back(rest.records.size());
    rest.records.insert(rest.records.end(), records[i].begin(), records[i].end());
  }
  begins.push_back(rest.records.size());
  for (std::size_t i = 0; i < rest.grids.size(); ++i)
    rest.grids[i].records = std::span(rest.records).subspan(begins[i], begins[i + 1] - begins[i]);
  return rest;
}

// Pairs the four cells of each quad in the way with the smaller error. The sum of all cells ends up in the first cell.
void Quadtrees::put_together(const Grid& grid, std::span<Sums> cells) {
  float a = std::ldexp(grid.frame.size[0] * grid.frame.size[0], -2 * static_cast<int>(grid.levels));
  float b = std::ldexp(grid.frame.size[1] * grid.frame.size[1], -2 * static_cast<int>(grid.levels));
  for (unsigned level = grid.levels; level-- > 0; a *= 4, b *= 4) {
    Quad* const quads = &quads_[grid.first_quad + quads_of(level)];
    for (std::size_t i = 0; i < cells_of(level); ++i) {
      const Sums* const four = &cells[4 * i];
      Quad quad;
      float below[4] = {};
      for (unsigned k = 0; k < 4; ++k) {
        if (four[k].count() > 0) quad.filled = static_cast<std::uint8_t>(quad.filled | (1U << k));
        if (level + 1 < grid.levels) below[k] = quads_[grid.first_quad + quads_of(level + 1) + 4 * i + k].error;
      }
      if (quad.filled != 0) {
        const float factor = uneven(grid.first_quad + i);
        const auto error = [&](const Sums& sums, float square) {
          return sums.count() > 0 ? sums.error(square * factor) : 0;
        };
        const Sums lower = four[0] + four[1], upper = four[2] + four[3];
        const float flat[2] = {error(lower, 4 * a + b), error(upper, 4 * a + b)};
        const float upright[2] = {error(four[0] + four[2], a + 4 * b), error(four[1] + four[3], a + 4 * b)};
        if (upright[0] + upright[1] < flat[0] + flat[1]) {
          quad.first = 5;
          quad.pairs[0] = std::max({upright[0], below[0], below[2]});
          quad.pairs[1] = std::max({upright[1], below[1], below[3]});
        } else {
          quad.pairs[0] = std::max({flat[0], below[0], below[1]});
          quad.pairs[1] = std::max({flat[1], below[2], below[3]});
        }
        for (float& pair : quad.pairs) pair = std::min(pair, grid.most_error);
        cells[i] = lower + upper;
        quad.error = std::min(std::max({error(cells[i], 4 * (a + b)), quad.pairs[0], quad.pairs[1]}), grid.most_error);
      } else {
        cells[i] = {};
      }
      quads[i] = quad;
    }
  }
}

void Quadtrees::find_volume_errors(std::span<const Record> sorted, std::span<const Sums> wholes) {
  volume_errors_.assign(nodes_.size(), 0);
  std::vector<Shape> shapes(nodes_.size());
  for (std::size_t i = 0; i < transition_nodes_; ++i) {
    const Grid& grid = grids_[i];
    shapes[grid.parent] = wholes[i].in_space(grid.frame);
    if (grid.levels > 0) volume_errors_[grid.parent] = quads_[grid.first_quad].error;
  }
  for (std::size_t i = nodes_.size(); i-- > 0;) {  // children come after their parents
    const Node& node = nodes_[i];
    if (node.is_leaf()) {
      if (node.kind == Kind::volume) shapes[i] = shape_of(sorted.subspan(node.begin, node.size()));
      continue;
    }
    shapes[i] = sum_of(std::span(shapes).subspan(node.first_child, node.child_count()));
    volume_errors_[i] = shapes[i].error();
    for (std::uint32_t k = 0; k < node.child_count(); ++k)
      volume_errors_[i] = std::max(volume_errors_[i], volume_errors_[node.first_child + k]);
  }
}

LeafCounts Quadtrees::leaf_counts() const {
  std::vector<LeafCounts::Division> divisions;
  divisions.reserve(nodes_.size() + kinds_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].is_leaf()) divisions.push_back({volume_errors_[i], nodes_[i].child_count() - 1});
  }
  for (const Quad& quad : quads_) {
    if (quad.has(quad.first) && quad.has(quad.second())) divisions.push_back({quad.error, 1});
    if (quad.has_all(quad.first)) divisions.push_back({quad.pairs[0], 1});
    if (quad.has_all(quad.second())) divisions.push_back({quad.pairs[1], 1});
  }
  return LeafCounts(std::move(divisions));
}

std::uint32_t Quadtrees::cluster(std::size_t most, std::vector<std::uint32_t>& of) const {
  const float threshold = leaf_counts().threshold_for(most);
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_node(nodes_.size(), none), of_part(kinds_.size(), none);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    if (of_node[i] == none && (volume_errors_[i] <= threshold || leaf_parts_[i] != none)) of_node[i] = count++;
    if (leaf_parts_[i] != none) of_part[leaf_parts_[i]] = of_node[i];
    if (node.is_leaf()) continue;
    for (std::uint32_t k = 0; k < node.child_count(); ++k) of_node[node.first_child + k] = of_node[i];
  }
  for (std::size_t i = 0; i < grids_.size(); ++i) {
    const Grid& grid = grids_[i];
    of_part[grid.first_part] = i < transition_nodes_ ? of_node[grid.parent] : of_part[grid.parent];
    cluster(grid, threshold, count, of_part);
  }
  of.resize(part_of_.size());
  for (std::size_t i = 0; i < of.size(); ++i) of[i] = of_part[part_of_[i]];
  return count;
}

// On entry, the first part has the cluster of the whole grid, or `none`.
void Quadtrees::cluster(const Grid& grid, float threshold, std::uint32_t& count,
                        std::vector<std::uint32_t>& of_part) const {
  std::uint32_t* const parts = &of_part[grid.first_part];
  for (unsigned level = 0; level < grid.levels; ++level) {
    for (std::size_t i = cells_of(level); i-- > 0;) {  // backwards, because four cells replace one
      const Quad& quad = quads_[grid.first_quad + quads_of(level) + i];
      std::uint32_t whole = parts[i];
      if (whole == none && quad.filled != 0 && quad.error <= threshold) whole = count++;
      std::uint32_t pairs[2] = {whole, whole};
      if (whole == none) {
        if (quad.has(quad.first) && quad.pairs[0] <= threshold) pairs[0] = count++;
        if (quad.has(quad.second()) && quad.pairs[1] <= threshold) pairs[1] = count++;
      }
      for (unsigned k = 0; k < 4; ++k) parts[4 * i + k] = pairs[(quad.first >> k & 1U) != 0 ? 0 : 1];
    }
  }
  for (std::size_t i = 0; i < cells_of(grid.levels); ++i) {
    if (parts[i] == none && kinds_[grid.first_part + i] == filled) parts[i] = count++;
  }
}

}  // namespace glark::vstree
