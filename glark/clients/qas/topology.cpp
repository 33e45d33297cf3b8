// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/qas/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace glark::qas {
namespace {

// The indices of all triangles and edges must fit into 32 bits, also after a split.
constexpr std::size_t most_triangles = 1U << 26;
// A surface allocates memory for each vertex. If the triangles can use only a small part of many vertices, the count is
// wrong, for example uninitialised.
constexpr std::size_t many_vertices = 1U << 22, most_unused = 256;  // vertices; vertices for each corner of a triangle

void check(const Mesh& mesh) {
  if (mesh.triangles.size() % 3 != 0) {
    throw Error(Element::triangle, mesh.triangles.size() / 3,
                fmt::format("has {} indices; every triangle takes three", mesh.triangles.size() % 3));
  }
  if (mesh.creases.size() % 2 != 0) {
    throw Error(Element::crease, mesh.creases.size() / 2, "has one end; every crease takes two");
  }
  if (mesh.triangles.size() / 3 > most_triangles || mesh.vertex_count > 3 * most_triangles) {
    throw Error(Element::mesh, 0, "has more than 2^26 triangles or three times as many vertices; split it");
  }
  if (mesh.vertex_count > many_vertices && mesh.vertex_count / most_unused > mesh.triangles.size()) {
    throw Error(Element::mesh, 0,
                fmt::format("has {} vertices, of which its {} triangles can use few; give the number of the vertices "
                            "that there are",
                            mesh.vertex_count, mesh.triangles.size() / 3));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.triangles[i] < mesh.vertex_count) continue;
    throw Error(Element::triangle, i / 3,
                fmt::format("refers to vertex {} of {}", mesh.triangles[i], mesh.vertex_count));
  }
}

// Finds copies: later triangles with the vertices of an earlier one in any order.
void find_copies(Topology& topology) {
  struct Key {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t triangle;
    bool operator<(const Key& other) const {
      return vertices != other.vertices ? vertices < other.vertices : triangle < other.triangle;
    }
  };
  const auto count = static_cast<std::uint32_t>(topology.triangles.size() / 3);
  std::vector<Key> keys(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::uint32_t* const v = &topology.triangles[3 * std::size_t{t}];
    keys[t] = {{v[0], v[1], v[2]}, t};
    std::sort(keys[t].vertices.begin(), keys[t].vertices.end());
  }
  std::sort(keys.begin(), keys.end());
  topology.same_as.resize(count);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto& v = keys[i].vertices;
    const bool degenerate = v[0] == v[1] || v[1] == v[2];
    const bool copy = i > 0 && keys[i - 1].vertices == v;
    topology.same_as[keys[i].triangle] =
        degenerate ? none : (copy ? topology.same_as[keys[i - 1].triangle] : keys[i].triangle);
  }
}

struct Side {
  std::uint64_t ends;
  std::uint32_t half_edge;
  bool operator<(const Side& other) const {
    return ends != other.ends ? ends < other.ends : half_edge < other.half_edge;
  }
};

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

std::vector<Side> sorted_sides(const Topology& topology) {
  std::vector<Side> sides;
  sides.reserve(topology.triangles.size());
  for (std::uint32_t h = 0; h < topology.triangles.size(); ++h) {
    if (topology.same_as[h / 3] != h / 3) continue;
    sides.push_back({key_of(topology.corner(h), topology.corner(Topology::after(h))), h});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Numbers the edges in the order of the triangles. So neighbours are close in memory.
void find_edges(Topology& topology, const std::vector<Side>& sides) {
  std::vector<std::uint32_t> group_of(topology.triangles.size(),
                                      none);  // for each edge, the index of its first side in `sides`
  for (std::uint32_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].ends != sides[i - 1].ends) group_of[sides[i].half_edge] = i;
  }
  topology.edge_of.assign(topology.triangles.size(), none);
  topology.sides.reserve(sides.size());
  for (std::uint32_t h = 0; h < group_of.size(); ++h) {
    if (group_of[h] == none) continue;
    const std::uint32_t a = topology.corner(h), b = topology.corner(Topology::after(h));
    Edge edge{{a, b}, static_cast<std::uint32_t>(topology.sides.size()), 0, false, false};
    for (std::size_t i = group_of[h]; i < sides.size() && sides[i].ends == sides[group_of[h]].ends; ++i) {
      topology.sides.push_back(sides[i].half_edge);
      topology.edge_of[sides[i].half_edge] = static_cast<std::uint32_t>(topology.edges.size());
      ++edge.side_count;
    }
    edge.smooth = edge.side_count == 2 && topology.corner(topology.sides.back()) != a;
    topology.edges.push_back(edge);
  }
}

void mark_creases(Topology& topology, const Mesh& mesh, const std::vector<Side>& sides) {
  for (std::size_t i = 0; i < mesh.creases.size(); i += 2) {
    const std::uint64_t ends = key_of(mesh.creases[i], mesh.creases[i + 1]);
    const auto found = std::lower_bound(sides.begin(), sides.end(), Side{ends, 0});
    if (found == sides.end() || found->ends != ends) {
      throw Error(Element::crease, i / 2,
                  fmt::format("from vertex {} to {} is not an edge of the mesh", mesh.creases[i], mesh.creases[i + 1]));
    }
    Edge& edge = topology.edges[topology.edge_of[found->half_edge]];
    edge.marked = edge.marked || edge.smooth;
    edge.smooth = false;
  }
}

// Returns the outgoing half-edge of the next triangle around the same vertex, counter-clockwise or clockwise. Returns
// none at a crease.
std::uint32_t next_about(const Topology& topology, std::uint32_t half_edge) {
  return topology.twin(Topology::before(half_edge));
}
std::uint32_t previous_about(const Topology& topology, std::uint32_t half_edge) {
  const std::uint32_t twin = topology.twin(half_edge);
  return twin == none ? none : Topology::after(twin);
}

void add_sector(Topology& topology, std::uint32_t any) {
  std::uint32_t start = any;
  for (std::uint32_t h = previous_about(topology, start); h != none && h != any; h = previous_about(topology, h))
    start = h;
  const auto index = static_cast<std::uint32_t>(topology.sectors.size());
  Sector sector{topology.corner(any), static_cast<std::uint32_t>(topology.rings.size()), 0, false};
  for (std::uint32_t h = start;;) {
    topology.sector_of[h] = index;
    topology.rings.push_back(topology.corner(Topology::after(h)));
    const std::uint32_t next = next_about(topology, h);
    if (next == none) topology.rings.push_back(topology.opposite(h));
    sector.closed = next == start;
    if (next == none || next == start) break;
    h = next;
  }
  sector.count = static_cast<std::uint32_t>(topology.rings.size()) - sector.first;
  topology.sectors.push_back(sector);
}

// Chooses Loop's rules, as Hoppe et al. (1994) extend them, by the number of creases that meet at a vertex.
void find_rules(Topology& topology) {
  topology.rules.assign(topology.vertex_count, Rule::corner);
  topology.crease_neighbours.assign(topology.vertex_count, {none, none});
  std::vector<std::uint8_t> sharp_edges(topology.vertex_count, 0);
  for (const Edge& edge : topology.edges) {
    if (edge.smooth) continue;
    for (int i = 0; i < 2; ++i) {
      const std::uint32_t v = edge.ends[static_cast<std::size_t>(i)];
      if (sharp_edges[v] < 2)
        topology.crease_neighbours[v][sharp_edges[v]] = edge.ends[static_cast<std::size_t>(1 - i)];
      sharp_edges[v] = static_cast<std::uint8_t>(std::min(sharp_edges[v] + 1, 3));
    }
  }
  std::vector<std::uint32_t> sector_count(topology.vertex_count, 0);
  for (const Sector& sector : topology.sectors) ++sector_count[sector.vertex];
  for (Sector& sector : topology.sectors) {
    const std::uint32_t v = sector.vertex;
    const bool dart =
        sharp_edges[v] == 1 && topology.rings[sector.first] == topology.rings[sector.first + sector.count - 1];
    if (dart && sector_count[v] == 1) {  // the crease ends at this vertex
      sector.closed = true;
      --sector.count;
    }
    if (sector.closed && sector_count[v] == 1) topology.rules[v] = Rule::smooth;
    if (sharp_edges[v] == 2 && !sector.closed) topology.rules[v] = Rule::crease;
  }
  // A fan that is not between the two creases makes the vertex a corner.
  for (const Sector& sector : topology.sectors) {
    const bool between =
        !sector.closed && topology.rings[sector.first] != topology.rings[sector.first + sector.count - 1];
    if (topology.rules[sector.vertex] == Rule::crease && !between) topology.rules[sector.vertex] = Rule::corner;
  }
}

}  // namespace

Topology analyse(const Mesh& mesh) {
  check(mesh);
  Topology topology;
  topology.vertex_count = static_cast<std::uint32_t>(mesh.vertex_count);
  topology.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  find_copies(topology);
  const std::vector<Side> sides = sorted_sides(topology);
  find_edges(topology, sides);
  mark_creases(topology, mesh, sides);
  topology.sector_of.assign(topology.triangles.size(), none);
  topology.rings.reserve(topology.triangles.size() + topology.triangles.size() / 4);
  for (std::uint32_t h = 0; h < topology.triangles.size(); ++h) {
    if (topology.same_as[h / 3] == h / 3 && topology.sector_of[h] == none) add_sector(topology, h);
  }
  find_rules(topology);
  return topology;
}

}  // namespace glark::qas
