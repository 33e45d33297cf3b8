// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/large_mesh.h"

#include <glark/stream.h>

#include <utility>

#include "glark/clients/geometry/formats.h"
#include "glark/tool/scan/info/contents.h"
#include "glark/tool/scan/parts/cluster_mesh.h"
#include "glark/tool/scan/parts/large_mesh_steps.h"

namespace glark::tool {
namespace {

geometry::Geometry sample(const Files& files, std::size_t target, const PartsOptions& options) {
  geometry::Geometry samples;
  Progress progress("sampling " + files.input);
  stream::SampleOptions sampling = sampling_options(files, target, options);
  sampling.progress = [&](double fraction) { progress.show(fraction); };
  stream::sample(stream::file_source(path_of(files), files.format), sampling, folder_of(files),
                 [&](const stream::Schema& schema) { return writer_to(samples, schema); });
  return samples;
}

// The corners of STL triangles follow one another, three for each.
void add_triangles_of_corners(const Files& files, ClusterMesh& mesh) {
  const auto reader = stream::open_points(
      path_of(files), {.format = files.format, .normals = true, .channels = false, .keep_invalid = files.skip_invalid});
  std::uint32_t first = 0;
  for (auto points = reader->read(3072); points.size() > 0; points = reader->read(3072)) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::array<float, 3> normal{};
      for (std::size_t axis = 0; axis < 3 && !points.normals.empty(); ++axis)
        normal[axis] = points.normals[3 * i + axis];
      mesh.add_point({points.positions[3 * i], points.positions[3 * i + 1], points.positions[3 * i + 2]}, normal);
    }
    for (std::size_t i = 0; i + 2 < points.size(); i += 3, first += 3) mesh.add_triangle({first, first + 1, first + 2});
  }
}

}  // namespace

void add_triangles(const Files& files, const Report& contents, ClusterMesh& mesh) {
  if (contents.contains("corners")) return add_triangles_of_corners(files, mesh);
  Progress progress("reading the triangles of " + files.input);
  geometry::summarise_file(path_of(files),
                           {.skip_invalid = files.skip_invalid, .format = files.format, .visitor = &mesh},
                           [&](double fraction) { progress.show(fraction); });
}

LargeMesh sample_in_parts(const Files& files, const PartsOptions& options) {
  Report contents = contents_of_large(files);
  return {sample(files, sample_count(files, options), options), std::move(contents)};
}

LargeMesh read_in_parts(const Files& files, const PartsOptions& options) {
  Report contents = contents_of_large(files);
  const bool has_triangles = contents["triangles"].get<std::uint64_t>() > 0;
  const std::size_t count = sample_count(files, options);
  if (!has_triangles) return {sample(files, options.target > 0 ? options.target : count, options), contents};
  geometry::Geometry samples = sample(files, count, options);
  if (!has_attribute(contents, "normals")) samples.normals.clear();  // those of the triangles are better
  const common::Workers workers(options.threads);
  ClusterMesh mesh(samples, folder_of(files), static_cast<std::size_t>(options.memory / 8), workers);
  add_triangles(files, contents, mesh);
  return {without_lonely_samples(samples, mesh.take_triangles()), contents};
}

}  // namespace glark::tool
