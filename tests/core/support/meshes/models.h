// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Real models, if there are any (GLARK_MODELS: a folder of binary PLY files packed with zstd), made coarse.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/core/support/meshes/closed_mesh.h"

namespace glark::core::test {

inline std::string unpacked(const std::string& file) {
  std::string text;
  FILE* const pipe = popen(("zstd -dcq '" + file + "'").c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 65536> block{};
  for (std::size_t size = 0; (size = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
    text.append(block.data(), size);
  pclose(pipe);
  return text;
}

// Reads a mesh of triangles whose vertices begin with x, y, z. Empty for any other file.
inline Mesh read_ply(const std::string& text) {
  const std::map<std::string, std::size_t> sizes{{"float", 4}, {"uchar", 1}, {"int", 4}, {"double", 8}};
  std::istringstream header(text.substr(0, text.find("end_header")));
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t stride = 0;
  for (std::string line; std::getline(header, line);) {
    std::istringstream words(line);
    std::string first;
    std::string second;
    words >> first >> second;
    if (first == "element") words >> (second == "vertex" ? vertices : faces);
    if (first == "property" && second != "list") stride += sizes.at(second);
  }
  std::size_t at = text.find("end_header") + sizeof("end_header");
  Mesh mesh;
  if (text.size() < at + vertices * stride + faces * 13 || stride < 12) return mesh;
  mesh.positions.resize(vertices);
  for (auto& position : mesh.positions) {
    std::memcpy(position.data(), text.data() + at, sizeof(position));
    at += stride;
  }
  for (std::size_t i = 0; i < faces; ++i, at += 13) {
    std::array<std::int32_t, 3> corners{};
    std::memcpy(corners.data(), text.data() + at + 1, sizeof(corners));
    mesh.triangles.push_back({static_cast<std::size_t>(corners[0]), static_cast<std::size_t>(corners[1]),
                              static_cast<std::size_t>(corners[2])});
  }
  return mesh;
}

// Scales the mesh into the cube from -1 to 1, and keeps one vertex in each cell of a grid. A closed mesh remains
// closed, but it may not remain a manifold.
inline Mesh clustered(const Mesh& mesh, int cells) {
  std::array<GLfloat, 3> low = mesh.positions.at(0);
  std::array<GLfloat, 3> high = low;
  for (const auto& position : mesh.positions) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], position[i]);
      high[i] = std::max(high[i], position[i]);
    }
  }
  const GLfloat size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  Mesh result;
  std::map<std::array<int, 3>, std::size_t> by_cell;
  std::vector<std::size_t> moved;
  for (const auto& position : mesh.positions) {
    std::array<int, 3> cell{};
    std::array<GLfloat, 3> placed{};
    for (std::size_t i = 0; i < 3; ++i) {
      placed[i] = (2 * position[i] - low[i] - high[i]) / size;
      cell[i] = static_cast<int>((placed[i] + 1) / 2 * static_cast<GLfloat>(cells));
    }
    const auto [entry, fresh] = by_cell.emplace(cell, result.positions.size());
    if (fresh) result.positions.push_back(placed);
    moved.push_back(entry->second);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    if (moved[a] != moved[b] && moved[b] != moved[c] && moved[c] != moved[a]) {
      result.triangles.push_back({moved[a], moved[b], moved[c]});
    }
  }
  return result;
}

// Returns whether as many triangles run along each edge in one direction as in the other.
inline bool is_closed(const Mesh& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> balance;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = t[k];
      const std::size_t to = t[(k + 1) % 3];
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return std::all_of(balance.begin(), balance.end(), [](const auto& entry) { return entry.second == 0; });
}

inline std::optional<Mesh> coarse_model(const std::string& name, int cells) {
  const std::string file = std::string(GLARK_MODELS) + "/" + name + ".ply.zst";
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Mesh mesh = read_ply(unpacked(file));
  return mesh.triangles.empty() ? std::nullopt : std::optional(clustered(mesh, cells));
}

}  // namespace glark::core::test
