// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/density/fill.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glark::reconstruct {
namespace {

constexpr std::size_t neighbours_each = 20;
constexpr std::size_t least_neighbours = 4;  // fewer describe no surface
constexpr float facing = 0.2F;               // the least cosine of normals on one side
constexpr std::size_t ring = 6;              // a disc with this many neighbours has the area of as many samples
constexpr float towards = 0.5F;              // the least cosine between the directions to a new sample and a neighbour
constexpr float within = 0.35F;              // this near to a sample, no neighbour in the direction is needed
constexpr float sharpness = 0.01F;
constexpr int most_steps = 40;  // new samples along each direction from a given one
constexpr std::size_t grain = 64;

class Filler {
 public:
  Filler(const Neighbours& neighbours, const PointSet& points, std::span<const std::uint8_t> is_used, float spacing)
      : neighbours_(neighbours), points_(points), is_used_(is_used), spacing_(spacing) {}

  void fill_around(std::uint32_t entry, Filling& out) {
    gather(entry);
    if (around_.size() <= least_neighbours) return;
    const float own = std::sqrt(around_[std::min(ring, around_.size() - 1)].square / 2);  // the spacing here
    const Float4 normal = around_[0].normal;
    const Float4 axis = std::abs(normal[0]) < 0.6F ? Float4{1, 0, 0, 0} : Float4{0, 1, 0, 0};
    const Float4 u = unit(cross(normal, axis)), v = cross(normal, u);
    const auto steps = std::min(static_cast<int>(own * 1.2F / spacing_), most_steps);
    for (int i = -steps; i <= steps; ++i) {
      for (int k = -steps; k <= steps; ++k) {
        if (i == 0 && k == 0) continue;
        const Float4 point = around_[0].point + (u * static_cast<float>(i) + v * static_cast<float>(k)) * spacing_;
        if (is_between(point, own)) add(point, out);
      }
    }
  }

 private:
  struct Sample {
    Float4 point, normal;
    float square;  // of the distance from the given sample
    std::size_t index;
  };

  // Collects the given sample and the neighbours that face the same way.
  void gather(std::uint32_t entry) {
    neighbours_.find(entry, neighbours_each, near_);
    around_.assign(1, {neighbours_.point(entry), neighbours_.normal(entry), 0, neighbours_.index_of(entry)});
    for (const Neighbours::Near& other : near_) {
      const Float4 normal = neighbours_.normal(other.entry);
      if (is_used_[other.entry] != 0 && dot(normal, around_[0].normal) > facing)
        around_.push_back({neighbours_.point(other.entry), normal, other.square, neighbours_.index_of(other.entry)});
    }
  }

  bool is_between(Float4 point, float own) const {
    const Float4 way = point - around_[0].point;
    const float square = dot(way, way);
    bool has_other = square < within * within * own * own;
    for (std::size_t i = 1; i < around_.size(); ++i) {
      const Float4 from = point - around_[i].point, there = around_[i].point - around_[0].point;
      if (dot(from, from) < square) return false;
      has_other = has_other || dot(way, there) > towards * std::sqrt(square * around_[i].square);
    }
    return has_other;
  }

  // Moves the point onto the surface that the samples and their normals describe. On a quadratic surface, the height
  // over a sample's plane is half of the way that both normals show.
  void add(Float4 point, Filling& out) const {
    const float scale = 1 / (1.2F * around_.back().square);
    Float4 normal = around_[0].normal, colour{};
    for (int round = 0; round < 2; ++round) {
      Float4 normals{}, colours{};
      float weights = 0;
      for (const Sample& sample : around_) {
        const float weight = weight_of(sample, point, scale);
        normals += sample.normal * weight;
        weights += weight;
        if (!points_.colours.empty()) {
          const std::uint8_t* const c = &points_.colours[3 * sample.index];
          colours += Float4{static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]), 0} * weight;
        }
      }
      if (!(weights > 0)) return;
      normal = unit(normals);
      colour = colours / weights;
      float height = 0;
      for (const Sample& sample : around_)
        height += dot(point - sample.point, sample.normal + normal) / 2 * weight_of(sample, point, scale);
      point -= normal * (height / weights);
    }
    out.points.push_back(point);
    out.normals.push_back(normal);
    if (points_.colours.empty()) return;
    for (int i = 0; i < 3; ++i) out.colours.push_back(static_cast<std::uint8_t>(colour[i] + 0.5F));
  }

  static float weight_of(const Sample& sample, Float4 point, float scale) {
    const Float4 apart = point - sample.point;
    const float t = dot(apart, apart) * scale;
    return t < 1 ? (1 - t) * (1 - t) / (t + sharpness) : 0;
  }

  const Neighbours& neighbours_;
  const PointSet& points_;
  std::span<const std::uint8_t> is_used_;
  float spacing_;
  std::vector<Neighbours::Near> near_;
  std::vector<Sample> around_;
};

}  // namespace

void Filling::append(const Filling& other) {
  points.insert(points.end(), other.points.begin(), other.points.end());
  normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  colours.insert(colours.end(), other.colours.begin(), other.colours.end());
}

// Estimates the number of new samples. A disc around a sample that reaches its sixth neighbour has the area of six
// samples. So one sample has pi r^2 / 6, which is about r^2 / 2.
double count_of_filling(std::span<const std::uint32_t> sparse, const Neighbours& neighbours, float spacing,
                        const Workers& workers) {
  constexpr std::size_t most_tried = 4096;
  const std::size_t tried = std::min(most_tried, sparse.size());
  std::vector<double> counts(tried);
  workers.each(tried, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbours::Near> near;
    for (std::size_t i = begin; i < end; ++i) {
      neighbours.find(sparse[i * sparse.size() / tried], neighbours_each, near);
      if (near.size() < ring) continue;
      const double own = near[ring - 1].square / 2, widest = most_steps / 1.2 * static_cast<double>(spacing);
      counts[i] = std::min(own, widest * widest) / static_cast<double>(spacing * spacing);
    }
  });
  return std::accumulate(counts.begin(), counts.end(), 0.0) * static_cast<double>(sparse.size()) /
         static_cast<double>(tried);
}

Filling filling_around(std::span<const std::uint32_t> sparse, const Neighbours& neighbours, const PointSet& points,
                       std::span<const std::uint8_t> is_used, float spacing, const Workers& workers) {
  std::vector<Filling> parts((sparse.size() + grain - 1) / grain);
  workers.in_pieces(sparse.size(), grain, [&](std::size_t begin, std::size_t end) {
    Filler filler(neighbours, points, is_used, spacing);
    for (std::size_t i = begin; i < end; ++i) filler.fill_around(sparse[i], parts[begin / grain]);
  });
  Filling result;
  for (const Filling& part : parts) result.append(part);
  return result;
}

}  // namespace glark::reconstruct
