// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/parts/large_mesh_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "glark/tool/scan/info/contents.h"

namespace glark::tool {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t bytes_of_program = std::uint64_t{40} << 20;
constexpr std::uint64_t bytes_of_sample = 1000;  // with its triangles, while these are simplified; measured: 600
constexpr std::uint64_t samples_of_vertex = 3;   // the result has a vertex for so many samples
constexpr std::uint64_t least_samples = 20000;

// Keeps what is written.
class GeometryWriter final : public stream::PointWriter {
 public:
  GeometryWriter(stream::Schema schema, geometry::Geometry& to) : schema_(std::move(schema)), to_(to) {
    has_colours_ = stream::channel_index(schema_, "red") != stream::none;
  }
  const stream::Schema& schema() const override { return schema_; }
  void write(const stream::Points& points) override {
    if (to_.positions.empty() && points.size() > 0 && schema_.position == stream::Number::float64)
      for (std::size_t axis = 0; axis < 3; ++axis) to_.origin[axis] = std::floor(points.positions[axis]);
    for (std::size_t i = 0; i < points.positions.size(); ++i)
      to_.positions.push_back(static_cast<float>(points.positions[i] - to_.origin[i % 3]));
    to_.normals.insert(to_.normals.end(), points.normals.begin(), points.normals.end());
    for (std::size_t i = 0; has_colours_ && i < points.size(); ++i) {
      for (const char* name : {"red", "green", "blue"})
        to_.colours.push_back(static_cast<std::uint8_t>(
            points.channels[schema_.channels.size() * i + stream::channel_index(schema_, name)]));
      to_.colours.push_back(255);
    }
  }
  void finish() override {}

 private:
  stream::Schema schema_;
  geometry::Geometry& to_;
  bool has_colours_ = false;
};

// A sample has a position, a normal and a colour.
void warn_of_other_attributes(const Files& files, const Report& names) {
  std::string lost;
  for (const std::string name : names)
    if (name != "normals" && name != "colours") lost += (lost.empty() ? "" : ", ") + name;
  if (!lost.empty()) warn(fmt::format("{}: {} are lost, because the file is read in parts", files.input, lost));
}

// What is read from a pipe is gone.
void require_passes(const Files& files) {
  std::error_code error;
  if (fs::exists(path_of(files), error) && !fs::is_regular_file(path_of(files), error))
    throw std::runtime_error(files.input +
                             ": is no regular file, and reading within --memory takes several passes; write it to a "
                             "disk first, or leave --memory out");
}

}  // namespace

fs::path folder_of(const Files& files) { return fs::absolute(fs::path(files.output)).parent_path(); }

std::size_t sample_count(const Files& files, const PartsOptions& options) {
  const std::uint64_t most =
      options.memory > bytes_of_program ? (options.memory - bytes_of_program) / bytes_of_sample : 0;
  const std::uint64_t wanted = std::max<std::uint64_t>(least_samples, samples_of_vertex * options.target / 2);
  if (options.target > 0 && most < std::max<std::uint64_t>(1000, options.target * 3 / 4))
    throw std::runtime_error(
        fmt::format("{}: --target {} needs about {} MB; give so much with --memory, or a smaller target", files.input,
                    options.target, (bytes_of_program + bytes_of_sample * options.target) >> 20));
  return static_cast<std::size_t>(options.target > 0 ? std::min(most, wanted) : most);
}

stream::SampleOptions sampling_options(const Files& files, std::size_t target, const PartsOptions& options) {
  stream::SampleOptions sampling;
  sampling.target = target;
  sampling.memory = std::max<std::size_t>(std::size_t{40} << 20, static_cast<std::size_t>(options.memory / 2));
  sampling.threads = options.threads;
  sampling.skip_invalid = files.skip_invalid;
  return sampling;
}

std::unique_ptr<stream::PointWriter> writer_to(geometry::Geometry& geometry, const stream::Schema& schema) {
  return std::make_unique<GeometryWriter>(schema, geometry);
}

bool has_attribute(const Report& contents, const char* name) {
  const Report& names = contents["attributes"];
  return std::find(names.begin(), names.end(), name) != names.end();
}

geometry::Geometry without_lonely_samples(const geometry::Geometry& samples, std::vector<std::uint32_t> triangles) {
  constexpr std::uint32_t unused = 0xFFFFFFFF;
  std::vector<std::uint32_t> number(samples.point_count(), unused);
  geometry::Geometry mesh;
  mesh.origin = samples.origin;
  for (std::uint32_t& corner : triangles) {
    std::uint32_t& renamed = number[corner];
    if (renamed == unused) {
      renamed = static_cast<std::uint32_t>(mesh.point_count());
      for (std::size_t axis = 0; axis < 3; ++axis) mesh.positions.push_back(samples.positions[3 * corner + axis]);
      for (std::size_t axis = 0; axis < 3 && !samples.normals.empty(); ++axis)
        mesh.normals.push_back(samples.normals[3 * corner + axis]);
      for (std::size_t k = 0; k < 4 && !samples.colours.empty(); ++k)
        mesh.colours.push_back(samples.colours[4 * corner + k]);
    }
    corner = renamed;
  }
  mesh.triangles = std::move(triangles);
  return mesh;
}

Report contents_of_large(const Files& files) {
  require_passes(files);
  Report contents = contents_in_parts(files);
  contents.erase("peak_memory_bytes");
  warn_of_other_attributes(files, contents["attributes"]);
  return contents;
}

}  // namespace glark::tool
