// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/reindex.h"

#include <algorithm>
#include <array>

namespace glark::vstree {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

Triangle sorted(const std::uint32_t* corners) {
  Triangle result{corners[0], corners[1], corners[2]};
  if (result[0] > result[1]) std::swap(result[0], result[1]);
  if (result[1] > result[2]) std::swap(result[1], result[2]);
  if (result[0] > result[1]) std::swap(result[0], result[1]);
  return result;
}

// Whether the corners run as their sorted ones do, but for where they begin.
bool runs_up(const std::uint32_t* corners) {
  return (corners[0] < corners[1]) + (corners[1] < corners[2]) + (corners[2] < corners[0]) == 2;
}

}  // namespace

std::vector<std::uint32_t> spanning(std::span<const std::uint32_t> triangles, std::span<const std::uint32_t> clusters,
                                    const Workers& workers) {
  constexpr std::size_t piece = 1 << 15;  // triangles
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
      to -= static_cast<unsigned>((a == b) | (b == c) | (c == a)) * 3;  // a branch would be foretold badly
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

std::vector<std::uint32_t> without_repeats(std::span<const std::uint32_t> all, std::size_t clusters) {
  // Lists of the triangles whose least corner a cluster is: they have the few to compare with.
  std::vector<std::uint32_t> first(clusters, 0xFFFFFFFF), next(all.size() / 3, 0xFFFFFFFF);
  std::vector<int> balance(all.size() /
                           3);  // of all with its corners, at the first: those that run its way less the others
  for (std::uint32_t t = 0; t < balance.size(); ++t) {
    const Triangle mine = sorted(&all[3 * std::size_t{t}]);
    std::uint32_t same = first[mine[0]];
    while (same != 0xFFFFFFFF && sorted(&all[3 * std::size_t{same}]) != mine) same = next[same];
    if (same == 0xFFFFFFFF) {
      next[t] = first[mine[0]];
      first[mine[0]] = t;
      same = t;
    }
    balance[same] += runs_up(&all[3 * std::size_t{t}]) == runs_up(&all[3 * std::size_t{same}]) ? 1 : -1;
  }
  std::vector<std::uint32_t> kept;
  kept.reserve(all.size());
  for (std::size_t t = 0; t < balance.size(); ++t) {
    if (balance[t] > 0) kept.insert(kept.end(), {all[3 * t], all[3 * t + 1], all[3 * t + 2]});
    if (balance[t] < 0) kept.insert(kept.end(), {all[3 * t], all[3 * t + 2], all[3 * t + 1]});
  }
  return kept;
}

}  // namespace glark::vstree
