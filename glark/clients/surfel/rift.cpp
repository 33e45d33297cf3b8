// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/rift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "glark/clients/surfel/comparison.h"

namespace glark::surfel {
namespace {

constexpr float turn = 4;                 // a full one, see direction_of()
constexpr float slack = 1e-3F;            // of these
constexpr std::size_t longest_loop = 32;  // edges of what is closed: beyond are open rims
constexpr float penalty = 1000;           // of a triangle that is seen from behind, or has an edge that others have
constexpr float never = std::numeric_limits<float>::infinity();

float square(float x) { return x * x; }
float wrapped(float angle) { return angle < 0 ? angle + turn : angle; }

// Where an angle's point of the diamond |x| + |y| = 1 is, along the diamond: it grows as the angle does, and opposite directions are half a turn apart.
float direction_of(float y, float x) {
  const float size = std::fabs(x) + std::fabs(y);
  if (!(size > 0)) return 0;
  const float ahead = y / size, behind = (y >= 0 ? 2.0F : -2.0F) - ahead;
  return x >= 0 ? ahead : behind;
}

Vector normal_of(const Layer& layer, std::uint32_t point) {
  const Surfel& surfel = layer.surfel(point);
  return surfel.normal == Vector{} ? layer.tree.leaves[layer.owner[point]].normal : surfel.normal;
}

}  // namespace

float badness(const Layer& layer, const StripTriangle& triangle) {
  const Vector a = layer.positions[triangle[0]], b = layer.positions[triangle[1]];
  const Vector c = layer.positions[triangle[2]];
  const Vector across = cross(b - a, c - a);
  const float doubled_area = dot(across, across);
  if (!(doubled_area > 0)) return never;
  Vector sum;
  for (const std::uint32_t corner : triangle) sum = sum + layer.surfel(corner).normal;
  const Vector normal = unit(sum);
  constexpr float least_cosine = 0.1F;
  const float cosine = normal == Vector{} ? 1 : dot(unit(across), normal);
  const float radius = dot(b - a, b - a) * dot(c - b, c - b) / doubled_area * dot(a - c, a - c);
  return radius / square(std::max(std::fabs(cosine), least_cosine)) * (cosine < 0 ? -1.0F : 1.0F);
}

void Rift::begin(std::span<const std::uint32_t> points) {
  points_ = points;
  if (fans_.size() < points.size()) fans_.resize(points.size());  // of those before, the memory is of use
  for (std::size_t i = 0; i < points.size(); ++i) {
    Fan& fan = fans_[i];
    fan.wedges.clear();
    fan.position = layer_.positions[points[i]];
    fan.normal = normal_of(layer_, points[i]);
    fan.u = perpendicular(fan.normal);
    fan.v = cross(fan.normal, fan.u);
  }
  drawn.clear();
}

Rift::Fan* Rift::fan_of(std::uint32_t point) {
  return layer_.rift_of[point] == points_.front() ? &fans_[numbers_[point]] : nullptr;
}

Rift::Wedge Rift::wedge_at(const Fan& fan, std::uint32_t first, std::uint32_t second) const {
  const auto angle_of = [&](std::uint32_t point) {
    const Vector d = layer_.positions[point] - fan.position;
    return direction_of(dot(d, fan.v), dot(d, fan.u));
  };
  Wedge wedge{first, second, angle_of(first), 0};
  const float to = angle_of(second);
  wedge.angle = wrapped(to - wedge.from);
  if (wedge.angle <= turn / 2) return wedge;
  // Without normals each point has an orientation of its own.
  if (!options_.oriented) return {second, first, to, turn - wedge.angle};
  wedge.angle = -1;
  return wedge;
}

void Rift::add_agreed(const StripTriangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    Fan* const fan = fan_of(triangle[k]);
    if (fan != nullptr) fan->wedges.push_back(wedge_at(*fan, triangle[(k + 1) % 3], triangle[(k + 2) % 3]));
  }
}

void Rift::insert(const StripTriangle& triangle) {
  add_agreed(triangle);
  drawn.push_back(triangle);
}

bool Rift::fits(const StripTriangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Fan* const fan = fan_of(triangle[k]);
    const Wedge wedge = wedge_at(*fan, triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
    for (const Wedge& other : fan->wedges) {
      if (other.first == wedge.first || other.second == wedge.second) return false;
      if (wedge.angle < 0 || other.angle < 0) continue;
      if (wrapped(other.from - wedge.from) < wedge.angle - slack) return false;
      if (wrapped(wedge.from - other.from) < other.angle - slack) return false;
    }
  }
  return true;
}

void Rift::close(std::vector<Claim>& claims) {
  std::sort(claims.begin(), claims.end(), [](const Claim& a, const Claim& b) {
    return std::tie(a.missing, a.size, a.triangle) < std::tie(b.missing, b.size, b.triangle);
  });
  for (const Claim& claim : claims) {
    if (fits(claim.triangle)) insert(claim.triangle);
  }
  if (options_.oriented) close_loops();
  std::erase_if(drawn, [&](const StripTriangle& triangle) { return stands_alone(triangle); });
}

// No edge is that of another triangle: it is in the way of nothing, nor of use.
bool Rift::stands_alone(const StripTriangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& wedges = fan_of(triangle[k])->wedges;
    const std::uint32_t next = triangle[(k + 1) % 3];
    if (std::count_if(wedges.begin(), wedges.end(),
                      [next](const Wedge& wedge) { return wedge.first == next || wedge.second == next; }) > 1) {
      return false;
    }
  }
  return true;
}

bool Rift::has_edge(std::uint32_t from, std::uint32_t to) {
  const Fan* const fan = fan_of(from);
  return std::any_of(fan->wedges.begin(), fan->wedges.end(),
                     [to](const Wedge& wedge) { return wedge.first == to || wedge.second == to; });
}

// The border of what is open comes from a point that has a triangle on the other side only, and goes on clockwise from there to the
// next of such; `none` if there is none.
std::uint32_t Rift::next_on_border(std::uint32_t before, std::uint32_t at) {
  const Fan* const fan = fan_of(at);
  if (fan == nullptr) return none;
  const auto begins = [&](std::uint32_t point) {
    return std::any_of(fan->wedges.begin(), fan->wedges.end(), [=](const Wedge& w) { return w.first == point; });
  };
  const auto angle_of = [&](std::uint32_t point) {
    const Vector d = layer_.positions[point] - fan->position;
    return direction_of(dot(d, fan->v), dot(d, fan->u));
  };
  const float from = angle_of(before);
  std::uint32_t next = none;
  float least = never;
  for (const Wedge& wedge : fan->wedges) {
    if (wedge.second == before || begins(wedge.second)) continue;
    const float angle = wrapped(from - angle_of(wedge.second));
    if (angle >= least) continue;
    least = angle;
    next = wedge.second;
  }
  return next;
}

void Rift::close_loops() {
  std::vector<std::uint32_t> path;
  for (const std::uint32_t start : points_) {
    Fan* const fan = fan_of(start);
    for (std::size_t i = 0; i < fan->wedges.size(); ++i) {
      const std::uint32_t before = fan->wedges[i].first;
      const bool matched = std::any_of(fan->wedges.begin(), fan->wedges.end(),
                                       [=](const Wedge& wedge) { return wedge.second == before; });
      if (matched || fan_of(before) == nullptr) continue;
      path = {before, start};
      while (path.size() <= 2 * longest_loop) {
        const std::uint32_t next = next_on_border(path[path.size() - 2], path.back());
        if (next == none) break;
        const auto again = std::find(path.begin(), path.end(), next);
        if (again == path.end()) {
          path.push_back(next);
          continue;
        }
        fill({&*again, static_cast<std::size_t>(path.end() - again)});
        break;
      }
    }
  }
}

// Where the edges around are out of reach, those within may be as long.
float Rift::cost(std::uint32_t a, std::uint32_t b, std::uint32_t c, float longest) const {
  const Corners corners = sorted(a, b, c);
  if (!in_reach(layer_, corners, options_.reach) && squared_size(layer_, corners) > longest) return never;
  const float size = badness(layer_, {a, b, c});
  return size < 0 ? -size * penalty : size;
}

// Whether the loop, filled, is seen from behind, and there is no more surface at its points than within it: then it is no hole but the
// outline of a small piece, or of one triangle. Around a fold there is more.
bool Rift::is_outline(std::span<const std::uint32_t> loop) {
  Vector area, normals;
  float angles = 0;
  const Vector from = layer_.positions[loop[0]];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    area = area + cross(layer_.positions[loop[i]] - from, layer_.positions[loop[(i + 1) % loop.size()]] - from);
    normals = normals + normal_of(layer_, loop[i]);
    for (const Wedge& wedge : fan_of(loop[i])->wedges) angles += std::max(wedge.angle, 0.0F);
  }
  constexpr float behind = -0.5F;
  const float within = turn / 2 * static_cast<float>(loop.size() - 2);
  return angles < within + turn / 2 && dot(unit(area), unit(normals)) < behind;
}

// Based on: Liepa, Filling Holes in Meshes, 2003: the triangulation of least cost, by dynamic programming.
void Rift::fill(std::span<const std::uint32_t> loop) {
  const std::size_t n = loop.size();
  if (n < 3 || n > longest_loop || is_outline(loop)) return;
  float longest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector edge = layer_.positions[loop[i]] - layer_.positions[loop[(i + 1) % n]];
    longest = std::max(longest, dot(edge, edge));
  }
  std::vector<float> least(n * n, 0);
  std::vector<std::size_t> middle(n * n, 0);
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t j = i + span;
      float& best = least[i * n + j];
      best = never;
      const float again = span + 1 < n && has_edge(loop[i], loop[j]) ? penalty : 1;
      for (std::size_t k = i + 1; k < j; ++k) {
        const float below = least[i * n + k] + least[k * n + j];
        if (!(below < best)) continue;
        const float sum = below + again * cost(loop[i], loop[k], loop[j], longest);
        if (!(sum < best)) continue;
        best = sum;
        middle[i * n + j] = k;
      }
    }
  }
  if (!(least[n - 1] < never)) return;
  std::vector<std::array<std::size_t, 2>> open = {{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j < i + 2) continue;
    const std::size_t k = middle[i * n + j];
    insert({loop[i], loop[k], loop[j]});
    open.push_back({i, k});
    open.push_back({k, j});
  }
}

}  // namespace glark::surfel
