// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark strip FILE -o OUT: adds triangle strips that interpolate the points, which stay as they are.
#include <fmt/format.h>

#include <glark/surfel.h>
#if GLARK_HAS_RECONSTRUCT
#include <glark/reconstruct.h>
#endif

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "glark/clients/geometry/measure/topology.h"
#include "glark/clients/geometry/measure/triangle_normals.h"
#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/parts/memory_option.h"
#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/quality.h"
#include "glark/tool/scan/validators.h"
#if GLARK_HAS_STREAM
#include "glark/tool/scan/parts/large_mesh.h"
#endif

namespace glark::tool {
namespace {

struct Strip {
  Files files;
  std::string reference;
  surfel::Options options;
  unsigned level = 0;
  Memory memory;  // larger files are read in parts
};

// The points, or samples of them if the file does not fit into the memory.
geometry::Geometry read_points(const Strip& command, bool& is_whole) {
  is_whole = true;
#if GLARK_HAS_STREAM
  const Files& files = command.files;
  if (const Memory memory = memory_for(command.memory); must_read_in_parts(files, memory)) {
    is_whole = false;
    if (!command.reference.empty())
      throw std::runtime_error(
          "--measure keeps the whole file in the memory; measure the result: glark info OUT --measure");
    LargeMesh large = sample_in_parts(files, {memory.bytes, 0, command.options.threads});
    const auto points = large.contents.value("points", std::uint64_t{0});
    if (large.geometry.point_count() < points)
      warn(fmt::format("{}: the strips connect {} samples of its {} points, as many as fit into the memory",
                       files.input, large.geometry.point_count(), points));
    return std::move(large.geometry);
  }
#endif
  return load(command.files.input, command.files);
}

// The strips of the points, without outliers.
struct Stripped {
  std::optional<surfel::Strips> strips;
  std::vector<std::uint32_t> points;  // the point of the file for each point of the strips; empty: they are the same
  std::size_t outliers = 0;

  std::uint32_t point_of(std::uint32_t index) const { return points.empty() ? index : points[index]; }
};

// Adds the strip of a leaf. Adds its triangles without the degenerate ones, which only join parts of the strip.
void add_strip(geometry::Geometry& geometry, const Stripped& stripped, std::span<const std::uint32_t> strip) {
  const std::size_t first = geometry.strips.size();
  for (const std::uint32_t index : strip) geometry.strips.push_back(stripped.point_of(index));
  geometry.strip_sizes.push_back(static_cast<std::uint32_t>(strip.size()));
  for (std::size_t i = 2; i < strip.size(); ++i) {
    const std::uint32_t a = geometry.strips[first + i - 2];
    const std::uint32_t b = geometry.strips[first + i - 1];
    const std::uint32_t c = geometry.strips[first + i];
    if (a == b || b == c || c == a) continue;
    const bool turned = i % 2 == 1;
    geometry.triangles.insert(geometry.triangles.end(), {a, turned ? c : b, turned ? b : c});
  }
}

#if GLARK_HAS_RECONSTRUCT
// Returns whether so many points have no triangles that there may be outliers.
bool may_have_outliers(const surfel::Strips& strips) {
  constexpr double least_share = 0.001;
  std::vector<bool> is_connected(strips.point_count());
  for (const surfel::Node& node : strips.nodes(0)) {
    if (node.left != surfel::none) continue;
    for (const std::uint32_t i : strips.indices().subspan(node.first, node.count)) is_connected[i] = true;
  }
  const auto without = std::count(is_connected.begin(), is_connected.end(), false);
  return static_cast<double>(without) > least_share * static_cast<double>(is_connected.size());
}

// Makes the strips again without the outliers, if there are any. They would be joined by large triangles.
void strip_without_outliers(const geometry::Geometry& geometry, const surfel::Options& options, Stripped& stripped) {
  const std::vector<std::uint32_t> outliers =
      reconstruct::find_outliers({.positions = geometry.positions, .normals = geometry.normals}, options.threads);
  if (outliers.empty()) return;
  std::vector<float> positions, normals;
  for (std::uint32_t i = 0, next = 0; i < geometry.point_count(); ++i) {
    if (next < outliers.size() && outliers[next] == i) {
      ++next;
      continue;
    }
    stripped.points.push_back(i);
    positions.insert(positions.end(), &geometry.positions[3 * std::size_t{i}],
                     &geometry.positions[3 * std::size_t{i}] + 3);
    if (!geometry.normals.empty())
      normals.insert(normals.end(), &geometry.normals[3 * std::size_t{i}], &geometry.normals[3 * std::size_t{i}] + 3);
  }
  stripped.outliers = outliers.size();
  stripped.strips.emplace(surfel::Cloud{positions, normals}, options);
}
#endif

Stripped strips_of(const geometry::Geometry& geometry, const surfel::Options& options, double& seconds) {
  Stripped result;
  Progress progress("stripping");
  progress.show(-1);
  result.strips.emplace(surfel::Cloud{geometry.positions, geometry.normals}, options);
#if GLARK_HAS_RECONSTRUCT
  if (may_have_outliers(*result.strips)) strip_without_outliers(geometry, options, result);
#endif
  seconds = progress.seconds();
  return result;
}

// Adds the strips of the points to `geometry`.
surfel::Counts add_strips(const Strip& command, geometry::Geometry& geometry, std::size_t& outliers, double& seconds) {
  surfel::Options options = command.options;
  options.levels = command.level + 1;
  const Stripped stripped = strips_of(geometry, options, seconds);
  outliers = stripped.outliers;
  const surfel::Strips& strips = *stripped.strips;
  const unsigned level = std::min(command.level, strips.level_count() - 1);
  if (level < command.level)
    warn(fmt::format("there are fewer levels of detail; the coarsest one, {}, is used", level));
  for (const surfel::Node& node : strips.nodes(level))
    if (node.left == surfel::none && node.count > 0)
      add_strip(geometry, stripped, strips.indices().subspan(node.first, node.count));
  return strips.counts(level);
}

// Without normals, strips do not know the sides of the surface. The triangles of a mesh tell them.
void add_normals(geometry::Geometry& geometry, const std::string& file) {
  if (!geometry.normals.empty()) return;
  if (!geometry.triangles.empty()) {
    geometry.normals = geometry::triangle_normals(geometry);
    bool has_all = true;
    for (std::size_t i = 0; i < geometry.normals.size(); i += 3)
      has_all = has_all && (geometry.normals[i] != 0 || geometry.normals[i + 1] != 0 || geometry.normals[i + 2] != 0);
    if (has_all) return warn(file + ": it has no normals; those of its triangles are used");
    geometry.normals.clear();
  }
  warn(file + ": it has no normals, so strips have no common orientation");
}

std::size_t points_without_triangles(const geometry::Geometry& geometry) {
  std::vector<bool> has_triangle(geometry.point_count());
  for (const std::uint32_t corner : geometry.triangles) has_triangle[corner] = true;
  return static_cast<std::size_t>(std::count(has_triangle.begin(), has_triangle.end(), false));
}

void warn_of_points(const std::string& file, const geometry::Geometry& geometry, const surfel::Counts& counts,
                    std::size_t outliers) {
  constexpr double many = 0.1;  // of all points
  const std::size_t points = geometry.point_count();
  const std::size_t without = points_without_triangles(geometry);
  if (outliers > 0)
    warn(fmt::format("{}: {} of {} points lie on no surface, as their neighbours show; they stay points", file,
                     outliers, points));
  if (counts.loose_points > 0)
    warn(fmt::format("{}: {} of {} points lie in parts that are too noisy for a surface; they stay points", file,
                     counts.loose_points, points));
  const auto is_many = [&](std::size_t known) {
    return static_cast<double>(without) > static_cast<double>(known) + many * static_cast<double>(points);
  };
  const std::size_t known = outliers + counts.loose_points;
  // If several points have the same position, strips use only one of them.
  if (is_many(known) && is_many(known + points - geometry::topology_of(geometry).places))
    warn(
        fmt::format("{}: {} of {} points have no triangle; if they are the corners of large triangles, take points "
                    "between them by glark reconstruct",
                    file, without, points));
}

void strip(const Strip& command) {
  check_output(command.files);
  bool is_whole = true;
  geometry::Geometry geometry = read_points(command, is_whole);
  add_normals(geometry, command.files.input);
  geometry.triangles = {};
  double seconds = 0;
  std::size_t outliers = 0;
  const surfel::Counts counts = add_strips(command, geometry, outliers, seconds);
  if (geometry.strips.empty())
    throw geometry::Error(
        command.files.input +
        ": its points have no neighbours on a surface, or are too noisy for one, so there are no strips and nothing is "
        "written; allow longer edges by --reach, or show the points by glark view --mode splat");
  warn_of_points(command.files.input, geometry, counts, outliers);
  store(geometry, command.files);
  Report report;
  report["output"] = contents_of(geometry);
  report["strips"] = counts.strips;
  report["loose_points"] = counts.loose_points;
  report["outliers"] = outliers;
  report["points_without_triangles"] = points_without_triangles(geometry);
  report["indices"] = counts.indices;
  if (!geometry.triangles.empty())
    report["indices_per_triangle"] =
        static_cast<double>(counts.indices) / static_cast<double>(geometry.triangle_count());
  report["seconds"] = seconds;
  if (!is_whole) report["peak_memory_bytes"] = peak_memory();
  if (!command.reference.empty()) {
    report["topology"] = topology_report(geometry);
    report["quality"] = quality_report(geometry, command.reference, command.files);
  }
  print(report, command.files.json);
}

}  // namespace

void add_strip(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "strip", "Connect the points by triangle strips; PLY files get tristrips, other formats triangles");
  const auto stripping = std::make_shared<Strip>();
  describe_input(*command, stripping->files, {"las", "raw"});
  describe_output(*command, stripping->files);
  describe_measure(*command, stripping->reference);
  command
      ->add_option("--leaf-points", stripping->options.leaf_points,
                   fmt::format("Most points of a strip, 8 to 1024; default {}", stripping->options.leaf_points))
      ->check(CLI::Range(8, 1024));
  command->add_flag_callback(
      "--keep-edges", [stripping] { stripping->options.turn_edges = false; },
      "Do not flip edges for longer strips; strips have more indices then");
  command
      ->add_option("--reach", stripping->options.reach,
                   "Longest edge, in distances of neighbouring points, 1 to 100; default 5")
      ->check(between(1.0, 100.0));
  command
      ->add_option("--inflation", stripping->options.inflation,
                   fmt::format("Overlap of strips before they are cut, in distances of points, 0.5 to 8; default {}",
                               stripping->options.inflation))
      ->check(between(0.5, 8.0));
  command
      ->add_option("--level", stripping->level,
                   "Level of detail, 0 to 15; each has a quarter of the points of the one before; default 0")
      ->check(CLI::Range(0, 15));
  describe_threads(*command, stripping->options.threads);
  describe_memory(*command, stripping->memory);
  command->callback([stripping] { strip(*stripping); });
}

}  // namespace glark::tool
