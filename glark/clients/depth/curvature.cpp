// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: S. Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes, 3DPVT 2004: a tensor for each face
// that explains best how the normals of its corners differ (section 3.1), turned into the tangent planes of its corners (3.2) and
// weighted there by the part of the face that is nearest to the corner (3.3).
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "glark/clients/depth/vector.h"

namespace glark::tagging {
namespace {

// (e, f, g) of the second fundamental form [e f; f g].
using Tensor = Vector;

struct Axes {
  Vector first;
  Vector second;
};

// The tensor that maps the edges of a face to the differences of the normals at their ends, by least squares. False: the face
// is degenerate, or so thin that there is none.
bool fit_tensor(const Vector edges[3], const Vector normals[3], const Axes& axes, Tensor& tensor) {
  double uu = 0;
  double uv = 0;
  double vv = 0;
  double right[3] = {0, 0, 0};
  for (int corner = 0; corner < 3; ++corner) {  // edge k lies opposite to corner k
    const double u = dot(edges[corner], axes.first);
    const double v = dot(edges[corner], axes.second);
    const Vector turn = minus(normals[(corner + 2) % 3], normals[(corner + 1) % 3]);
    const double du = dot(turn, axes.first);
    const double dv = dot(turn, axes.second);
    uu += u * u;
    uv += u * v;
    vv += v * v;
    right[0] += du * u;
    right[1] += du * v + dv * u;
    right[2] += dv * v;
  }
  // [uu uv 0; uv uu+vv uv; 0 uv vv] x = right, by Cramer's rule.
  const double sum = uu + vv;
  const double area = uu * vv - uv * uv;  // times 4/3, squared
  const double determinant = sum * area;
  if (!(area > 1e-12 * sum * sum)) return false;
  const double e = (right[0] * (sum * vv - uv * uv) - right[1] * uv * vv + right[2] * uv * uv) / determinant;
  const double f = (right[1] * uu * vv - uv * (right[0] * vv + right[2] * uu)) / determinant;
  const double g = (right[2] * (sum * uu - uv * uv) - right[1] * uv * uu + right[0] * uv * uv) / determinant;
  tensor = {static_cast<float>(e), static_cast<float>(f), static_cast<float>(g)};
  return std::isfinite(tensor[0]) && std::isfinite(tensor[1]) && std::isfinite(tensor[2]);
}

// Turns the axes about the line in which both planes meet until they lie in the plane of `normal`.
Axes turned(const Axes& axes, const Vector& normal) {
  const Vector old = cross(axes.first, axes.second);
  const float cosine = dot(old, normal);
  if (cosine <= -0.9999F) return {times(-1, axes.first), times(-1, axes.second)};
  const Vector within = minus(normal, times(cosine, old));
  const Vector sum = times(1 / (1 + cosine), plus(old, normal));
  return {minus(axes.first, times(dot(axes.first, within), sum)),
          minus(axes.second, times(dot(axes.second, within), sum))};
}

Tensor in_axes(const Tensor& tensor, const Axes& old, const Axes& axes) {
  const float u1 = dot(axes.first, old.first);
  const float v1 = dot(axes.first, old.second);
  const float u2 = dot(axes.second, old.first);
  const float v2 = dot(axes.second, old.second);
  return {tensor[0] * u1 * u1 + tensor[1] * (2 * u1 * v1) + tensor[2] * v1 * v1,
          tensor[0] * u1 * u2 + tensor[1] * (u1 * v2 + u2 * v1) + tensor[2] * v1 * v2,
          tensor[0] * u2 * u2 + tensor[1] * (2 * u2 * v2) + tensor[2] * v2 * v2};
}

// What of a triangle's area is nearest to each corner: Voronoi areas, cut at the middles of the edges where an angle is obtuse.
Vector corner_areas(const Vector edges[3]) {
  const float area = 0.5F * length(cross(edges[0], edges[1]));
  const Vector squares = {dot(edges[0], edges[0]), dot(edges[1], edges[1]), dot(edges[2], edges[2])};
  Vector weights;
  for (std::size_t k = 0; k < 3; ++k) {
    weights[k] = squares[k] * (squares[(k + 1) % 3] + squares[(k + 2) % 3] - squares[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (weights[k] > 0) continue;
    Vector result;
    const std::size_t after = (k + 1) % 3;
    const std::size_t before = (k + 2) % 3;
    result[after] = -0.25F * squares[before] * area / std::min(dot(edges[k], edges[before]), -1e-30F);
    result[before] = -0.25F * squares[after] * area / std::min(dot(edges[k], edges[after]), -1e-30F);
    result[k] = area - result[after] - result[before];
    return result;
  }
  const float scale = 0.5F * area / (weights[0] + weights[1] + weights[2]);
  return {scale * (weights[1] + weights[2]), scale * (weights[2] + weights[0]), scale * (weights[0] + weights[1])};
}

}  // namespace

void Tagger::find_normals(std::span<const float> positions, std::span<const float> normals) {
  // Those of the faces first, each by its area.
  std::fill(normals_.begin(), normals_.end(), Vector{});
  for (std::size_t i = 0; i < triangles_.size(); i += 3) {
    const Vector a = vector_at(positions, triangles_[i]);
    const Vector face =
        cross(minus(vector_at(positions, triangles_[i + 1]), a), minus(vector_at(positions, triangles_[i + 2]), a));
    for (std::size_t k = 0; k < 3; ++k) normals_[triangles_[i + k]] = plus(normals_[triangles_[i + k]], face);
  }
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const Vector given = normals.empty() ? Vector{} : unit(vector_at(normals, vertex));
    normals_[vertex] = given == Vector{} ? unit(normals_[vertex]) : given;
  }
}

void Tagger::find_areas(std::span<const float> positions) {
  std::fill(areas_.begin(), areas_.end(), 0.0F);
  for (std::size_t t = 0; t < corner_areas_.size(); ++t) {
    const std::uint32_t* const corner = &triangles_[3 * t];
    Vector edges[3];
    for (std::size_t k = 0; k < 3; ++k) {
      edges[k] = minus(vector_at(positions, corner[(k + 2) % 3]), vector_at(positions, corner[(k + 1) % 3]));
    }
    corner_areas_[t] = Vector{};
    if (length(cross(edges[0], edges[1])) > 0) corner_areas_[t] = corner_areas(edges);
    for (std::size_t k = 0; k < 3; ++k) areas_[corner[k]] += corner_areas_[t][k];
  }
}

// Some axes of each tangent plane: the first follows an edge.
void Tagger::find_frames(std::span<const float> positions) {
  std::fill(first_axes_.begin(), first_axes_.end(), Vector{});
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const std::uint32_t a = triangles_[i];
    const std::uint32_t b = triangles_[i % 3 == 2 ? i - 2 : i + 1];
    if (first_axes_[a] == Vector{}) {
      first_axes_[a] = unit(cross(minus(vector_at(positions, b), vector_at(positions, a)), normals_[a]));
    }
  }
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    second_axes_[vertex] = cross(normals_[vertex], first_axes_[vertex]);
  }
}

void Tagger::add_tensor(std::span<const float> positions, std::size_t triangle) {
  const std::uint32_t* const corner = &triangles_[3 * triangle];
  Vector edges[3];
  Vector normals[3];
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = minus(vector_at(positions, corner[(k + 2) % 3]), vector_at(positions, corner[(k + 1) % 3]));
    normals[k] = normals_[corner[k]];
  }
  const Vector face = unit(cross(edges[0], edges[1]));
  const Vector first = unit(edges[0]);
  const Axes axes{first, cross(face, first)};
  Tensor tensor;
  if (face == Vector{} || !fit_tensor(edges, normals, axes, tensor)) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = corner[k];
    if (!(areas_[vertex] > 0) || first_axes_[vertex] == Vector{}) continue;
    const Axes there = turned({first_axes_[vertex], second_axes_[vertex]}, face);
    const Tensor turned_tensor = in_axes(tensor, axes, there);
    tensors_[vertex] = plus(tensors_[vertex], times(corner_areas_[triangle][k] / areas_[vertex], turned_tensor));
  }
}

void Tagger::find_tensors(std::span<const float> positions, std::span<const float> normals) {
  find_normals(positions, normals);
  find_areas(positions);
  find_frames(positions);
  std::fill(tensors_.begin(), tensors_.end(), Tensor{});
  for (std::size_t t = 0; t < corner_areas_.size(); ++t) add_tensor(positions, t);
}

namespace {

std::pair<float, float> eigenvalues(const Tensor& tensor) {
  const float mean = 0.5F * (tensor[0] + tensor[2]);
  const float spread = std::hypot(0.5F * (tensor[0] - tensor[2]), tensor[1]);
  if (!std::isfinite(mean) || !std::isfinite(spread)) return {0.0F, 0.0F};
  return {mean + spread, mean - spread};
}

}  // namespace

void Tagger::principal_curvatures(std::span<const float> positions, std::span<const float> normals,
                                  std::span<float> greater, std::span<float> lesser) {
  check_positions(positions);
  check_normals(normals);
  check_target(greater);
  check_target(lesser);
  find_tensors(positions, normals);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    std::tie(greater[vertex], lesser[vertex]) = eigenvalues(tensors_[vertex]);
  }
}

// How far the arc over the longest edge rises above it.
float Tagger::sagitta(std::size_t vertex) const {
  const auto [greater, lesser] = eigenvalues(tensors_[vertex]);
  return std::max(std::abs(greater), std::abs(lesser)) * longest_[vertex] * longest_[vertex] / 8;
}

// With each level an arc keeps a quarter of that.
void Tagger::by_curvature(std::span<const float> positions, std::span<const float> normals, float tolerance,
                          std::span<float> tags) {
  check_positions(positions);
  check_normals(normals);
  check_target(tags);
  if (!(tolerance > 0)) throw Error("glark: the tolerance " + std::to_string(tolerance) + " is not above 0");
  find_tensors(positions, normals);
  measure_rings(positions);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    tags[vertex] = limited(0.5F * std::log2(std::max(sagitta(vertex) / tolerance, 1.0F)));
  }
}

void Tagger::by_curvature(std::span<const float> positions, std::span<const float> normals, const View& view,
                          float pixels, std::span<float> tags) {
  check_positions(positions);
  check_normals(normals);
  check_target(tags);
  if (!(view.pixels_at_one > 0 && view.nearest > 0 && std::isfinite(length(view.eye)) && pixels > 0)) {
    throw Error("glark: the view needs a finite eye, and pixels, a tolerance and a nearest distance above 0");
  }
  find_tensors(positions, normals);
  measure_rings(positions);
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const float distance = std::max(length(minus(vector_at(positions, vertex), view.eye)), view.nearest);
    const float size = sagitta(vertex) * view.pixels_at_one / distance;
    tags[vertex] = limited(0.5F * std::log2(std::max(size / pixels, 1.0F)));
  }
}

}  // namespace glark::tagging
