// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/mesh/repeated_edges.h"

#include <algorithm>

#include "glark/clients/common/mesh/half_edges.h"
#include "glark/clients/common/mesh/reindex.h"

namespace glark::reconstruct {
namespace {

constexpr int most_rounds = 4;  // a round divides at most one edge of a triangle

struct HalfEdge {
  std::uint64_t edge;  // the upper half is the lesser end
  std::uint32_t corner;
  auto operator<=>(const HalfEdge&) const = default;
};

// Two half-edges of opposite directions.
struct Pair {
  float bend;
  std::uint32_t up, down;
};

class Division {
 public:
  explicit Division(BaseMesh& mesh) : mesh_(mesh) {}

  // Returns whether any edge was divided.
  bool run() {
    const std::vector<HalfEdge> half_edges = at_irregular_vertices();
    const std::size_t before = mesh_.points.size();
    divided_.assign(mesh_.triangles.size() / 3, false);
    for (std::size_t begin = 0, end = 0; begin < half_edges.size(); begin = end) {
      while (end < half_edges.size() && half_edges[end].edge == half_edges[begin].edge) ++end;
      if (end - begin > 2) divide({half_edges.data() + begin, end - begin});
    }
    return mesh_.points.size() > before;
  }

 private:
  std::vector<HalfEdge> at_irregular_vertices() const {
    const std::vector<std::uint8_t> irregular = irregular_vertices(mesh_.triangles, mesh_.points.size());
    std::vector<HalfEdge> result;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      const std::uint32_t a = mesh_.triangles[i], b = mesh_.triangles[next_corner(i)];
      if ((irregular[a] & irregular[b]) != 0)
        result.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), i});
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  Float4 normal_of(std::uint32_t corner) const {
    const std::uint32_t* const v = &mesh_.triangles[corner - corner % 3];
    const Float4 a = mesh_.points[v[0]];
    return unit(cross(mesh_.points[v[1]] - a, mesh_.points[v[2]] - a));
  }

  // Keeps the edge for the two triangles that bend least. The other pairs get vertices of their own.
  void divide(std::span<const HalfEdge> edge) {
    std::vector<Pair> pairs;
    for (const HalfEdge& a : edge) {
      for (const HalfEdge& b : edge) {
        const bool runs_up = mesh_.triangles[a.corner] < mesh_.triangles[next_corner(a.corner)];
        if (runs_up && mesh_.triangles[a.corner] != mesh_.triangles[b.corner])
          pairs.push_back({-dot(normal_of(a.corner), normal_of(b.corner)), a.corner, b.corner});
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.bend < q.bend; });
    std::vector<std::uint32_t> taken;
    for (const Pair& pair : pairs) {
      if (std::find(taken.begin(), taken.end(), pair.up) != taken.end()) continue;
      if (std::find(taken.begin(), taken.end(), pair.down) != taken.end()) continue;
      if (!taken.empty()) divide(pair);
      taken.insert(taken.end(), {pair.up, pair.down});
    }
  }

  void divide(const Pair& pair) {
    if (divided_[pair.up / 3] || divided_[pair.down / 3]) return;
    const auto middle = static_cast<std::uint32_t>(mesh_.points.size());
    const Float4 a = mesh_.points[mesh_.triangles[pair.up]], b = mesh_.points[mesh_.triangles[pair.down]];
    mesh_.points.push_back(Float4((a + b) * 0.5F));
    for (const std::uint32_t corner : {pair.up, pair.down}) {
      divided_[corner / 3] = true;
      const std::uint32_t next = next_corner(corner);
      const std::uint32_t to = mesh_.triangles[next], apex = mesh_.triangles[next_corner(next)];
      mesh_.triangles[next] = middle;
      mesh_.triangles.insert(mesh_.triangles.end(), {middle, to, apex});
    }
  }

  BaseMesh& mesh_;
  std::vector<bool> divided_;  // [triangles], in this round
};

}  // namespace

bool divide_repeated_edges(BaseMesh& mesh) {
  bool any = false;
  for (int round = 0; round < most_rounds && Division(mesh).run(); ++round) any = true;
  return any;
}

}  // namespace glark::reconstruct
