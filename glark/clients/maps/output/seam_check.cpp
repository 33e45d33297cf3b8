// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/output/seam_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "glark/clients/maps/charts/chart_edges.h"
#include "glark/clients/maps/charts/tangent_frame.h"

namespace glark::maps {
namespace {

constexpr int places_a_texel = 2;

// What a fragment on a shared edge sees.
struct Seen {
  Vector normal;  // in the space of the positions
  Vector colour;
  float height = 0;
};

// The maps in one mipmap level.
struct MapsOfLevel {
  std::size_t width = 0, height = 0;
  std::span<const std::uint8_t> normals, colours;  // colours: may be empty
  std::span<const std::uint16_t> heights;
};

// A level that has its own memory.
class NextLevel {
 public:
  explicit NextLevel(const MapsOfLevel& from)
      : normals_(half(from, from.normals, 3)),
        colours_(half(from, from.colours, 3)),
        heights_(half(from, from.heights, 1)) {
    maps_ = {from.width / 2, from.height / 2, normals_, colours_, heights_};
  }
  const MapsOfLevel& maps() const { return maps_; }

 private:
  template <class Texel>
  static std::vector<Texel> half(const MapsOfLevel& from, std::span<const Texel> texels, std::size_t channels) {
    std::vector<Texel> means(texels.size() / 4);
    const std::size_t width = from.width / 2, row = from.width * channels;
    for (std::size_t i = 0; i < means.size(); ++i) {
      const std::size_t x = i / channels % width, y = i / channels / width;
      const std::size_t first = 2 * y * row + 2 * x * channels + i % channels;
      const unsigned sum =
          texels[first] + texels[first + channels] + texels[first + row] + texels[first + row + channels];
      means[i] = static_cast<Texel>((sum + 2) / 4);
    }
    return means;
  }

  std::vector<std::uint8_t> normals_, colours_;
  std::vector<std::uint16_t> heights_;
  MapsOfLevel maps_;
};

class Reader {
 public:
  Reader(const Baked& model, const MapsOfLevel& maps) : model_(model), maps_(maps) {}

  Point2 texel_of(std::uint32_t vertex) const {
    return {model_.texcoords[2 * std::size_t{vertex}] * static_cast<float>(maps_.width),
            model_.texcoords[2 * std::size_t{vertex} + 1] * static_cast<float>(maps_.height)};
  }

  // Between two vertices, at the part s of the way.
  Seen see(std::uint32_t from, std::uint32_t to, float s) const {
    const Point2 a = texel_of(from);
    const Point2 b = texel_of(to);
    const Point2 at{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
    const TangentFrame frame =
        TangentFrame::of(mix(model_.normals, 3, from, to, s), mix(model_.tangents, 4, from, to, s));
    Seen seen;
    Vector local = colour_at(maps_.normals, at) * 2.0F - Vector{1, 1, 1};
    local.y *= model_.tangents[4 * std::size_t{from} + 3];
    seen.normal = common::unit(frame.to_world(local));
    if (!maps_.colours.empty()) seen.colour = colour_at(maps_.colours, at);
    seen.height =
        filtered(at, [&](std::size_t i) { return static_cast<float>(maps_.heights[i]) / 65535; }) * model_.scale;
    return seen;
  }

 private:
  Vector mix(const std::vector<float>& values, std::size_t width, std::uint32_t from, std::uint32_t to, float s) const {
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = (1 - s) * values[width * from + k] + s * values[width * to + k];
    return result;
  }

  template <class Texel>
  float filtered(Point2 at, const Texel& texel) const {
    const float x = std::clamp(at[0] - 0.5F, 0.0F, static_cast<float>(maps_.width) - 1.001F);
    const float y = std::clamp(at[1] - 0.5F, 0.0F, static_cast<float>(maps_.height) - 1.001F);
    const auto i = static_cast<std::size_t>(x);
    const auto j = static_cast<std::size_t>(y);
    const float fx = x - static_cast<float>(i);
    const float fy = y - static_cast<float>(j);
    const std::size_t first = j * maps_.width + i;
    return (1 - fy) * ((1 - fx) * texel(first) + fx * texel(first + 1)) +
           fy * ((1 - fx) * texel(first + maps_.width) + fx * texel(first + maps_.width + 1));
  }

  Vector colour_at(std::span<const std::uint8_t> map, Point2 at) const {
    Vector colour;
    for (std::size_t k = 0; k < 3; ++k)
      colour[k] = filtered(at, [&](std::size_t i) { return static_cast<float>(map[3 * i + k]) / 255; });
    return colour;
  }

  const Baked& model_;
  MapsOfLevel maps_;
};

// Collects differences.
class Differences {
 public:
  void add(float difference) {
    greatest_ = std::max(greatest_, difference);
    squares_ += static_cast<double>(difference) * static_cast<double>(difference);
    ++count_;
  }
  Jump jump() const {
    return {greatest_, count_ > 0 ? static_cast<float>(std::sqrt(squares_ / static_cast<double>(count_))) : 0.0F};
  }

 private:
  float greatest_ = 0;
  double squares_ = 0;
  std::size_t count_ = 0;
};

struct AllDifferences {
  Differences colour, normal, displacement;

  void add(const Seen& a, const Seen& b, bool is_hard) {
    const float cosine = common::dot(a.normal, b.normal);
    const float sine = common::length(common::cross(a.normal, b.normal));
    if (!is_hard) normal.add(std::atan2(sine, cosine) * 180 / std::numbers::pi_v<float>);
    const Vector change = a.colour - b.colour;
    colour.add(std::max({std::abs(change.x), std::abs(change.y), std::abs(change.z)}));
    displacement.add(std::abs(a.height - b.height));
  }
};

SeamJumps jumps_of(const Surface& surface, const ChartEdges& chart_edges, const Baked& model, const MapsOfLevel& maps) {
  const Reader reader(model, maps);
  AllDifferences all;
  std::size_t edges = 0;
  const auto corner = [&](std::uint32_t t, std::uint32_t vertex) {
    return model.triangles[3 * std::size_t{t} + corner_at(surface, t, vertex)];
  };
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = surface.neighbours[t][k];
      if (other == none || other < t || !chart_edges.is_seam(t, k)) continue;
      const std::uint32_t from = surface.triangles[t][k];
      const std::uint32_t to = surface.triangles[t][(k + 1) % 3];
      const Point2 a = reader.texel_of(corner(t, from));
      const Point2 b = reader.texel_of(corner(t, to));
      const int places = places_a_texel * static_cast<int>(std::ceil(std::hypot(b[0] - a[0], b[1] - a[1]))) + 1;
      for (int i = 0; i <= places; ++i) {
        const float s = static_cast<float>(i) / static_cast<float>(places);
        all.add(reader.see(corner(t, from), corner(t, to), s), reader.see(corner(other, from), corner(other, to), s),
                is_hard(surface, t, k));
      }
      ++edges;
    }
  }
  return {all.colour.jump(), all.normal.jump(), all.displacement.jump(), edges};
}

}  // namespace

std::vector<SeamJumps> check_seams(const Surface& surface, const std::vector<Chart>& charts, const Baked& model,
                                   unsigned levels) {
  const ChartEdges edges(surface, charts);
  std::vector<SeamJumps> jumps;
  std::vector<NextLevel> next;
  next.reserve(levels);
  MapsOfLevel maps{model.width, model.height, model.normal_map, model.colour_map, model.displacement_map};
  for (unsigned level = 0; level < levels; ++level) {
    if (level > 0) maps = next.emplace_back(maps).maps();
    jumps.push_back(jumps_of(surface, edges, model, maps));
  }
  return jumps;
}

}  // namespace glark::maps
