// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: Boubekeur 2007, ch. 8.2. Delta is scaled as N is, so that sharpness 1 restores the normals of both sides.
// Our additions: creases have numbers, and points where several creases meet keep all their normals.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "glark/clients/common/error_message.h"
#include "glark/clients/pn/surface_points.h"

namespace glark::pn {

namespace {

const char* name_of(Element element) {
  switch (element) {
    case Element::vertex: return "vertex";
    case Element::triangle: return "triangle";
    case Element::crease: return "crease";
    case Element::option: return "option";
    case Element::array: break;
  }
  return "array";
}

std::optional<std::size_t> number_of(Element element, std::size_t index) {
  const bool is_one_of_many = element != Element::option && element != Element::array;
  return is_one_of_many ? std::optional(index) : std::nullopt;
}

}  // namespace

Error::Error(Element element, std::size_t index, const std::string& what)
    : ElementError(element, index,
                   common::error_message("glark-pn", name_of(element), number_of(element, index), what)) {}

namespace {

constexpr std::uint32_t none = ~0U;

// The tags that all vertices at a point share.
struct PointTags {
  enum class Kind { smooth, crease, corner };
  Kind kind = Kind::smooth;
  std::uint32_t plus = none;  // the two sectors at a crease
  std::uint32_t minus = none;
  float number = 1;  // the number of the crease
};
using Kind = PointTags::Kind;

class TagDerivation {
 public:
  TagDerivation(const Mesh& mesh, const Options& options)
      : mesh_(mesh), options_(options), points_(mesh, options.crease_degrees) {}

  TaggedMesh derive() {
    classify();
    follow_creases();
    copy_vertices();
    part_corners();
    write_tags();
    if (options_.split) split_edges();
    return std::move(result_);
  }

 private:
  void classify() {
    tags_.resize(points_.count());
    std::vector<unsigned> creases(points_.count());
    for (const Edge& edge : points_.edges()) {
      creases[edge.a] += edge.crease ? 1 : 0;
      creases[edge.b] += edge.crease ? 1 : 0;
    }
    for (std::uint32_t point = 0; point < points_.count(); ++point) {
      const std::vector<std::uint32_t>& sectors = points_.sectors()[point];
      if (sectors.size() < 2) continue;
      const Vector both = points_.normal(sectors[0]) + points_.normal(sectors[1]);
      const bool one_crease = sectors.size() == 2 && creases[point] > 0 && length(both) > 1e-3;
      tags_[point].kind = one_crease ? Kind::crease : Kind::corner;
      tags_[point].number = one_crease ? 1.0F : 0.0F;
      ++(one_crease ? result_.crease_vertices : result_.corners);
      if (one_crease) std::tie(tags_[point].plus, tags_[point].minus) = std::pair(sectors[0], sectors[1]);
    }
  }

  // Gives all points of a crease the same number, and keeps N+ on the same side of the crease.
  void follow_creases() {
    std::vector<std::vector<const Edge*>> edges_of(points_.count());
    for (const Edge& edge : points_.edges()) {
      if (!edge.crease) continue;
      edges_of[edge.a].push_back(&edge);
      edges_of[edge.b].push_back(&edge);
    }
    std::vector<bool> seen(points_.count());
    float number = 1;
    for (std::uint32_t first = 0; first < points_.count(); ++first) {
      if (seen[first] || tags_[first].kind != Kind::crease) continue;
      number += 1;
      std::vector<std::uint32_t> waiting = {first};
      seen[first] = true;
      while (!waiting.empty()) {
        const std::uint32_t point = waiting.back();
        waiting.pop_back();
        tags_[point].number = number;
        for (const Edge* edge : edges_of[point]) {
          const std::uint32_t next = edge->a == point ? edge->b : edge->a;
          if (seen[next] || tags_[next].kind != Kind::crease) continue;
          seen[next] = true;
          orient(*edge, point, next);
          waiting.push_back(next);
        }
      }
    }
  }

  std::uint32_t sector_beside(const Edge& edge, std::uint32_t point) const {
    const Side& side = points_.sides()[edge.first];
    const std::uint32_t corner = 3 * side.triangle + side.k;
    return points_.sector(points_.point_at(corner) == point ? corner : 3 * side.triangle + (side.k + 1) % 3);
  }

  void orient(const Edge& edge, std::uint32_t known, std::uint32_t next) {
    const bool on_plus = sector_beside(edge, known) == tags_[known].plus;
    const bool is_plus = sector_beside(edge, next) == tags_[next].plus;
    if (on_plus != is_plus) std::swap(tags_[next].plus, tags_[next].minus);
  }

  void copy_vertices() {
    result_.positions.assign(mesh_.positions.begin(), mesh_.positions.end());
    result_.triangles.assign(mesh_.triangles.begin(), mesh_.triangles.end());
    for (std::uint32_t vertex = 0; vertex < mesh_.positions.size() / 3; ++vertex)
      result_.sources.push_back({vertex, vertex});
    for (std::uint32_t t = 0; t < mesh_.triangles.size() / 3; ++t) result_.triangle_sources.push_back(t);
    sector_of_.assign(result_.sources.size(), none);
  }

  // At a corner, each vertex belongs to one sector; the other sectors get copies of it.
  void part_corners() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies;
    for (std::uint32_t corner = 0; corner < mesh_.triangles.size(); ++corner) {
      const std::uint32_t vertex = mesh_.triangles[corner];
      if (points_.degenerate(corner / 3)) continue;
      const std::uint32_t sector = points_.sector(corner);
      if (sector_of_[vertex] == none) sector_of_[vertex] = sector;
      if (sector_of_[vertex] == sector || tags_[points_.point_of(vertex)].kind != Kind::corner) continue;
      const auto [copy, added] =
          copies.try_emplace({vertex, sector}, static_cast<std::uint32_t>(result_.sources.size()));
      if (added) {
        add_vertex({vertex, vertex});
        sector_of_.push_back(sector);
      }
      result_.triangles[corner] = copy->second;
    }
  }

  void add_vertex(const std::array<std::uint32_t, 2>& sources) {
    for (std::size_t i = 0; i < 3; ++i) {
      const float a = mesh_.positions[3 * sources[0] + i];
      const float b = mesh_.positions[3 * sources[1] + i];
      result_.positions.push_back(sources[0] == sources[1] ? a : 0.5F * a + 0.5F * b);
    }
    result_.sources.push_back(sources);
  }

  void write(const Vector& normal, const Vector& delta, float number, const std::array<float, 3>& tags) {
    for (std::size_t i = 0; i < 3; ++i) {
      result_.normals.push_back(static_cast<float>(normal[i]));
      result_.discontinuities.push_back(static_cast<float>(delta[i]));
    }
    result_.discontinuities.push_back(number);
    result_.tags.insert(result_.tags.end(), tags.begin(), tags.end());
  }

  void write_tags() {
    for (std::uint32_t vertex = 0; vertex < result_.sources.size(); ++vertex) {
      const std::uint32_t point = points_.point_of(result_.sources[vertex][0]);
      const PointTags& tags = tags_[point];
      if (tags.kind == Kind::crease) {
        const Vector plus = points_.normal(tags.plus);
        const Vector minus = points_.normal(tags.minus);
        write(unit(plus + minus), (1 / length(plus + minus)) * (plus - minus), tags.number,
              {options_.sharpness, options_.tension, options_.bias});
      } else if (tags.kind == Kind::corner) {
        const Vector normal = normal_of(vertex, point);
        write(normal, normal, 0, {0, 1, 0});
      } else {
        write(normal_of(vertex, point), {0, 0, 0}, 1, {0, 0, 0});
      }
    }
  }

  Vector normal_of(std::uint32_t vertex, std::uint32_t point) const {
    if (sector_of_[vertex] != none) return points_.normal(sector_of_[vertex]);
    if (!points_.sectors()[point].empty()) return points_.normal(points_.sectors()[point][0]);
    if (mesh_.normals.empty()) return {0, 0, 1};
    const auto given = mesh_.normals.subspan(std::size_t{3} * result_.sources[vertex][0], 3);
    const Vector normal = unit(Vector{given[0], given[1], given[2]});
    return !is_zero(normal) ? normal : Vector{0, 0, 1};
  }

  // Returns whether the tags at its ends would make a crease of this smooth edge. An edge between two corners is
  // straight in any case.
  bool misleads(const Edge& edge) const {
    const PointTags& a = tags_[edge.a];
    const PointTags& b = tags_[edge.b];
    if (edge.crease || a.kind == Kind::smooth || b.kind == Kind::smooth) return false;
    if (a.kind == Kind::corner && b.kind == Kind::corner) return false;
    return a.kind == Kind::corner || b.kind == Kind::corner || a.number == b.number;
  }

  void split_edges() {
    std::vector<bool> split(result_.triangles.size());  // indexed by side: 3 t + k
    for (const Edge& edge : points_.edges()) {
      if (!misleads(edge)) continue;
      for (std::uint32_t i = edge.first; i < edge.first + edge.count; ++i) {
        const Side& side = points_.sides()[i];
        split[3 * side.triangle + side.k] = true;
      }
    }
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> sources;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    for (std::uint32_t t = 0; t < result_.triangles.size() / 3; ++t) {
      std::array<std::uint32_t, 3> c{};
      std::array<std::uint32_t, 3> m = {none, none, none};
      for (std::uint32_t k = 0; k < 3; ++k) {
        c.at(k) = result_.triangles[3 * t + k];
        if (split[3 * t + k]) m.at(k) = middle(middles, 3 * t + k, 3 * t + (k + 1) % 3);
      }
      append_split(triangles, c, m);
      sources.resize(triangles.size() / 3, t);
    }
    result_.triangles = std::move(triangles);
    result_.triangle_sources = std::move(sources);
  }

  std::uint32_t middle(std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& middles, std::uint32_t corner,
                       std::uint32_t next) {
    const auto ends = std::minmax(result_.triangles[corner], result_.triangles[next]);
    const auto [found, added] = middles.try_emplace(ends, static_cast<std::uint32_t>(result_.sources.size()));
    if (added) {
      add_vertex({result_.sources[ends.first][0], result_.sources[ends.second][0]});
      const Vector sum = points_.normal(points_.sector(corner)) + points_.normal(points_.sector(next));
      write(is_zero(sum) ? points_.normal(points_.sector(corner)) : unit(sum), {0, 0, 0}, 1, {0, 0, 0});
    }
    return found->second;
  }

  static void append_split(std::vector<std::uint32_t>& triangles, const std::array<std::uint32_t, 3>& c,
                           const std::array<std::uint32_t, 3>& m) {
    const auto append = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
      triangles.insert(triangles.end(), {a, b, d});
    };
    const auto count = 3 - std::count(m.begin(), m.end(), none);
    if (count == 0) return append(c[0], c[1], c[2]);
    if (count == 3) {
      for (std::size_t k = 0; k < 3; ++k) append(c[k], m[k], m[(k + 2) % 3]);
      return append(m[0], m[1], m[2]);
    }
    // Finds the corner after which a split edge follows one that is not split.
    std::size_t k = 0;
    while (m[k] == none || m[(k + 2) % 3] != none) ++k;
    const std::uint32_t next = c[(k + 1) % 3];
    const std::uint32_t last = c[(k + 2) % 3];
    if (count == 1) {
      append(c[k], m[k], last);
      return append(m[k], next, last);
    }
    const std::uint32_t second = m[(k + 1) % 3];
    append(m[k], next, second);
    append(c[k], m[k], second);
    append(c[k], second, last);
  }

  const Mesh& mesh_;
  const Options& options_;
  SurfacePoints points_;
  std::vector<PointTags> tags_;
  std::vector<std::uint32_t> sector_of_;  // the sector of each vertex of the result; `none`: all sectors, or no sector
  TaggedMesh result_;
};

void check(const Options& options) {
  const auto within = [](const char* name, float value, float least, float most) {
    if (value >= least && value <= most) return;
    throw Error(Element::option, 0, fmt::format("{} is {}; {} to {} is possible", name, value, least, most));
  };
  within("crease_degrees", options.crease_degrees, 0, 180);
  within("sharpness", options.sharpness, 0, 65536);
  within("tension", options.tension, -1, 1);
  within("bias", options.bias, -1, 1);
}

}  // namespace

TaggedMesh derive_tags(const Mesh& mesh, const Options& options) {
  check(options);
  return TagDerivation(mesh, options).derive();
}

}  // namespace glark::pn
