// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/depth/curvature_tensors.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/vertex_normals.h"

namespace glark::depth {
namespace {

using common::vector_at;
using Vector = CurvatureTensors::Vector;
using Tensor = CurvatureTensors::Tensor;
using Axes = CurvatureTensors::Axes;

// Fits the tensor that maps the edges of a face to the differences of the normals at their ends, by least squares.
// Returns false if the face is degenerate or too thin.
bool fit_tensor(const Vector edges[3], const Vector normals[3], const Axes& axes, Tensor& tensor) {
  double uu = 0;
  double uv = 0;
  double vv = 0;
  double right[3] = {0, 0, 0};
  for (int corner = 0; corner < 3; ++corner) {  // edge k lies opposite to corner k
    const double u = dot(edges[corner], axes.first);
    const double v = dot(edges[corner], axes.second);
    const Vector turn = normals[(corner + 2) % 3] - normals[(corner + 1) % 3];
    const double du = dot(turn, axes.first);
    const double dv = dot(turn, axes.second);
    uu += u * u;
    uv += u * v;
    vv += v * v;
    right[0] += du * u;
    right[1] += du * v + dv * u;
    right[2] += dv * v;
  }
  // Solves [uu uv 0; uv uu+vv uv; 0 uv vv] x = right by Cramer's rule.
  const double sum = uu + vv;
  const double area = uu * vv - uv * uv;  // 12 times the squared area
  const double determinant = sum * area;
  if (!(area > 1e-12 * sum * sum)) return false;
  const double e = (right[0] * (sum * vv - uv * uv) - right[1] * uv * vv + right[2] * uv * uv) / determinant;
  const double f = (right[1] * uu * vv - uv * (right[0] * vv + right[2] * uu)) / determinant;
  const double g = (right[2] * (sum * uu - uv * uv) - right[1] * uv * uu + right[0] * uv * uv) / determinant;
  tensor = {static_cast<float>(e), static_cast<float>(f), static_cast<float>(g)};
  return std::isfinite(tensor.x) && std::isfinite(tensor.y) && std::isfinite(tensor.z);
}

// Rotates the axes about the line where both planes meet, until they lie in the plane of `normal`.
Axes turned(const Axes& axes, const Vector& normal) {
  const Vector old = cross(axes.first, axes.second);
  const float cosine = dot(old, normal);
  if (cosine <= -0.9999F) return {-1.0F * axes.first, -1.0F * axes.second};
  const Vector within = normal - cosine * old;
  const Vector sum = 1 / (1 + cosine) * (old + normal);
  return {axes.first - dot(axes.first, within) * sum, axes.second - dot(axes.second, within) * sum};
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

// Returns the part of a triangle's area that is nearest to each corner. This is the Voronoi area; if an angle is
// obtuse, it is cut at the middles of the edges.
Vector corner_areas(const Vector edges[3]) {
  const float area = 0.5F * robust_length(cross(edges[0], edges[1]));
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

void CurvatureTensors::find_normals(std::span<const std::uint32_t> triangles, std::span<const float> positions,
                                    std::span<const float> normals) {
  std::fill(normals_.begin(), normals_.end(), Vector{});
  common::add_triangle_normals(
      triangles, [&](std::uint32_t vertex) { return vector_at(positions, vertex); },
      [&](std::uint32_t vertex, Vector normal) { normals_[vertex] += normal; });
  for (std::size_t vertex = 0; vertex < normals_.size(); ++vertex) {
    const Vector given = normals.empty() ? Vector{} : unit(vector_at(normals, vertex));
    normals_[vertex] = is_zero(given) ? unit(normals_[vertex]) : given;
  }
}

void CurvatureTensors::find_areas(std::span<const std::uint32_t> triangles, std::span<const float> positions) {
  std::fill(areas_.begin(), areas_.end(), 0.0F);
  for (std::size_t t = 0; t < corner_areas_.size(); ++t) {
    const std::uint32_t* const corner = &triangles[3 * t];
    Vector edges[3];
    for (std::size_t k = 0; k < 3; ++k)
      edges[k] = vector_at(positions, corner[(k + 2) % 3]) - vector_at(positions, corner[(k + 1) % 3]);
    corner_areas_[t] = Vector{};
    if (robust_length(cross(edges[0], edges[1])) > 0) corner_areas_[t] = corner_areas(edges);
    for (std::size_t k = 0; k < 3; ++k) areas_[corner[k]] += corner_areas_[t][k];
  }
}

// The first axis of a tangent plane follows an edge.
void CurvatureTensors::find_axes(std::span<const std::uint32_t> triangles, std::span<const float> positions) {
  std::fill(axes_.begin(), axes_.end(), Axes{});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i];
    const std::uint32_t b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    if (is_zero(axes_[a].first))
      axes_[a].first = unit(cross(vector_at(positions, b) - vector_at(positions, a), normals_[a]));
  }
  for (std::size_t vertex = 0; vertex < axes_.size(); ++vertex)
    axes_[vertex].second = cross(normals_[vertex], axes_[vertex].first);
}

void CurvatureTensors::add_tensor(std::span<const std::uint32_t> triangles, std::span<const float> positions,
                                  std::size_t triangle) {
  const std::uint32_t* const corner = &triangles[3 * triangle];
  Vector edges[3];
  Vector normals[3];
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = vector_at(positions, corner[(k + 2) % 3]) - vector_at(positions, corner[(k + 1) % 3]);
    normals[k] = normals_[corner[k]];
  }
  const Vector face = unit(cross(edges[0], edges[1]));
  const Vector first = unit(edges[0]);
  const Axes axes{first, cross(face, first)};
  Tensor tensor;
  if (is_zero(face) || !fit_tensor(edges, normals, axes, tensor)) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = corner[k];
    if (!(areas_[vertex] > 0) || is_zero(axes_[vertex].first)) continue;
    const Tensor there = in_axes(tensor, axes, turned(axes_[vertex], face));
    tensors_[vertex] += corner_areas_[triangle][k] / areas_[vertex] * there;
  }
}

void CurvatureTensors::find(std::span<const std::uint32_t> triangles, std::span<const float> positions,
                            std::span<const float> normals) {
  find_normals(triangles, positions, normals);
  find_areas(triangles, positions);
  find_axes(triangles, positions);
  std::fill(tensors_.begin(), tensors_.end(), Tensor{});
  for (std::size_t t = 0; t < corner_areas_.size(); ++t) add_tensor(triangles, positions, t);
}

std::pair<float, float> CurvatureTensors::principal(std::size_t vertex) const {
  const Tensor& tensor = tensors_[vertex];
  const float mean = 0.5F * (tensor.x + tensor.z);
  const float spread = std::hypot(0.5F * (tensor.x - tensor.z), tensor.y);
  if (!std::isfinite(mean) || !std::isfinite(spread)) return {0.0F, 0.0F};
  return {mean + spread, mean - spread};
}

}  // namespace glark::depth
