// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/mesh/refinement.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/common/mesh/half_edges.h"
#include "glark/clients/reconstruct/mesh/coarse_colours.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t grain = 1024;
// This many consecutive triangles share one search for samples. Most pairs are the two halves of a quadrilateral.
constexpr std::uint32_t group = 2;
constexpr float edges_to_noise = 6;  // relative to the noise; shorter edges are not divided

class Refinement {
 public:
  Refinement(const Octree& octree, const Workers& workers, BaseMesh& base)
      : octree_(octree),
        workers_(workers),
        side_(octree.finest().side()),
        reach_(std::min(0.7F * side_, 0.45F * side_ + 2.5F * octree.noise)) {
    mesh_.points = std::move(base.points);
    mesh_.normals = std::move(base.normals);
    mesh_.triangles = std::move(base.triangles);
    opposite_ = std::move(base.opposite);
    if (octree.has_colours)
      mesh_.colours = coarse_colours(mesh_.points, mesh_.normals, mesh_.triangles, octree, workers);
  }

  RefinedMesh run(const ReconstructOptions& options) {
    const auto goal = static_cast<double>(options.error * octree_.cube.diagonal);
    float edge = side_;
    for (bool ends = options.levels == 0 || !is_divided(edge); !ends;) {
      edge /= 2;
      const std::size_t vertices = mesh_.points.size();
      const Edges edges = edges_to_divide();
      const double error = insert(edges);
      if (mesh_.levels == 0 && goal > 0 && error <= goal) {
        take_back(vertices);
        break;
      }
      // Halving the edges divides the distance by four.
      ends = ++mesh_.levels == options.levels || !is_divided(edge) || error / 4 <= goal;
      divide(edges, ends);
    }
    return std::move(mesh_);
  }

 private:
  bool is_divided(float edge) const { return edge > edges_to_noise * octree_.noise; }

  // Inserts the middle of the curve that PN triangles have over an edge.
  // Source: A. Vlachos et al., Curved PN Triangles, 2001.
  void insert(std::uint32_t corner, std::uint32_t vertex) {
    const std::uint32_t a = mesh_.triangles[corner], b = mesh_.triangles[next_corner(corner)];
    const Float4 along = mesh_.points[b] - mesh_.points[a];
    const Float4 na = without_fourth(mesh_.normals[a]), nb = without_fourth(mesh_.normals[b]);
    const Float4 bulge = (nb * dot(along, nb) - na * dot(along, na)) * 0.125F;
    mesh_.points[vertex] = (mesh_.points[a] + mesh_.points[b]) * 0.5F + bulge;
    mesh_.normals[vertex] = unit(na + nb);
    if (dot(mesh_.normals[vertex], mesh_.normals[vertex]) == 0) mesh_.normals[vertex] = na;
    if (!mesh_.colours.empty()) mesh_.colours[vertex] = (mesh_.colours[a] + mesh_.colours[b]) * 0.5F;
  }

  // Moves the new vertices of a few triangles, which need about the same samples.
  void move_to_surface(std::uint32_t begin, std::uint32_t end, LocalSurface& surface) {
    if (begin == end) return;
    const Float4 reach = Float4{1, 1, 1, 0} * reach_;
    Float4 low = mesh_.points[begin], high = low;
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      low = least(low, mesh_.points[i]);
      high = greatest(high, mesh_.points[i]);
    }
    surface.look_around(low - reach, high + reach);
    for (std::uint32_t i = begin; i < end; ++i) {
      const LocalEstimate estimate = surface.near(mesh_.points[i], mesh_.normals[i], reach_);
      if (!estimate.found) continue;
      mesh_.points[i] = estimate.point;
      mesh_.normals[i] = estimate.normal;
      if (!mesh_.colours.empty()) mesh_.colours[i] = estimate.colour;
      mesh_.normals[i][3] = 1;
    }
  }

  // The edges that get a new vertex, in the order of the groups. Each edge is given by one of its corners.
  struct Edges {
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> groups;  // the first edge of each group, and the end of the last group
    std::vector<std::uint32_t> middle;  // the new vertex on the edge of each corner
  };

  Edges edges_to_divide() const {
    const auto corners = static_cast<std::uint32_t>(mesh_.triangles.size());
    const std::uint32_t corners_a_group = (3 * group) << (2 * mesh_.levels);
    Edges edges{.corners = {}, .groups = {0}, .middle = std::vector<std::uint32_t>(corners)};
    edges.corners.reserve(corners / 2 + corners / 16);
    auto vertices = static_cast<std::uint32_t>(mesh_.points.size());
    for (std::uint32_t i = 0; i < corners;) {
      for (const std::uint32_t end = std::min(corners, i + corners_a_group); i < end; ++i) {
        if (opposite_[i] < i) {
          edges.middle[i] = edges.middle[opposite_[i]];
        } else {
          edges.middle[i] = vertices++;
          edges.corners.push_back(i);
        }
      }
      edges.groups.push_back(static_cast<std::uint32_t>(edges.corners.size()));
    }
    return edges;
  }

  // Inserts the vertices. Returns the approximate root mean square distance of the mesh from the surface.
  double insert(const Edges& edges) {
    const std::vector<std::uint32_t>& groups = edges.groups;
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    mesh_.points.resize(first + edges.corners.size());
    mesh_.normals.resize(first + edges.corners.size());
    if (!mesh_.colours.empty()) mesh_.colours.resize(first + edges.corners.size());
    workers_.each(groups.size() - 1, grain, [&](std::size_t begin, std::size_t end) {
      LocalSurface surface(octree_);
      for (std::size_t g = begin; g < end; ++g) {
        for (std::uint32_t i = groups[g]; i < groups[g + 1]; ++i) insert(edges.corners[i], first + i);
        move_to_surface(first + groups[g], first + groups[g + 1], surface);
      }
    });
    double squares = 0;
    for (std::size_t i = 0; i < edges.corners.size(); ++i) {
      const std::uint32_t a = edges.corners[i], b = next_corner(a);
      const Float4 d =
          mesh_.points[first + i] - (mesh_.points[mesh_.triangles[a]] + mesh_.points[mesh_.triangles[b]]) * 0.5F;
      squares += static_cast<double>(dot(d, d));
    }
    return edges.corners.empty() ? 0 : std::sqrt(squares / static_cast<double>(edges.corners.size()));
  }

  void take_back(std::size_t vertices) {
    mesh_.points.resize(vertices);
    mesh_.normals.resize(vertices);
    if (!mesh_.colours.empty()) mesh_.colours.resize(vertices);
  }

  void divide(const Edges& edges, bool is_last) {
    const std::size_t corners = mesh_.triangles.size();
    std::vector<std::uint32_t> triangles(4 * corners), opposite(is_last ? 0 : 4 * corners);
    workers_.each(corners / 3, grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        children_of(static_cast<std::uint32_t>(t), edges.middle, triangles);
        if (!is_last) children_against(static_cast<std::uint32_t>(t), opposite);
      }
    });
    mesh_.triangles = std::move(triangles);
    opposite_ = std::move(opposite);
  }

  // Child i keeps corner i. The last child lies in the middle; its half-edge i starts at the middle of edge i.
  void children_of(std::uint32_t t, const std::vector<std::uint32_t>& middle,
                   std::vector<std::uint32_t>& triangles) const {
    const std::uint32_t* const corner = &mesh_.triangles[3 * std::size_t{t}];
    const std::uint32_t* const m = &middle[3 * std::size_t{t}];
    const std::array<std::uint32_t, 12> children{corner[0], m[0], m[2],      m[0], corner[1], m[1],
                                                 m[2],      m[1], corner[2], m[0], m[1],      m[2]};
    std::copy(children.begin(), children.end(), &triangles[12 * std::size_t{t}]);
  }

  void children_against(std::uint32_t t, std::vector<std::uint32_t>& opposite) const {
    std::uint32_t* const against = &opposite[12 * std::size_t{t}];
    const auto half = [](std::uint32_t triangle, std::uint32_t child, std::uint32_t edge) {
      return 3 * (4 * triangle + child) + edge;
    };
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
      const std::uint32_t other = opposite_[3 * t + i];
      // The first half of edge i is edge i of child i, the second half is edge i of the next child.
      against[3 * i + i] = other == no_half_edge ? no_half_edge : half(other / 3, (other % 3 + 1) % 3, other % 3);
      against[3 * j + i] = other == no_half_edge ? no_half_edge : half(other / 3, other % 3, other % 3);
      against[3 * i + j] = half(t, 3, k);  // from the middle of edge i to the middle of the edge before
      against[9 + k] = half(t, i, j);
    }
  }

  const Octree& octree_;
  const Workers& workers_;
  const float side_;
  const float reach_;  // the maximum distance of samples; larger with noise
  RefinedMesh mesh_;
  std::vector<std::uint32_t> opposite_;  // as BaseMesh has it
};

}  // namespace

RefinedMesh refine(BaseMesh base, const Octree& octree, const ReconstructOptions& options, const Workers& workers) {
  return Refinement(octree, workers, base).run(options);
}

}  // namespace glark::reconstruct
