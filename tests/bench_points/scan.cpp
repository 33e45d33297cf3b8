// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_points/scan.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <sstream>
#include <stdexcept>

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

Scan sampled(const Scan& mesh, std::size_t count) {
  using Point = std::array<double, 3>;
  const auto at = [](const std::vector<float>& numbers, std::uint32_t i) {
    return Point{numbers[3 * std::size_t{i}], numbers[3 * std::size_t{i} + 1], numbers[3 * std::size_t{i} + 2]};
  };
  const auto dot = [](const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto minus = [](const Point& a, const Point& b) { return Point{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  std::vector<double> area(mesh.triangles.size() / 3 + 1);
  for (std::size_t t = 0; t + 1 < area.size(); ++t) {
    const Point a = at(mesh.positions, mesh.triangles[3 * t]);
    const Point p = minus(at(mesh.positions, mesh.triangles[3 * t + 1]), a);
    const Point q = minus(at(mesh.positions, mesh.triangles[3 * t + 2]), a);
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
    const double weights[3] = {1 - u - v, u, v};
    Point flat{}, round{}, normal{};
    for (std::size_t c = 0; c < 3; ++c) {
      const Point p = at(mesh.positions, mesh.triangles[3 * t + c]), n = at(mesh.normals, mesh.triangles[3 * t + c]);
      for (std::size_t k = 0; k < 3; ++k) {
        flat[k] += weights[c] * p[k];
        normal[k] += weights[c] * n[k];
      }
    }
    // Based on: T. Boubekeur, M. Alexa, Phong Tessellation, 2008, equation 4, with alpha 3/4.
    for (std::size_t c = 0; c < 3; ++c) {
      const Point p = at(mesh.positions, mesh.triangles[3 * t + c]), n = at(mesh.normals, mesh.triangles[3 * t + c]);
      for (std::size_t k = 0; k < 3; ++k) round[k] += weights[c] * (flat[k] - dot(minus(flat, p), n) * n[k]);
    }
    const double length = std::sqrt(dot(normal, normal));
    for (std::size_t k = 0; k < 3; ++k) {
      result.positions.push_back(static_cast<float>(0.25 * flat[k] + 0.75 * round[k]));
      result.normals.push_back(static_cast<float>(length > 0 ? normal[k] / length : 0));
    }
  }
  return result;
}

}  // namespace glark::bench
