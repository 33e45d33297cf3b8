// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/bake/coarse_mesh.h"

#include <fmt/format.h>

#include <glark/reconstruct.h>
#include <glark/stream.h>
#include <glark/surfel.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "glark/clients/common/mesh/rounded_places.h"
#include "glark/clients/geometry/measure/distance.h"
#include "glark/tool/scan/bake/folds.h"
#include "glark/tool/scan/console.h"
#include "glark/tool/scan/simplified.h"

namespace glark::tool {
namespace {

// Strips of fewer samples would bridge what stands out of sparse ground, as houses do. They are simplified afterwards.
constexpr std::size_t samples_a_triangle = 5;

constexpr const char* samples_name = "samples";  // of the saved work

// Keeps the points that are written.
class Collector final : public stream::PointWriter {
 public:
  Collector(stream::Schema schema, geometry::Geometry& points, SavedWork& work)
      : schema_(std::move(schema)), points_(points), work_(work) {}
  const stream::Schema& schema() const override { return schema_; }
  void write(const stream::Points& points) override {
    if (points.size() > 0 && points_.positions.empty())
      for (std::size_t axis = 0; axis < 3; ++axis) points_.origin[axis] = points.positions[axis];
    for (std::size_t i = 0; i < points.positions.size(); ++i)
      points_.positions.push_back(static_cast<float>(points.positions[i] - points_.origin[i % 3]));
    points_.normals.insert(points_.normals.end(), points.normals.begin(), points.normals.end());
  }
  // The sampling removes its own work after this.
  void finish() override { work_.save(samples_name, points_, 0); }

 private:
  stream::Schema schema_;
  geometry::Geometry& points_;
  SavedWork& work_;
};

void add_triangles(const surfel::Strips& strips, geometry::Geometry& geometry) {
  for (const surfel::Node& node : strips.nodes()) {
    if (node.left != surfel::none) continue;
    const auto strip = strips.indices().subspan(node.first, node.count);
    for (std::size_t i = 2; i < strip.size(); ++i) {
      const std::uint32_t a = strip[i - 2], b = strip[i - 1], c = strip[i];
      if (a == b || b == c || c == a) continue;
      const bool is_turned = i % 2 == 1;
      geometry.triangles.insert(geometry.triangles.end(), {a, is_turned ? c : b, is_turned ? b : c});
    }
  }
}

geometry::Geometry sample(const stream::Source& source, const CoarseOptions& options, bool skip_invalid,
                          SavedWork& work) {
  Progress progress("sampling " + source.name);
  stream::SampleOptions sampling;
  sampling.target = samples_a_triangle * options.triangles;
  sampling.memory = options.memory;
  sampling.threads = options.threads;
  sampling.skip_invalid = skip_invalid;
  sampling.progress = [&](double fraction) { progress.show(fraction); };
  sampling.work = work.part("sampling");
  sampling.resume = work.resumes() && !sampling.work.empty();
  geometry::Geometry points;
  stream::sample(source, sampling, std::filesystem::temp_directory_path(),
                 [&](const stream::Schema& schema) { return std::make_unique<Collector>(schema, points, work); });
  return points;
}

}  // namespace

geometry::Geometry read_coarse_mesh(const std::string& file, const Files& files) {
  if (file == "-") throw std::runtime_error("--mesh: standard input is for the points; write the mesh into a file");
  Files coarse = files;
  coarse.format.clear();
  geometry::Geometry mesh = load(file, coarse);
  if (mesh.triangles.empty())
    throw std::runtime_error(file +
                             ": it has no triangles; --mesh takes a mesh, as `glark reconstruct`, `glark strip` "
                             "or `glark simplify` write it");
  return mesh;
}

geometry::Geometry simplify_to(geometry::Geometry fine, const CoarseOptions& options) {
  Progress progress("simplifying");
  progress.show(-1);
  if (fine.triangle_count() <= options.triangles) return fine;
  vstree::SimplifyOptions simplify;
  simplify.target = options.triangles;
  simplify.threads = options.threads;
  simplify.method = vstree::Method::automatic;
  simplify.max_error = 1;
  fine.colours = {};  // seams of colours would keep vertices
  fine.texture_coordinates = {};
  common::join_rounded_places(fine.positions, fine.triangles);
  geometry::Geometry coarse = simplified(fine, simplify).geometry;
  unfold(coarse);
  return coarse;
}

CoarseReconstruction reconstruct_from(const geometry::Geometry& points, const CoarseOptions& options) {
  constexpr float least_part = 0.001F;  // of the area; smaller parts are mostly noise
  constexpr unsigned levels = 1;        // what more levels add is simplified away
  CoarseReconstruction coarse;
  geometry::Geometry& mesh = coarse.mesh;
  {
    Progress progress("reconstructing");
    progress.show(-1);
    reconstruct::Reconstructed result =
        reconstruct::reconstruct({.positions = points.positions, .normals = points.normals},
                                 {.levels = levels, .least_part = least_part, .threads = options.threads});
    coarse.noise = static_cast<double>(result.noise);
    mesh.origin = points.origin;
    mesh.positions = std::move(result.positions);
    mesh.normals = std::move(result.normals);
    mesh.triangles = std::move(result.triangles);
  }
  if (!mesh.triangles.empty()) mesh = simplify_to(std::move(mesh), options);
  return coarse;
}

geometry::Geometry strip_sampling(const stream::Source& source, const CoarseOptions& options, bool skip_invalid,
                                  SavedWork& work) {
  geometry::Geometry points;
  if (double noise = 0; !work.load(samples_name, points, noise)) points = sample(source, options, skip_invalid, work);
  const surfel::Strips strips({.positions = points.positions, .normals = points.normals}, {.threads = options.threads});
  add_triangles(strips, points);
  if (points.triangles.empty())
    throw std::runtime_error(
        fmt::format("{}: its {} samples show no surface; give a mesh by --mesh, or more --triangles", source.name,
                    points.point_count()));
  return simplify_to(std::move(points), options);
}

}  // namespace glark::tool
