// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/pn/surface_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::pn {
namespace {

constexpr double radians = 3.14159265358979323846 / 180;
constexpr double same_normal_degrees = 1;

bool is_finite(const Vector& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double angle_between(const Vector& a, const Vector& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

void check(const Mesh& mesh) {
  if (mesh.positions.size() % 3 != 0)
    throw Error(Element::array, 0,
                fmt::format("of positions has {} numbers; give three for each vertex", mesh.positions.size()));
  if (mesh.triangles.size() % 3 != 0)
    throw Error(Element::array, 1,
                fmt::format("of triangles has {} indices; give three for each triangle", mesh.triangles.size()));
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size())
    throw Error(Element::array, 2,
                fmt::format("of normals has {} numbers, that of positions {}; give as many, or none",
                            mesh.normals.size(), mesh.positions.size()));
  if (mesh.creases.size() % 2 != 0)
    throw Error(Element::array, 3,
                fmt::format("of creases has {} indices; give two for each crease", mesh.creases.size()));
  const std::size_t vertices = mesh.positions.size() / 3;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!std::isfinite(mesh.positions[i]))
      throw Error(Element::vertex, i / 3,
                  fmt::format("has the coordinate {}; it must be finite: remove the vertex", mesh.positions[i]));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.triangles[i] >= vertices)
      throw Error(Element::triangle, i / 3,
                  fmt::format("has the index {} of {} vertices; correct it", mesh.triangles[i], vertices));
  }
  for (std::size_t i = 0; i < mesh.creases.size(); ++i) {
    if (mesh.creases[i] >= vertices)
      throw Error(Element::crease, i / 2,
                  fmt::format("has the index {} of {} vertices; correct it", mesh.creases[i], vertices));
  }
}

}  // namespace

SurfacePoints::SurfacePoints(const Mesh& mesh, double crease_degrees) : mesh_(mesh) {
  check(mesh);
  weld();
  find_edges();
  mark_creases(crease_degrees);
  name_creases();
  find_sectors();
  find_normals();
}

Vector SurfacePoints::position(std::uint32_t vertex) const {
  const auto at = mesh_.positions.subspan(std::size_t{3} * vertex, 3);
  return {at[0], at[1], at[2]};
}

Vector SurfacePoints::given_normal(std::uint32_t vertex) const {
  if (mesh_.normals.empty()) return {0, 0, 0};
  const auto at = mesh_.normals.subspan(std::size_t{3} * vertex, 3);
  const Vector normal = {at[0], at[1], at[2]};
  return is_finite(normal) ? unit(normal) : Vector{0, 0, 0};
}

// Welds vertices at equal positions; -0 equals 0.
void SurfacePoints::weld() {
  const std::size_t vertices = mesh_.positions.size() / 3;
  const auto key = [&](std::uint32_t vertex) {
    std::array<std::uint32_t, 3> bits{};
    for (std::size_t i = 0; i < 3; ++i)
      bits.at(i) = std::bit_cast<std::uint32_t>(mesh_.positions[3 * vertex + i] + 0.0F);
    return bits;
  };
  std::vector<std::uint32_t> order(vertices);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  point_of_.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    if (i == 0 || key(order[i]) != key(order[i - 1])) ++point_count_;
    point_of_[order[i]] = point_count_ - 1;
  }
}

void SurfacePoints::find_edges() {
  const auto triangles = static_cast<std::uint32_t>(mesh_.triangles.size() / 3);
  degenerate_.resize(triangles);
  planes_.resize(triangles);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const std::array<std::uint32_t, 3> p = {point_at(3 * t), point_at(3 * t + 1), point_at(3 * t + 2)};
    degenerate_[t] = p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
    if (degenerate_[t]) continue;
    const Vector origin = position(mesh_.triangles[3 * t]);
    planes_[t] = cross(position(mesh_.triangles[3 * t + 1]) - origin, position(mesh_.triangles[3 * t + 2]) - origin);
    for (std::uint32_t k = 0; k < 3; ++k) sides_.push_back({t, k});
  }
  const auto ends = [&](const Side& side) {
    return std::minmax({point_at(3 * side.triangle + side.k), point_at(3 * side.triangle + (side.k + 1) % 3)});
  };
  std::stable_sort(sides_.begin(), sides_.end(), [&](const Side& a, const Side& b) { return ends(a) < ends(b); });
  for (std::uint32_t i = 0; i < sides_.size(); ++i) {
    const auto [a, b] = ends(sides_[i]);
    if (edges_.empty() || edges_.back().a != a || edges_.back().b != b) edges_.push_back({a, b, i, 0, false});
    ++edges_.back().count;
  }
}

std::uint32_t SurfacePoints::corner_of(const Side& side, std::uint32_t point) const {
  const std::uint32_t corner = 3 * side.triangle + side.k;
  return point_at(corner) == point ? corner : 3 * side.triangle + (side.k + 1) % 3;
}

bool SurfacePoints::normals_differ(const Edge& edge) const {
  const Side& one = sides_[edge.first];
  const Side& two = sides_[edge.first + 1];
  for (const std::uint32_t point : {edge.a, edge.b}) {
    const Vector a = given_normal(mesh_.triangles[corner_of(one, point)]);
    const Vector b = given_normal(mesh_.triangles[corner_of(two, point)]);
    if (!is_zero(a) && !is_zero(b) && angle_between(a, b) > same_normal_degrees * radians) return true;
  }
  return false;
}

void SurfacePoints::mark_creases(double crease_degrees) {
  for (Edge& edge : edges_) {
    if (edge.count == 1) continue;
    const Side& one = sides_[edge.first];
    const Side& two = sides_[edge.first + 1];
    const bool same_way = point_at(3 * one.triangle + one.k) == point_at(3 * two.triangle + two.k);
    const Vector& plane = planes_[one.triangle];
    const Vector& other = planes_[two.triangle];
    const bool folded = mesh_.normals.empty() && !is_zero(plane) && !is_zero(other) &&
                        angle_between(plane, other) > crease_degrees * radians;
    edge.crease = edge.count > 2 || same_way || folded || normals_differ(edge);
  }
}

const Edge* SurfacePoints::find(std::uint32_t a, std::uint32_t b) const {
  const auto [least, most] = std::minmax(a, b);
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), std::pair(least, most),
                       [](const Edge& edge, const auto& ends) { return std::pair(edge.a, edge.b) < ends; });
  return found != edges_.end() && found->a == least && found->b == most ? &*found : nullptr;
}

void SurfacePoints::name_creases() {
  for (std::size_t i = 0; i + 1 < mesh_.creases.size(); i += 2) {
    const Edge* edge = find(point_of_[mesh_.creases[i]], point_of_[mesh_.creases[i + 1]]);
    if (edge == nullptr)
      throw Error(Element::crease, i / 2,
                  fmt::format("from vertex {} to {} is not an edge of a triangle; leave it out", mesh_.creases[i],
                              mesh_.creases[i + 1]));
    edges_[static_cast<std::size_t>(edge - edges_.data())].crease = true;
  }
}

void SurfacePoints::find_sectors() {
  common::DisjointSets corners(mesh_.triangles.size());
  for (const Edge& edge : edges_) {
    if (edge.crease || edge.count != 2) continue;
    for (const std::uint32_t point : {edge.a, edge.b}) {
      corners.join(corner_of(sides_[edge.first], point), corner_of(sides_[edge.first + 1], point));
    }
  }
  sector_.resize(corners.size());
  sectors_.resize(point_count_);
  for (std::uint32_t corner = 0; corner < sector_.size(); ++corner) {
    sector_[corner] = corners.find(corner);
    if (sector_[corner] == corner && !degenerate_[corner / 3]) sectors_[point_at(corner)].push_back(corner);
  }
}

// Computes the normal of each sector: a mean of the given normals, or else of the normals of the triangles' planes. The
// weights are the angles of the triangles at the point.
void SurfacePoints::find_normals() {
  normals_.assign(sector_.size(), {0, 0, 0});
  std::vector<Vector> of_planes(sector_.size(), {0, 0, 0});
  for (std::uint32_t corner = 0; corner < sector_.size(); ++corner) {
    const std::uint32_t t = corner / 3;
    if (degenerate_[t]) continue;
    const std::uint32_t k = corner % 3;
    const Vector origin = position(mesh_.triangles[corner]);
    const double angle = angle_between(position(mesh_.triangles[3 * t + (k + 1) % 3]) - origin,
                                       position(mesh_.triangles[3 * t + (k + 2) % 3]) - origin);
    Vector& plane = of_planes[sector_[corner]];
    plane += angle * unit(planes_[t]);
    Vector& normal = normals_[sector_[corner]];
    normal += angle * given_normal(mesh_.triangles[corner]);
  }
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    normals_[i] = unit(is_zero(unit(normals_[i])) ? of_planes[i] : normals_[i]);
    if (is_zero(normals_[i])) normals_[i] = {0, 0, 1};
  }
}

}  // namespace glark::pn
