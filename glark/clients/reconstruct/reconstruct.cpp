// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <glark/reconstruct.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "glark/clients/common/points/point_set.h"
#include "glark/clients/reconstruct/density/all_outliers.h"
#include "glark/clients/reconstruct/density/even_samples.h"
#include "glark/clients/reconstruct/density/layers.h"
#include "glark/clients/reconstruct/mesh/refinement.h"
#include "glark/clients/reconstruct/result/listed.h"
#include "glark/clients/reconstruct/result/places.h"

namespace glark::reconstruct {
namespace {

void check(const ReconstructOptions& options) {
  const auto within = [](double value, double least, double most, const char* name) {
    if (value >= least && value <= most) return;
    throw vstree::Error(vstree::Element::option, 0,
                        fmt::format("{} is {}; {} to {} is possible", name, value, least, most));
  };
  within(static_cast<double>(options.threshold), 0, 1e18, "threshold");
  within(static_cast<double>(options.delta_a), 0, 1, "delta_a");
  within(static_cast<double>(options.delta_d), 0, 1, "delta_d");
  within(static_cast<double>(options.error), 0, 1, "error");
  within(options.levels, 0, 6, "levels");
  within(static_cast<double>(options.node_samples), 2, 1000, "node_samples");
  within(options.gap_edges, 0, 1000, "gap_edges");
  within(static_cast<double>(options.least_part), 0, 1, "least_part");
}

// Writes the vertices, scaled from the unit cube to the unit of the positions.
void write_vertices(const RefinedMesh& mesh, const Cube& cube, const Workers& workers, Reconstructed& result) {
  result.positions.resize(3 * mesh.points.size());
  result.normals.resize(3 * mesh.points.size());
  result.colours.resize(3 * mesh.colours.size());
  workers.each(mesh.points.size(), 1 << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Float4 point = cube.low + mesh.points[i] * cube.side;
      for (int k = 0; k < 3; ++k) {
        result.positions[3 * i + static_cast<std::size_t>(k)] = point[k];
        result.normals[3 * i + static_cast<std::size_t>(k)] = mesh.normals[i][k];
      }
      if (mesh.colours.empty()) continue;
      for (int k = 0; k < 3; ++k) {
        result.colours[3 * i + static_cast<std::size_t>(k)] =
            static_cast<std::uint8_t>(std::clamp(mesh.colours[i][k] + 0.5F, 0.0F, 255.0F));
      }
    }
  });
}

// An error whose text names this library; the checks are those of glark-vstree.
class ReconstructError final : public vstree::Error {
 public:
  explicit ReconstructError(const vstree::Error& error) : vstree::Error(error), text_(error.what()) {
    constexpr std::string_view other = "glark-vstree";
    if (text_.starts_with(other)) text_.replace(0, other.size(), "glark-reconstruct");
  }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

// Returns the samples with their normals, or else with estimated ones, which the caller keeps.
PointSet with_normals(const PointSet& given, unsigned threads, std::vector<float>& estimated) {
  PointSet points = given;
  if (!points.normals.empty()) return points;
  estimated = vstree::estimate_normals(points, {.threads = threads});
  points.normals = estimated;
  return points;
}

Reconstructed mesh_of_layer(const PointSet& points, SortedSamples sorted, const ReconstructOptions& options,
                            const Workers& workers) {
  Reconstructed result;
  const Octree octree = octree_of(points, std::move(sorted), options, workers);
  if (octree.levels.empty()) return result;
  const TransitionLayer layer = transition_layer(octree, options, workers);
  BaseMesh base = base_mesh(contour(layer, octree.finest().level, workers), layer, octree, options, workers);
  result.base_vertices = static_cast<std::uint32_t>(base.points.size());
  result.base_triangles = static_cast<std::uint32_t>(base.triangles.size() / 3);
  result.left_out = base.left_out;
  result.area_left_out = base.area_left_out;
  result.node_side = octree.finest().side() * octree.cube.side;
  result.noise = octree.noise * octree.cube.side;
  RefinedMesh mesh = refine(std::move(base), octree, options, workers);
  result.levels = mesh.levels;
  result.triangles = std::move(mesh.triangles);
  write_vertices(mesh, octree.cube, workers, result);
  return result;
}

template <typename Number>
std::vector<Number> chosen(std::span<const Number> all, const std::vector<std::uint32_t>& indices) {
  std::vector<Number> result;
  if (all.empty()) return result;
  result.reserve(3 * indices.size());
  for (const std::uint32_t i : indices)
    result.insert(result.end(), &all[3 * std::size_t{i}], &all[3 * std::size_t{i}] + 3);
  return result;
}

// Reconstructs one of several layers on its own. The options are relative to all samples.
void add(const PointSet& all, const Cube& cube, const std::vector<std::uint32_t>& layer, ReconstructOptions options,
         const Workers& workers, Reconstructed& result) {
  const std::vector<float> positions = chosen(all.positions, layer), normals = chosen(all.normals, layer);
  const std::vector<std::uint8_t> colours = chosen(all.colours, layer);
  const PointSet points{.positions = positions, .normals = normals, .colours = colours};
  SortedSamples sorted = sort_by_cells(points, workers);
  const float larger = cube.side * cube.diagonal / (sorted.cube.side * sorted.cube.diagonal);
  const float share = 3 * static_cast<float>(layer.size()) / static_cast<float>(all.positions.size());
  options.threshold *= larger;
  options.error *= larger;
  options.least_part /= share;
  const Reconstructed mesh = mesh_of_layer(points, std::move(sorted), options, workers);
  const auto first = static_cast<std::uint32_t>(result.positions.size() / 3);
  for (const std::uint32_t i : mesh.triangles) result.triangles.push_back(first + i);
  const auto append = [](const auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  append(mesh.positions, result.positions);
  append(mesh.normals, result.normals);
  append(mesh.colours, result.colours);
  result.base_vertices += mesh.base_vertices;
  result.base_triangles += mesh.base_triangles;
  result.left_out += mesh.left_out;
  result.area_left_out += share * mesh.area_left_out;
  result.levels = std::max(result.levels, mesh.levels);
  result.node_side = std::max(result.node_side, mesh.node_side);
  result.noise = std::max(result.noise, mesh.noise);
}

Listed mesh_of(const PointSet& given, const ReconstructOptions& options) {
  const Workers workers(options.threads);
  check(options);
  check(given, workers);
  std::vector<float> estimated;
  const PointSet points = with_normals(given, options.threads, estimated);
  EvenSamples even(points, workers);
  SortedSamples sorted = even.take_sorted();
  Reconstructed result;
  const std::vector<std::vector<std::uint32_t>> layers = layers_of(even.points(), sorted, workers);
  if (layers.empty()) {
    result = mesh_of_layer(even.points(), std::move(sorted), options, workers);
  } else {
    for (const std::vector<std::uint32_t>& layer : layers)
      add(even.points(), sorted.cube, layer, options, workers, result);
  }
  part_places(result.positions, result.normals, result.triangles);
  std::vector<std::uint32_t> outliers = even.outliers();
  result.outliers = static_cast<std::uint32_t>(outliers.size());
  return {std::move(result), std::move(outliers)};
}

}  // namespace

Reconstructed reconstruct(const PointSet& points, const ReconstructOptions& options) {
  return reconstruct_and_list(points, options).mesh;
}

Listed reconstruct_and_list(const PointSet& points, const ReconstructOptions& options) {
  try {
    return mesh_of(points, options);
  } catch (const vstree::Error& error) {
    throw ReconstructError(error);
  }
}

std::vector<std::uint32_t> find_outliers(const PointSet& points, unsigned threads) {
  try {
    const Workers workers(threads);
    check(points, workers);
    std::vector<float> estimated;
    return all_outliers(with_normals(points, threads, estimated), workers);
  } catch (const vstree::Error& error) {
    throw ReconstructError(error);
  }
}

}  // namespace glark::reconstruct
