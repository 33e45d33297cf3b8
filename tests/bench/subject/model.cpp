// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/subject/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace glark::bench {
namespace {

using Point = std::array<float, 3>;

struct Model {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

std::size_t bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes{{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
                                                        {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
                                                        {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
                                                        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  if (found == sizes.end()) throw std::runtime_error("PLY: unknown type " + type);
  return found->second;
}

struct Header {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t vertex_bytes = 0;
};

// The coordinates x, y, z must be floats and the first three properties. Faces must be one list of 32-bit indices.
Header read_header(std::istream& file) {
  Header header;
  std::string line;
  bool in_vertices = false;
  while (std::getline(file, line) && line.rfind("end_header", 0) != 0) {
    std::istringstream words(line);
    std::string word;
    std::string kind;
    words >> word >> kind;
    if (word == "format" && kind != "binary_little_endian") throw std::runtime_error("PLY: not binary little endian");
    if (word == "element") {
      in_vertices = kind == "vertex";
      words >> (in_vertices ? header.vertices : header.faces);
    } else if (word == "property" && in_vertices) {
      header.vertex_bytes += bytes_of(kind);
    }
  }
  return header;
}

Model read_ply(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot open " + path);
  const Header header = read_header(file);
  Model model;
  std::vector<char> record(header.vertex_bytes);
  for (std::size_t i = 0; i < header.vertices; ++i) {
    file.read(record.data(), static_cast<std::streamsize>(record.size()));
    Point point;
    std::memcpy(point.data(), record.data(), sizeof(point));
    model.points.push_back(point);
  }
  for (std::size_t i = 0; i < header.faces; ++i) {
    unsigned char corners = 0;
    std::array<std::uint32_t, 3> triangle{};
    file.read(reinterpret_cast<char*>(&corners), 1);
    if (corners != 3) throw std::runtime_error(path + ": a face is no triangle");
    file.read(reinterpret_cast<char*>(triangle.data()), sizeof(triangle));
    model.triangles.push_back(triangle);
  }
  if (!file) throw std::runtime_error(path + " is cut short");
  return model;
}

void scale_to_unit_sphere(Model& model) {
  Point low{1e30F, 1e30F, 1e30F};
  Point high{-1e30F, -1e30F, -1e30F};
  for (const Point& point : model.points) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  float radius = 0;
  for (std::size_t k = 0; k < 3; ++k) radius = std::max(radius, 0.5F * (high[k] - low[k]));
  for (Point& point : model.points) {
    for (std::size_t k = 0; k < 3; ++k) point[k] = (point[k] - 0.5F * (low[k] + high[k])) / radius * 0.8F;
  }
}

Point face_normal(const Point& a, const Point& b, const Point& c) {
  const Point p{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Point q{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

struct Cluster {
  Point sum{};
  Point normal{};
  float count = 0;
};

// Returns the cells of a grid that have points, with the sums of the points. cluster_of: receives the cell of each
// point.
std::vector<Cluster> clusters_of(const Model& model, float cell, std::vector<std::uint32_t>& cluster_of) {
  std::map<std::array<int, 3>, std::uint32_t> number_of;
  std::vector<Cluster> clusters;
  for (const Point& point : model.points) {
    std::array<int, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = static_cast<int>(std::floor(point[k] / cell));
    const auto number = number_of.try_emplace(at, static_cast<std::uint32_t>(clusters.size())).first->second;
    if (number == clusters.size()) clusters.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) clusters[number].sum[k] += point[k];
    ++clusters[number].count;
    cluster_of.push_back(number);
  }
  return clusters;
}

Mesh cluster(const Model& model, float cell) {
  std::vector<std::uint32_t> cluster_of;
  std::vector<Cluster> clusters = clusters_of(model, cell, cluster_of);
  Mesh mesh;
  std::set<std::array<std::uint32_t, 3>> seen;
  for (const auto& [a, b, c] : model.triangles) {
    const Point normal = face_normal(model.points[a], model.points[b], model.points[c]);
    for (const std::uint32_t corner : {a, b, c}) {
      for (std::size_t k = 0; k < 3; ++k) clusters[cluster_of[corner]].normal[k] += normal[k];
    }
    std::array<std::uint32_t, 3> t{cluster_of[a], cluster_of[b], cluster_of[c]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    if (seen.insert(t).second) mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
  }
  for (const Cluster& one : clusters) {
    Vertex vertex{};
    const float size = std::hypot(one.normal[0], one.normal[1], one.normal[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      vertex.position[k] = one.sum[k] / one.count;
      vertex.normal[k] = size > 0 ? one.normal[k] / size : 0.0F;
    }
    mesh.vertices.push_back(vertex);
  }
  return mesh;
}

}  // namespace

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  if (models_folder.empty()) return names;
  for (const auto& entry : std::filesystem::directory_iterator(models_folder)) {
    if (entry.path().extension() == ".ply") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Mesh load_model(const std::string& name, std::size_t triangles) {
  Model model = read_ply(models_folder + "/" + name + ".ply");
  if (model.triangles.empty()) throw std::runtime_error(name + ": a cloud of points has no triangles to refine");
  scale_to_unit_sphere(model);
  float fine = 0.005F;
  float coarse = 0.5F;
  while (coarse - fine > 0.002F) {
    const float middle = 0.5F * (fine + coarse);
    (cluster(model, middle).triangles() > triangles ? fine : coarse) = middle;
  }
  return cluster(model, coarse);
}

}  // namespace glark::bench
