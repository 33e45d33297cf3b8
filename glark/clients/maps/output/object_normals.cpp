// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Normals in object space: the normal map without tangent spaces, for programs that have none.
#include <glark/maps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "glark/clients/maps/charts/tangent_frame.h"

namespace glark::maps {
namespace {

constexpr float gutter = 4;  // texels around a chart that have values, too
constexpr float middle = 127.5F;
constexpr std::uint8_t no_normal = 128;  // of texels that no chart has

using Texel = std::array<float, 2>;  // in texels; the centre of the first one is 0 0

// A triangle of the model on its maps.
class MappedTriangle {
 public:
  MappedTriangle(const Baked& model, std::size_t triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = model.triangles[3 * triangle + k];
      corners_[k] = {model.texcoords[2 * vertex] * static_cast<float>(model.width) - 0.5F,
                     model.texcoords[2 * vertex + 1] * static_cast<float>(model.height) - 0.5F};
      normals_[k] = {model.normals[3 * vertex], model.normals[3 * vertex + 1], model.normals[3 * vertex + 2]};
      tangents_[k] = {model.tangents[4 * vertex], model.tangents[4 * vertex + 1], model.tangents[4 * vertex + 2]};
    }
    turn_ = model.tangents[4 * std::size_t{model.triangles[3 * triangle]} + 3];
    twice_area_ = twice_area(corners_[0], corners_[1], corners_[2]);
  }

  bool has_area() const { return twice_area_ != 0; }

  // The texels that may be at most `gutter` away: first and last, on one axis.
  std::array<int, 2> range(std::size_t axis, unsigned size) const {
    const auto [low, high] = std::minmax({corners_[0][axis], corners_[1][axis], corners_[2][axis]});
    return {std::max(static_cast<int>(std::floor(low - gutter)), 0),
            std::min(static_cast<int>(std::ceil(high + gutter)), static_cast<int>(size) - 1)};
  }

  // The barycentric coordinates of the place of the triangle that is nearest to the texel, and its squared distance.
  struct Nearest {
    std::array<float, 3> weights{};
    float distance = 0;
  };
  Nearest nearest(const Texel& at) const {
    Nearest inside;
    for (std::size_t k = 0; k < 3; ++k)
      inside.weights[k] = twice_area(at, corners_[(k + 1) % 3], corners_[(k + 2) % 3]) / twice_area_;
    if (*std::min_element(inside.weights.begin(), inside.weights.end()) >= 0) return inside;
    Nearest best{{}, std::numeric_limits<float>::max()};
    for (std::size_t k = 0; k < 3; ++k) {
      const Nearest side = nearest_of_side(at, k);
      if (side.distance < best.distance) best = side;
    }
    return best;
  }

  TangentFrame frame(const std::array<float, 3>& weights) const {
    Vector normal{}, tangent{};
    for (std::size_t k = 0; k < 3; ++k) {
      normal = normal + normals_[k] * weights[k];
      tangent = tangent + tangents_[k] * weights[k];
    }
    TangentFrame frame = TangentFrame::of(normal, tangent);
    frame.bitangent = frame.bitangent * turn_;
    return frame;
  }

 private:
  static float twice_area(const Texel& a, const Texel& b, const Texel& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  // On the side from corner k to the next one.
  Nearest nearest_of_side(const Texel& at, std::size_t k) const {
    const Texel& from = corners_[k];
    const Texel along{corners_[(k + 1) % 3][0] - from[0], corners_[(k + 1) % 3][1] - from[1]};
    const Texel to{at[0] - from[0], at[1] - from[1]};
    const float length = along[0] * along[0] + along[1] * along[1];
    const float part = length > 0 ? std::clamp((to[0] * along[0] + to[1] * along[1]) / length, 0.0F, 1.0F) : 0;
    const Texel off{to[0] - part * along[0], to[1] - part * along[1]};
    Nearest result;
    result.weights[k] = 1 - part;
    result.weights[(k + 1) % 3] = part;
    result.distance = off[0] * off[0] + off[1] * off[1];
    return result;
  }

  std::array<Texel, 3> corners_{};
  std::array<Vector, 3> normals_{}, tangents_{};
  float twice_area_ = 0;
  float turn_ = 1;  // -1: the bitangent points the other way
};

// Turns the texels at and around a triangle that are nearer to it than to all triangles before.
class Turning {
 public:
  explicit Turning(const Baked& model)
      : model_(model),
        result_(model.normal_map.size(), no_normal),
        distances_(std::size_t{model.width} * model.height, gutter * gutter) {}

  void add(const MappedTriangle& triangle) {
    if (!triangle.has_area()) return;
    const auto [left, right] = triangle.range(0, model_.width);
    const auto [top, bottom] = triangle.range(1, model_.height);
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const MappedTriangle::Nearest nearest = triangle.nearest({static_cast<float>(x), static_cast<float>(y)});
        float& distance = distances_[static_cast<std::size_t>(y) * model_.width + static_cast<std::size_t>(x)];
        if (nearest.distance >= distance) continue;
        distance = nearest.distance;
        turn(static_cast<std::size_t>(y) * model_.width + static_cast<std::size_t>(x), triangle.frame(nearest.weights));
      }
    }
  }

  std::vector<std::uint8_t> take() { return std::move(result_); }

 private:
  void turn(std::size_t texel, const TangentFrame& frame) {
    const std::uint8_t* const from = &model_.normal_map[3 * texel];
    const Vector local{from[0] / middle - 1, from[1] / middle - 1, from[2] / middle - 1};
    const Vector normal = common::unit(frame.to_world(local));
    for (std::size_t k = 0; k < 3; ++k)
      result_[3 * texel + k] =
          static_cast<std::uint8_t>(std::lround(std::clamp(middle * (normal[k] + 1), 0.0F, 255.0F)));
  }

  const Baked& model_;
  std::vector<std::uint8_t> result_;
  std::vector<float> distances_;  // squared, of each texel to the nearest triangle so far
};

}  // namespace

std::vector<std::uint8_t> object_normals(const Baked& model) {
  Turning turning(model);
  for (std::size_t t = 0; t < model.triangles.size() / 3; ++t) turning.add(MappedTriangle(model, t));
  return turning.take();
}

}  // namespace glark::maps
