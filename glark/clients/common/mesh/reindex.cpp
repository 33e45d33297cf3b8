// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/mesh/reindex.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <utility>

namespace glark::common {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

Triangle sorted(const std::uint32_t* corners) {
  Triangle result{corners[0], corners[1], corners[2]};
  if (result[0] > result[1]) std::swap(result[0], result[1]);
  if (result[1] > result[2]) std::swap(result[1], result[2]);
  if (result[0] > result[1]) std::swap(result[0], result[1]);
  return result;
}

// Returns whether the corners are a rotation of the sorted corners.
bool runs_up(const std::uint32_t* corners) {
  return (corners[0] < corners[1]) + (corners[1] < corners[2]) + (corners[2] < corners[0]) == 2;
}

constexpr std::uint32_t gone = 0xFFFFFFFF;

// The edge of a triangle opposite to one of its corners.
struct Link {
  std::uint32_t from, to;
};

// Checks that the triangles around a vertex form one fan: their links form one path, or one ring of at least three
// links.
class Fans {
 public:
  explicit Fans(std::size_t vertices) : links_(vertices) {}

  bool is_fan(std::uint32_t vertex, std::span<const Link> links) {
    if (links.empty()) return true;
    for (const Link& link : links) {
      if (links_[link.from].vertex == vertex + 1) return false;
      links_[link.from] = {vertex + 1, link.to};
    }
    const std::uint32_t start = links[0].from;
    std::uint32_t at = start;
    std::size_t steps = 0;
    do {
      at = links_[at].to;
      ++steps;
    } while (at != start && links_[at].vertex == vertex + 1 && steps < links.size());
    if (at == start) return steps == links.size() && steps > 2;
    if (links_[at].vertex == vertex + 1) return false;
    for (at = start; steps < links.size(); ++steps) {  // the links before the first
      const auto before = std::find_if(links.begin(), links.end(), [&](const Link& link) { return link.to == at; });
      if (before == links.end()) return false;
      at = before->from;
    }
    return true;
  }

 private:
  struct Of {
    std::uint32_t vertex = 0;  // the last vertex that has this link, plus 1
    std::uint32_t to = 0;
  };
  std::vector<Of> links_;  // indexed by Link::from
};

}  // namespace

std::vector<std::uint32_t> spanning(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters,
                                    const Workers& workers) {
  constexpr std::size_t piece = 1 << 15;  // in triangles
  std::vector<std::vector<std::uint32_t>> found((triangles.size() / 3 + piece - 1) / piece);
  workers.in_pieces(triangles.size() / 3, piece, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t>& mine = found[begin / piece];
    std::array<std::uint32_t, 1024> some;
    std::uint32_t* to = some.data();
    for (std::size_t t = 3 * begin; t < 3 * end; t += 3) {
      const std::uint32_t a = clusters[triangles[t]], b = clusters[triangles[t + 1]], c = clusters[triangles[t + 2]];
      *to++ = a;
      *to++ = b;
      *to++ = c;
      to -= static_cast<unsigned>((a == b) | (b == c) | (c == a)) * 3;  // no branch, because it would be mispredicted
      if (to - some.data() < static_cast<std::ptrdiff_t>(some.size()) - 3) continue;
      mine.insert(mine.end(), some.data(), to);
      to = some.data();
    }
    mine.insert(mine.end(), some.data(), to);
  });
  std::vector<std::uint32_t> all;
  for (const std::vector<std::uint32_t>& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::vector<std::uint8_t> irregular_vertices(std::span<const std::uint32_t> triangles, std::size_t vertices) {
  std::vector<std::uint32_t> begins(vertices + 2);
  for (const std::uint32_t vertex : triangles) ++begins[vertex + 2];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  const auto links = std::make_unique_for_overwrite<Link[]>(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const std::uint32_t a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
    links[begins[a + 1]++] = {b, c};
    links[begins[b + 1]++] = {c, a};
    links[begins[c + 1]++] = {a, b};
  }
  std::vector<std::uint8_t> result(vertices);
  Fans fans(vertices);
  for (std::uint32_t i = 0; i < vertices; ++i)
    result[i] = fans.is_fan(i, {links.get() + begins[i], begins[i + 1] - begins[i]}) ? 0 : 1;
  return result;
}

std::vector<std::uint32_t> without_repeats(std::vector<std::uint32_t> all, std::span<const std::uint8_t> irregular) {
  // Triangles that may occur twice, sorted by their corners.
  std::vector<std::pair<Triangle, std::uint32_t>> some;
  for (std::uint32_t t = 0; t < all.size(); t += 3) {
    if ((irregular[all[t]] & irregular[all[t + 1]] & irregular[all[t + 2]]) != 0) some.emplace_back(sorted(&all[t]), t);
  }
  std::sort(some.begin(), some.end());
  bool any = false;
  for (std::size_t i = 0; i < some.size();) {
    const bool up = runs_up(&all[some[i].second]);
    int balance = 0;  // triangles oriented as the first, minus the others
    std::size_t end = i;
    for (; end < some.size() && some[end].first == some[i].first; ++end)
      balance += runs_up(&all[some[end].second]) == up ? 1 : -1;
    for (int left = std::abs(balance); i < end; ++i) {
      std::uint32_t* const triangle = &all[some[i].second];
      const bool stays = left > 0 && (runs_up(triangle) == up) == (balance > 0);
      if (stays) {
        --left;
      } else {
        triangle[0] = triangle[1] = triangle[2] = gone;
        any = true;
      }
    }
  }
  if (any) std::erase(all, gone);
  return all;
}

}  // namespace glark::common
