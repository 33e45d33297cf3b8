// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/surfel/clouds.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <utility>

namespace glark::surfel::test {
namespace {

constexpr float pi = 3.14159265F;

// Returns the output of `zstd -dc FILE`, or nothing if it fails.
std::string unpacked(const std::string& path) {
  struct Close {
    void operator()(FILE* file) const { pclose(file); }
  };
  const std::unique_ptr<FILE, Close> pipe(popen(("zstd -dcq '" + path + "' 2>/dev/null").c_str(), "r"));
  std::string all;
  std::vector<char> block(1 << 20);
  for (std::size_t got = 1; pipe && got > 0;) {
    got = std::fread(block.data(), 1, block.size(), pipe.get());
    all.append(block.data(), got);
  }
  return all;
}

}  // namespace

void Points::add(std::array<float, 3> position, std::array<float, 3> normal) {
  positions.insert(positions.end(), position.begin(), position.end());
  normals.insert(normals.end(), normal.begin(), normal.end());
}

Points sphere(std::size_t count) {
  Points points;
  const float golden_angle = pi * (3 - std::sqrt(5.0F));
  for (std::size_t i = 0; i < count; ++i) {
    const float z = 1 - 2 * (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    const float angle = golden_angle * static_cast<float>(i);
    const float r = std::sqrt(1 - z * z);
    const std::array<float, 3> at = {r * std::cos(angle), r * std::sin(angle), z};
    points.add(at, at);
  }
  return points;
}

Points torus(std::size_t count) {
  Points points;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> turn(0, 2 * pi), chance(0, 1.4F);
  while (points.size() < count) {
    const float u = turn(random), v = turn(random);
    const float r = 1 + 0.4F * std::cos(v);
    if (chance(random) > r) continue;  // makes the points uniform on the surface
    points.add({r * std::cos(u), r * std::sin(u), 0.4F * std::sin(v)},
               {std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)});
  }
  return points;
}

Points plane(unsigned side, float noise, float at) {
  Points points;
  std::mt19937 random(2);
  std::uniform_real_distribution<float> shake(-noise, noise);
  const float step = 1 / static_cast<float>(side - 1);
  for (unsigned i = 0; i < side * side; ++i) {
    const float dx = shake(random), dy = shake(random), dz = shake(random);
    const unsigned row = i / side;
    points.add({static_cast<float>(i % side) * step + dx, static_cast<float>(row) * step + dy, at + dz}, {0, 0, 1});
  }
  return points;
}

Points two_layers(unsigned side, float apart) {
  Points points = plane(side, 0, apart);
  const Points below = plane(side, 0, 0);
  for (std::size_t i = 0; i < below.size(); ++i) {
    points.add({below.positions[3 * i], below.positions[3 * i + 1], below.positions[3 * i + 2]}, {0, 0, -1});
  }
  return points;
}

Points cube(unsigned side) {
  Points points;
  for (std::size_t face = 0; face < 6; ++face) {
    for (unsigned i = 0; i < side * side; ++i) {
      const auto at = [&](unsigned k) { return (static_cast<float>(k) + 0.5F) / static_cast<float>(side) - 0.5F; };
      std::array<float, 3> position{}, normal{};
      normal[face / 2] = face % 2 == 0 ? 1.0F : -1.0F;
      position[face / 2] = 0.5F * normal[face / 2];
      position[(face / 2 + 1) % 3] = at(i % side);
      position[(face / 2 + 2) % 3] = at(i / side);
      points.add(position, normal);
    }
  }
  return points;
}

std::optional<Points> scan(const std::string& name) {
  const std::string path = std::string(GLARK_SURFEL_SCANS) + "/" + name + ".ply.zst";
  if (!std::filesystem::exists(path)) return std::nullopt;
  const std::string file = unpacked(path);
  const std::string end = "end_header\n";
  const std::size_t data = file.find(end);
  if (data == std::string::npos) return std::nullopt;
  const std::string header = file.substr(0, data);
  const std::string vertex = header.substr(0, header.find("element face"));
  const auto count_of = [&](const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = vertex.find(words); at != std::string::npos; at = vertex.find(words, at + 1)) ++count;
    return count;
  };
  const std::size_t floats = count_of("property float"), bytes = count_of("property uchar");
  const std::size_t vertices = std::stoul(header.substr(header.find("element vertex ") + 15));
  if (floats != 6) return std::nullopt;
  Points points;
  for (std::size_t i = 0; i < vertices; ++i) {
    std::array<float, 6> values{};
    std::memcpy(values.data(), file.data() + data + end.size() + i * (4 * floats + bytes), sizeof(values));
    points.add({values[0], values[1], values[2]}, {values[3], values[4], values[5]});
  }
  return points;
}

std::vector<std::vector<Triangle>> patches(const Strips& strips, unsigned level) {
  std::vector<std::vector<Triangle>> all;
  for (const Node& node : strips.nodes(level)) {
    if (node.left != none || node.count == 0) continue;
    all.emplace_back();
    const auto strip = strips.indices().subspan(node.first, node.count);
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
      Triangle triangle = {strip[i], strip[i + 1], strip[i + 2]};
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
      if (i % 2 == 1) std::swap(triangle[0], triangle[1]);
      all.back().push_back(triangle);
    }
  }
  return all;
}

std::vector<Triangle> triangles(const Strips& strips, unsigned level) {
  std::vector<Triangle> all;
  for (const auto& patch : patches(strips, level)) all.insert(all.end(), patch.begin(), patch.end());
  return all;
}

Edges count_edges(const Strips& strips) {
  struct Use {
    int forwards = 0, backwards = 0;
    std::size_t patch = 0;
    bool border = false;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Use> uses;
  const auto all = patches(strips);
  for (std::size_t p = 0; p < all.size(); ++p) {
    for (const Triangle& triangle : all[p]) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
        Use& use = uses[std::minmax(a, b)];
        use.border = use.border || (use.forwards + use.backwards > 0 && use.patch != p);
        use.patch = p;
        ++(a < b ? use.forwards : use.backwards);
      }
    }
  }
  Edges edges;
  for (const auto& [ends, use] : uses) {
    const bool single = use.forwards + use.backwards == 1;
    const bool matched = use.forwards == 1 && use.backwards == 1;
    ++(matched ? edges.matched : single ? edges.single : edges.other);
    if (use.border || single) ++(matched ? edges.border_matched : edges.border_other);
  }
  return edges;
}

}  // namespace glark::surfel::test
