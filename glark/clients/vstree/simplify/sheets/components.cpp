// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/sheets/components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::vstree {
namespace {

constexpr std::size_t few = 8;            // parts that may break off a sound result
constexpr std::size_t crumb = 12;         // the most triangles of a part that is only a piece pinched off
constexpr std::size_t least_share = 200;  // and it has fewer than one in so many triangles
constexpr std::size_t large_share = 200;  // a part with more than one in so many triangles does not vanish
constexpr double most_area = 1.05;        // a sound result has hardly more area than its input

// The parts of triangles that share vertices.
struct Parts {
  std::vector<std::uint32_t> of;       // [vertices]
  std::vector<std::size_t> triangles;  // of each part; 0 for a vertex without triangles

  // `sets` may have joined some vertices before.
  Parts(std::span<const std::uint32_t> corners, common::DisjointSets& sets) : of(sets.size()), triangles(sets.size()) {
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
      sets.join(corners[t], corners[t + 1]);
      sets.join(corners[t], corners[t + 2]);
    }
    for (std::uint32_t i = 0; i < of.size(); ++i) of[i] = sets.find(i);
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) ++triangles[of[corners[t]]];
  }
  std::size_t count() const {
    return triangles.size() - static_cast<std::size_t>(std::ranges::count(triangles, std::size_t{0}));
  }
};

// Points at one position are one vertex.
common::DisjointSets joined_by_position(std::span<const float> positions) {
  const auto place = [&](std::uint32_t i) {
    return std::array{positions[3 * std::size_t{i}], positions[3 * std::size_t{i} + 1],
                      positions[3 * std::size_t{i} + 2]};
  };
  std::vector<std::uint32_t> order(positions.size() / 3);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  common::DisjointSets sets(order.size());
  for (std::size_t k = 1; k < order.size(); ++k)
    if (place(order[k - 1]) == place(order[k])) sets.join(order[k - 1], order[k]);
  return sets;
}

Parts parts_of(std::span<const std::uint32_t> corners, std::span<const float> positions) {
  common::DisjointSets sets(positions.size() / 3);
  Parts parts(corners, sets);
  if (parts.count() == 1) return parts;
  // Triangles may have corners of their own. Positions tell which ones are neighbours.
  common::DisjointSets by_position = joined_by_position(positions);
  return {corners, by_position};
}

Parts parts_of(const Surface& surface) { return parts_of(surface.triangles, surface.points.positions); }
Parts parts_of(const Simplified& result) { return parts_of(result.triangles, result.positions); }

template <typename PointOf>
double area_of(std::span<const std::uint32_t> corners, const PointOf& point) {
  double area = 0;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const Float4 a = point(corners[t]);
    const Float4 across = cross(point(corners[t + 1]) - a, point(corners[t + 2]) - a);
    area += std::sqrt(static_cast<double>(dot(across, across)));
  }
  return area;
}

bool has_grown(const Surface& from, const Simplified& result) {
  const double before = area_of(from.triangles, [&](std::uint32_t i) { return from.point(i); });
  const double after = area_of(
      result.triangles, [&](std::uint32_t i) { return from.cube.inside(&result.positions[3 * std::size_t{i}]); });
  return after > most_area * before;
}

}  // namespace

bool falls_apart(const Surface& from, const Simplified& result) {
  const std::size_t after = parts_of(result).count();
  const Parts before = parts_of(from);
  const std::size_t least = from.triangles.size() / 3 / large_share;
  const auto large = std::ranges::count_if(before.triangles, [&](std::size_t count) { return count > least; });
  return (after > few && after > 2 * before.count() + few) || after < static_cast<std::size_t>(large) ||
         has_grown(from, result);
}

namespace {

// Calls connect(a, b) for parts of the result whose samples belong to one part of the input.
template <typename Connect>
void connect_by_parts(const Surface& from, const Simplified& result, const Parts& after, const Connect& connect) {
  const Parts before = parts_of(from);
  std::vector<std::uint32_t> found(before.of.size(), none);
  for (std::uint32_t i = 0; i < from.size(); ++i) {
    const std::uint32_t vertex = result.representatives[i];
    if (vertex == none) continue;
    std::uint32_t& other = found[before.of[i]];
    if (other == none) other = after.of[vertex];
    connect(after.of[vertex], other);
  }
}

// The same for clusters: triangles of the input at samples of crumbs connect these with the rest. It is quicker, but a
// collapse leaves most samples without a vertex.
template <typename Connect>
void connect_by_triangles(const Surface& from, const Simplified& result, const Parts& after,
                          const std::vector<bool>& is_crumb, const Connect& connect) {
  std::vector<std::uint8_t> is_in_crumb(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::uint32_t vertex = result.representatives[i];
    is_in_crumb[i] = vertex != none && is_crumb[after.of[vertex]] ? 1 : 0;
  }
  for (std::size_t t = 0; t + 2 < from.triangles.size(); t += 3) {
    const std::uint32_t* const corners = &from.triangles[t];
    if ((is_in_crumb[corners[0]] | is_in_crumb[corners[1]] | is_in_crumb[corners[2]]) == 0) continue;
    std::uint32_t last = none;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = result.representatives[corners[k]];
      if (vertex == none) continue;
      connect(after.of[vertex], last == none ? after.of[vertex] : last);
      last = after.of[vertex];
    }
  }
}

}  // namespace

void drop_pinched_off(const Surface& from, Simplified& result) {
  const Parts after = parts_of(result);
  const std::size_t most = std::min(crumb, result.triangles.size() / 3 / least_share);
  const auto is_crumb = [&](std::uint32_t part) { return after.triangles[part] <= most; };
  std::vector<bool> is_gone(after.triangles.size());
  bool any = false;
  for (std::uint32_t part = 0; part < is_gone.size(); ++part) {
    is_gone[part] = after.triangles[part] > 0 && is_crumb(part);
    any = any || is_gone[part];
  }
  if (!any) return;
  common::DisjointSets connected(after.of.size());
  std::vector<bool> has_samples(after.of.size());
  const auto connect = [&](std::uint32_t part, std::uint32_t other) {
    has_samples[part] = has_samples[other] = true;
    connected.join(part, other);
  };
  if (result.method == Method::collapse) {
    connect_by_parts(from, result, after, connect);
  } else {
    connect_by_triangles(from, result, after, is_gone, connect);
  }
  std::vector<bool> has_more(after.of.size());  // whether more than crumbs is connected
  for (std::uint32_t part = 0; part < has_more.size(); ++part) {
    if (!is_crumb(part)) has_more[connected.find(part)] = true;
  }
  for (std::uint32_t part = 0; part < is_gone.size(); ++part)
    is_gone[part] = is_gone[part] && (!has_samples[part] || has_more[connected.find(part)]);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < result.triangles.size(); t += 3) {
    if (is_gone[after.of[result.triangles[t]]]) continue;
    std::copy_n(&result.triangles[t], 3, &result.triangles[kept]);
    kept += 3;
  }
  result.triangles.resize(kept);
}

void drop_unused_vertices(Simplified& result) {
  std::vector<std::uint32_t> number(result.positions.size() / 3, none), kept;
  for (const std::uint32_t i : result.triangles) number[i] = 0;
  for (std::uint32_t i = 0; i < number.size(); ++i) {
    if (number[i] == none) continue;
    number[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(i);
  }
  if (kept.size() == number.size()) return;
  const auto keep = [&](auto& array, std::size_t size) {
    if (array.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) std::copy_n(&array[size * kept[i]], size, &array[size * i]);
    array.resize(size * kept.size());
  };
  keep(result.positions, 3);
  keep(result.normals, 3);
  keep(result.colours, 3);
  keep(result.texcoords, 2);
  for (std::uint32_t& i : result.triangles) i = number[i];
  for (std::uint32_t& i : result.representatives) i = i == none ? none : number[i];
}

}  // namespace glark::vstree
