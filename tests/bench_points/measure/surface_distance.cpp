// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_points/measure/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace glark::bench {
namespace {

using Point = std::array<double, 3>;

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point at(std::span<const float> positions, std::uint32_t i) {
  return {positions[3 * std::size_t{i}], positions[3 * std::size_t{i} + 1], positions[3 * std::size_t{i} + 2]};
}

// Based on: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
double squared_distance(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point ab = minus(b, a), ac = minus(c, a), ap = minus(p, a);
  const auto from = [&](double v, double w) {
    Point d;
    for (std::size_t k = 0; k < 3; ++k) d[k] = ap[k] - v * ab[k] - w * ac[k];
    return dot(d, d);
  };
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return from(0, 0);
  const Point bp = minus(p, b);
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return from(1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return from(d1 / (d1 - d3), 0);
  const Point cp = minus(p, c);
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return from(0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return from(0, d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return from(1 - w, w);
  }
  const double sum = va + vb + vc;
  return sum > 0 ? from(vb / sum, vc / sum) : from(0, 0);
}

}  // namespace

SurfaceDistance::SurfaceDistance(std::span<const float> positions, std::span<const std::uint32_t> triangles)
    : positions_(positions), triangles_(triangles) {
  Point high{-1e300, -1e300, -1e300};
  low_ = {1e300, 1e300, 1e300};
  double edge = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Point a = at(positions, triangles[t]), b = at(positions, triangles[t + 1]);
    edge += std::sqrt(dot(minus(a, b), minus(a, b)));
    for (std::size_t i = 0; i < 3; ++i) {
      const Point p = at(positions, triangles[t + i]);
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
  }
  const double extent = std::max({high[0] - low_[0], high[1] - low_[1], high[2] - low_[2], 1e-30});
  cell_ = std::max(1.5 * edge / (static_cast<double>(triangles.size()) / 3), extent / 200);
  for (std::size_t k = 0; k < 3; ++k) cells_[k] = static_cast<int>((high[k] - low_[k]) / cell_) + 1;
  const auto each_cell = [&](const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      std::array<int, 3> first{}, last{};
      for (std::size_t k = 0; k < 3; ++k) {
        double least = 1e300, most = -1e300;
        for (std::size_t i = 0; i < 3; ++i) {
          const double x = at(positions, triangles[t + i])[k];
          least = std::min(least, x);
          most = std::max(most, x);
        }
        first[k] = static_cast<int>((least - low_[k]) / cell_);
        last[k] = std::min(static_cast<int>((most - low_[k]) / cell_), cells_[k] - 1);
      }
      for (int z = first[2]; z <= last[2]; ++z) {
        for (int y = first[1]; y <= last[1]; ++y) {
          for (int x = first[0]; x <= last[0]; ++x) visit(index_of({x, y, z}), static_cast<std::uint32_t>(t / 3));
        }
      }
    }
  };
  begins_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2] + 2, 0);
  each_cell([&](std::size_t cell, std::uint32_t) { ++begins_[cell + 2]; });
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  entries_.resize(begins_.back());
  each_cell([&](std::size_t cell, std::uint32_t triangle) { entries_[begins_[cell + 1]++] = triangle; });
}

std::size_t SurfaceDistance::index_of(const std::array<int, 3>& cell) const {
  const std::size_t row = static_cast<std::size_t>(cell[2]) * cells_[1] + cell[1];
  return row * cells_[0] + cell[0];
}

void SurfaceDistance::look_into(std::array<int, 3> cell, const Point& point, double& best) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (cell[k] < 0 || cell[k] >= cells_[k]) return;
  }
  const std::size_t index = index_of(cell);
  for (std::uint32_t i = begins_[index]; i < begins_[index + 1]; ++i) {
    const std::size_t t = std::size_t{3} * entries_[i];
    best = std::min(best, squared_distance(point, at(positions_, triangles_[t]), at(positions_, triangles_[t + 1]),
                                           at(positions_, triangles_[t + 2])));
  }
}

double SurfaceDistance::squared(const Point& point) const {
  std::array<int, 3> centre{};
  for (std::size_t k = 0; k < 3; ++k)
    centre[k] = std::clamp(static_cast<int>((point[k] - low_[k]) / cell_), 0, cells_[k] - 1);
  double best = 1e300;
  const int most = std::max({cells_[0], cells_[1], cells_[2]});
  for (int ring = 0; ring <= most; ++ring) {
    if (ring > 0 && best <= (ring - 1) * cell_ * (ring - 1) * cell_) break;
    for (int z = -ring; z <= ring; ++z) {
      for (int y = -ring; y <= ring; ++y) {
        const bool shell = std::abs(z) == ring || std::abs(y) == ring;
        for (int x = -ring; x <= ring; x += shell || ring == 0 ? 1 : 2 * ring)
          look_into({centre[0] + x, centre[1] + y, centre[2] + z}, point, best);
      }
    }
  }
  return best;
}

double SurfaceDistance::rms(std::span<const float> points) const {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); i += 3) sum += squared({points[i], points[i + 1], points[i + 2]});
  return std::sqrt(sum / (static_cast<double>(points.size()) / 3));
}

std::vector<float> samples_of(std::span<const float> positions, std::span<const std::uint32_t> triangles,
                              std::size_t count) {
  std::vector<double> area(triangles.size() / 3 + 1);
  for (std::size_t t = 0; t + 1 < area.size(); ++t) {
    const Point a = at(positions, triangles[3 * t]);
    const Point p = minus(at(positions, triangles[3 * t + 1]), a), q = minus(at(positions, triangles[3 * t + 2]), a);
    area[t + 1] = area[t] + std::sqrt(std::max(0.0, dot(p, p) * dot(q, q) - dot(p, q) * dot(p, q)));
  }
  std::mt19937 random(1);
  const auto fraction = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<float> samples;
  std::size_t t = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = area.back() * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    while (t + 2 < area.size() && area[t + 1] < wanted) ++t;
    double u = fraction(), v = fraction();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Point a = at(positions, triangles[3 * t]), b = at(positions, triangles[3 * t + 1]),
                c = at(positions, triangles[3 * t + 2]);
    for (std::size_t k = 0; k < 3; ++k)
      samples.push_back(static_cast<float>(a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k])));
  }
  return samples;
}

Edges edges_of(std::span<const std::uint32_t> triangles) {
  std::vector<std::uint64_t> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint64_t a = triangles[i], b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    edges.push_back(a < b ? (a << 32 | b) : (b << 32 | a));
  }
  std::sort(edges.begin(), edges.end());
  Edges result;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    result.boundary += end - i == 1 ? 1 : 0;
    result.non_manifold += end - i > 2 ? 1 : 0;
    i = end;
  }
  return result;
}

double diagonal_of(std::span<const float> positions) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    float low = positions[k], high = low;
    for (std::size_t i = k; i < positions.size(); i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    sum += (double{high} - low) * (double{high} - low);
  }
  return std::sqrt(sum);
}

}  // namespace glark::bench
