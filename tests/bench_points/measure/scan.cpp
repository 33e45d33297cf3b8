// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_points/measure/scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <span>
#include <sstream>
#include <stdexcept>

#include "glark/clients/common/vector.h"

namespace glark::bench {
namespace {

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Stream open(const std::string& path) {
  if (std::filesystem::exists(path)) return {std::fopen(path.c_str(), "rb"), std::fclose};
  if (!std::filesystem::exists(path + ".zst")) throw std::runtime_error("there is no " + path + "[.zst]");
  return {popen(("zstd -dcq -- '" + path + ".zst'").c_str(), "r"), pclose};
}

void read(Stream& stream, void* to, std::size_t bytes, const std::string& path) {
  if (std::fread(to, 1, bytes, stream.get()) != bytes)
    throw std::runtime_error(path + " is cut short, or zstd is missing");
}

struct Header {
  std::size_t vertices = 0, faces = 0, vertex_bytes = 0;
  bool has_normals = false;
};

Header read_header(Stream& stream, const std::string& path) {
  Header header;
  std::string line;
  bool in_vertices = false;
  for (char c = 0; line != "end_header\n";) {
    if (c == '\n') line.clear();
    read(stream, &c, 1, path);
    line += c;
    if (c != '\n') continue;
    std::istringstream words(line);
    std::string word, kind, name;
    words >> word >> kind >> name;
    if (word == "element") {
      in_vertices = kind == "vertex";
      (in_vertices ? header.vertices : header.faces) = std::stoul(name);
    } else if (word == "property" && in_vertices) {
      header.vertex_bytes += kind == "uchar" ? 1 : 4;
      header.has_normals |= name == "nx";
    }
  }
  return header;
}

}  // namespace

Scan read_scan(const std::string& folder, const std::string& name) {
  const std::string path = folder + "/" + name + ".ply";
  Stream stream = open(path);
  const Header header = read_header(stream, path);
  Scan scan;
  std::vector<char> record(header.vertex_bytes);
  for (std::size_t i = 0; i < header.vertices; ++i) {
    read(stream, record.data(), record.size(), path);
    std::array<float, 6> numbers{};
    std::memcpy(numbers.data(), record.data(), header.has_normals ? 24 : 12);
    scan.positions.insert(scan.positions.end(), numbers.begin(), numbers.begin() + 3);
    if (header.has_normals) scan.normals.insert(scan.normals.end(), numbers.begin() + 3, numbers.end());
  }
  for (std::size_t i = 0; i < header.faces; ++i) {
    unsigned char corners = 0;
    std::array<std::uint32_t, 3> triangle{};
    read(stream, &corners, 1, path);
    if (corners != 3) throw std::runtime_error(path + ": a face is no triangle");
    read(stream, triangle.data(), sizeof(triangle), path);
    scan.triangles.insert(scan.triangles.end(), triangle.begin(), triangle.end());
  }
  return scan;
}

namespace {

using Point = common::Vector3d;

// Returns the position or normal at a corner of the triangles.
Point corner(const std::vector<float>& numbers, const Scan& mesh, std::size_t index) {
  const common::Vector3f at = common::vector_at(std::span<const float>(numbers), mesh.triangles[index]);
  return {at.x, at.y, at.z};
}

// Adds the point of a triangle that has these weights of the corners.
// Based on: T. Boubekeur, M. Alexa, Phong Tessellation, 2008, equation 4, with alpha 3/4.
void add_sample(const Scan& mesh, std::size_t triangle, const std::array<double, 3>& weights, Scan& result) {
  Point flat, round, normal;
  for (std::size_t c = 0; c < 3; ++c) {
    flat += weights[c] * corner(mesh.positions, mesh, 3 * triangle + c);
    normal += weights[c] * corner(mesh.normals, mesh, 3 * triangle + c);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const Point p = corner(mesh.positions, mesh, 3 * triangle + c), n = corner(mesh.normals, mesh, 3 * triangle + c);
    round += weights[c] * (flat - dot(flat - p, n) * n);
  }
  const double size = length(normal);
  for (std::size_t k = 0; k < 3; ++k) {
    result.positions.push_back(static_cast<float>(0.25 * flat[k] + 0.75 * round[k]));
    result.normals.push_back(static_cast<float>(size > 0 ? normal[k] / size : 0));
  }
}

}  // namespace

Scan sampled(const Scan& mesh, std::size_t count) {
  std::vector<double> area(mesh.triangles.size() / 3 + 1);
  for (std::size_t t = 0; t + 1 < area.size(); ++t) {
    const Point a = corner(mesh.positions, mesh, 3 * t);
    const Point p = corner(mesh.positions, mesh, 3 * t + 1) - a, q = corner(mesh.positions, mesh, 3 * t + 2) - a;
    area[t + 1] = area[t] + std::sqrt(std::max(0.0, dot(p, p) * dot(q, q) - dot(p, q) * dot(p, q)));
  }
  std::mt19937 random(1);
  const auto fraction = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Scan result;
  for (std::size_t i = 0, t = 0; i < count; ++i) {
    const double wanted = area.back() * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    while (t + 2 < area.size() && area[t + 1] < wanted) ++t;
    double u = fraction(), v = fraction();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    add_sample(mesh, t, {1 - u - v, u, v}, result);
  }
  return result;
}

}  // namespace glark::bench
