// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark reconstruct FILE -o OUT: reconstructs a mesh from points.
#include <fmt/format.h>
#include <glark/reconstruct.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "glark/clients/geometry/measure/area.h"
#include "glark/clients/geometry/measure/distance.h"
#include "glark/clients/geometry/measure/triangle_normals.h"
#include "glark/clients/reconstruct/result/listed.h"
#include "glark/clients/reconstruct/result/loss.h"
#include "glark/clients/reconstruct/result/places.h"
#include "glark/clients/reconstruct/samples/triangle_samples.h"
#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/quality.h"
#include "glark/tool/scan/rgb.h"
#include "glark/tool/scan/simplified.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {
namespace {

struct Reconstruct {
  Files files;
  std::string reference;
  reconstruct::ReconstructOptions options;
  std::size_t most_triangles = 0;  // 0: `triangles_a_point` for each point of the file
};

constexpr std::size_t triangles_a_point = 2;  // about as many as a mesh has whose vertices are the points

struct Seconds {
  double normals = 0;
  double reconstruction = 0;
  double simplification = 0;
};

// Returns whether all points have a normal.
bool has_normals(const geometry::Geometry& points) {
  for (std::size_t i = 0; i < points.normals.size(); i += 3) {
    if (points.normals[i] == 0 && points.normals[i + 1] == 0 && points.normals[i + 2] == 0) return false;
  }
  return !points.normals.empty();
}

// Gives normals to points that have none: from their triangles, or else estimated from nearby points.
void add_normals(geometry::Geometry& points, const std::string& file, Seconds& seconds) {
  if (!points.normals.empty()) return;
  if (!points.triangles.empty()) {
    points.normals = geometry::triangle_normals(points);
    warn(file + ": it has no normals; those of its triangles are used");
    if (has_normals(points)) return;
  } else {
    warn(file + ": it has no normals; they are estimated, and their orientation is guessed");
  }
  Progress progress("estimating normals");
  progress.show(-1);
  points.normals = vstree::estimate_normals({.positions = points.positions, .normals = points.normals});
  seconds.normals = progress.seconds();
}

// Returns points on the triangles if these are so large that their corners do not show the surface; otherwise, none.
geometry::Geometry points_on_triangles(const geometry::Geometry& mesh, const std::string& file) {
  constexpr double least_share = 0.2;  // of the area, in long triangles; scans have at most half of this
  constexpr std::size_t few_corners = 1000;
  constexpr std::size_t samples_a_triangle = 64, fewest = 100000, most = 500000;
  geometry::Geometry points;
  if (mesh.triangles.empty()) return points;
  if (mesh.point_count() >= few_corners &&
      reconstruct::share_of_long_triangles(mesh.positions, mesh.triangles) < least_share)
    return points;
  const std::size_t limit = std::max(4 * mesh.point_count(), most);
  const std::size_t count = std::clamp(samples_a_triangle * mesh.triangle_count(), fewest, limit);
  reconstruct::TriangleSamples samples =
      reconstruct::sample_triangles(mesh.positions, mesh.colours, mesh.triangles, count);
  points.origin = mesh.origin;
  points.positions = std::move(samples.positions);
  points.normals = std::move(samples.normals);
  points.colours = std::move(samples.colours);
  warn(fmt::format("{}: it has large triangles, whose corners do not show the surface; {} points on them are used",
                   file, points.point_count()));
  return points;
}

reconstruct::Listed reconstruct(const geometry::Geometry& points, const Reconstruct& command, Seconds& seconds) {
  Progress progress("reconstructing");
  progress.show(-1);
  const std::vector<std::uint8_t> colours = rgb_of(points.colours);
  reconstruct::Listed result = reconstruct::reconstruct_and_list(
      {.positions = points.positions, .normals = points.normals, .colours = colours}, command.options);
  seconds.reconstruction = progress.seconds();
  return result;
}

Report report_of(const reconstruct::Reconstructed& result) {
  Report report;
  report["base_vertices"] = result.base_vertices;
  report["base_triangles"] = result.base_triangles;
  report["levels"] = result.levels;
  report["node_side"] = result.node_side;
  report["noise"] = result.noise;
  report["parts_left_out"] = result.left_out;
  report["area_left_out_percent"] = 100 * static_cast<double>(result.area_left_out);
  report["outliers"] = result.outliers;
  return report;
}

// Throws if there are no triangles, so that an empty mesh replaces no file.
void require_triangles(const reconstruct::Reconstructed& result, const std::string& file) {
  if (!result.triangles.empty()) return;
  throw geometry::Error(
      file +
      ": the mesh is empty, so nothing is written: no surface is found in the points. Normals must point to the "
      "outside, "
      "also those of two layers near to each other; find smaller parts by a smaller --node-samples. A point far away "
      "from all others makes the box too large; remove such points");
}

// Warns about parts and outliers that were left out on purpose.
void warn_of_left_out(const geometry::Geometry& points, const Report& numbers, const std::string& file,
                      float least_part) {
  const auto parts = numbers["parts_left_out"].get<std::uint32_t>();
  if (parts > 0)
    warn(fmt::format(
        "{}: parts with less than {:.3g} % of the area are left out: {}, with {:.2g} % of the area together; "
        "--least-part 0 keeps them",
        file, 100 * least_part, parts, numbers["area_left_out_percent"].get<double>()));
  const auto outliers = numbers["outliers"].get<std::size_t>();
  if (outliers > 0)
    warn(fmt::format("{}: {} of {} points lie on no surface, as their neighbours show; they are left out as outliers",
                     file, outliers, points.point_count()));
}

// The distance that the options allow between the mesh and the points.
float tolerance_of(const geometry::Geometry& points, const reconstruct::ReconstructOptions& options) {
  const auto diagonal = static_cast<float>(geometry::diagonal_of(points));
  return 3 * std::max(options.threshold, options.error) * diagonal;  // both are root mean squares
}

// Reports how many points the mesh does not represent, and warns. Throws if it does not represent most of them.
void report_loss(const reconstruct::Loss& loss, Report& report, const Reconstruct& command) {
  constexpr double told = 0.005, too_much = 0.5;
  const std::string& file = command.files.input;
  report["points_left_out"] = static_cast<std::size_t>(std::llround(loss.share() * static_cast<double>(loss.points)));
  report["points_left_out_percent"] = 100 * loss.share();
  report["points_measured"] = loss.measured;
  if (loss.share() < told) return;
  const std::string what =
      loss.measured < loss.points
          ? fmt::format("about {:.2g} % of the points (estimated from {} of them)", 100 * loss.share(), loss.measured)
          : fmt::format("{} of {} points", loss.lost, loss.points);
  const char* const remedy =
      "a smaller --node-samples or --least-part keeps more. Of sheets that are nearer to each other than their points, "
      "only denser points show more";
  if (loss.share() > too_much)
    throw geometry::Error(
        fmt::format("{}: the mesh does not represent {}, so nothing is written; {}", file, what, remedy));
  warn(
      fmt::format("{}: {} are left out: the mesh is more than three distances of points away; {}", file, what, remedy));
}

// Makes at most two triangles meet in each edge.
void part_sheets(geometry::Geometry& mesh) {
  const std::size_t before = mesh.point_count();
  const std::vector<std::uint32_t> originals = reconstruct::cut_at_edges(mesh.positions, mesh.triangles);
  const auto copy = [](auto& array, std::size_t size, std::size_t original) {
    for (std::size_t k = 0; k < size && !array.empty(); ++k) {
      const auto value = array[size * original + k];
      array.push_back(value);
    }
  };
  for (std::size_t i = before; i < originals.size(); ++i) {
    copy(mesh.positions, 3, originals[i]);
    copy(mesh.normals, 3, originals[i]);
    copy(mesh.colours, 4, originals[i]);
  }
  reconstruct::part_places(mesh.positions, mesh.normals, mesh.triangles);
}

// Reports edges of one triangle and of more than two. The latter are few, if any: sheets that the simplification has
// brought together. Then their vertices move apart.
void report_edges(geometry::Geometry& mesh, Report& report, const std::string& file) {
  reconstruct::EdgeCounts edges = reconstruct::count_edges(mesh.positions, mesh.triangles);
  if (edges.non_manifold > 0) {
    part_sheets(mesh);
    edges = reconstruct::count_edges(mesh.positions, mesh.triangles);
  }
  report["boundary_edges"] = edges.boundary;
  report["boundary_length"] = edges.boundary_length;
  report["non_manifold_edges"] = edges.non_manifold;
  if (edges.non_manifold > 0) warn(fmt::format("{}: the mesh is not a manifold at {} edges", file, edges.non_manifold));
}

geometry::Geometry mesh_of(reconstruct::Reconstructed result, const std::array<double, 3>& origin) {
  geometry::Geometry mesh;
  mesh.origin = origin;
  mesh.positions = std::move(result.positions);
  mesh.normals = std::move(result.normals);
  mesh.colours = rgba_of(result.colours);
  mesh.triangles = std::move(result.triangles);
  return mesh;
}

// Clusters are quick and near to the surface, but join the two sides of parts that are thinner than they are. Then area is
// lost, and edges are collapsed instead. With an error limit, `automatic` collapses wherever the build can.
geometry::Geometry with_fewer_triangles(const geometry::Geometry& mesh, std::size_t most, unsigned threads) {
  constexpr double least_area = 0.999;
  vstree::SimplifyOptions options{.target = most, .threads = threads, .method = vstree::Method::automatic};
  geometry::Geometry fewer = simplified(mesh, options).geometry;
  if (geometry::area_of(fewer) >= least_area * geometry::area_of(mesh)) return fewer;
  options.max_error = 1;
  return simplified(mesh, options).geometry;
}

// Simplifies the mesh if it has more triangles than the command allows.
geometry::Geometry limited(geometry::Geometry mesh, const geometry::Geometry& points, const Reconstruct& command,
                           Seconds& seconds) {
  const std::size_t most =
      command.most_triangles > 0 ? command.most_triangles : triangles_a_point * points.point_count();
  if (mesh.triangle_count() <= most) return mesh;
  Progress progress("simplifying");
  progress.show(-1);
  geometry::Geometry fewer = with_fewer_triangles(mesh, most, command.options.threads);
  seconds.simplification = progress.seconds();
  if (!fewer.triangles.empty()) return fewer;
  if (command.most_triangles == 0) return mesh;
  throw geometry::Error(command.files.input +
                        ": so few triangles have no volume, and the result is empty; nothing is written; allow more by "
                        "--triangles");
}

// Whether the options ask for fewer triangles than the points need.
bool is_coarse(const Reconstruct& command, const geometry::Geometry& points) {
  return command.most_triangles > 0 && command.most_triangles < triangles_a_point * points.point_count();
}

reconstruct::Loss loss_of(const geometry::Geometry& points, const std::vector<std::uint32_t>& outliers,
                          const geometry::Geometry& mesh, const Reconstruct& command) {
  return reconstruct::loss_of({.positions = points.positions, .normals = points.normals}, outliers,
                              {mesh.positions, mesh.normals, mesh.triangles}, tolerance_of(points, command.options),
                              common::Workers(command.options.threads));
}

void run(const Reconstruct& command) {
  const std::string& file = command.files.input;
  check_output(command.files);
  geometry::Geometry points = load(file, command.files);
  warn_of_alpha(points.colours, file);
  Report report;
  report["input"] = contents_of(points);
  Seconds seconds;
  if (geometry::Geometry samples = points_on_triangles(points, file); !samples.positions.empty())
    points = std::move(samples);
  else
    add_normals(points, file, seconds);
  auto [result, outliers] = reconstruct(points, command, seconds);
  require_triangles(result, file);
  Report numbers = report_of(result);
  geometry::Geometry mesh = mesh_of(std::move(result), points.origin);
  warn_of_left_out(points, numbers, file, command.options.least_part);
  const bool coarse = is_coarse(command, points);
  reconstruct::Loss loss;
  if (coarse) loss = loss_of(points, outliers, mesh, command);
  mesh = limited(std::move(mesh), points, command, seconds);
  if (!coarse) loss = loss_of(points, outliers, mesh, command);
  report_loss(loss, numbers, command);
  report_edges(mesh, numbers, file);
  store(mesh, command.files);
  report["output"] = contents_of(mesh);
  report.update(numbers);
  if (seconds.normals > 0) report["normals_seconds"] = seconds.normals;
  report["seconds"] = seconds.reconstruction;
  if (seconds.simplification > 0) report["simplification_seconds"] = seconds.simplification;
  if (!command.reference.empty()) {
    report["topology"] = topology_report(mesh);
    report["quality"] = quality_report(mesh, command.reference, command.files);
  }
  print(report, command.files.json);
}

void describe_surface(CLI::App& command, reconstruct::ReconstructOptions& options) {
  command
      .add_option("--threshold", options.threshold,
                  "Finer detail is noise, as a part of the bounding box's diagonal; default 0: the noise is measured")
      ->check(between(0.0, 1.0));
  command
      .add_option(
          "--error", options.error,
          "Refine until the mesh is this near to the points, as a part of the diagonal; default: until it is as "
          "dense as the points")
      ->check(between(0.0, 1.0));
  command.add_option("--levels", options.levels, "Most levels of refinement, 0 to 6; default 2")
      ->check(CLI::Range(0, 6));
  command
      .add_option("--node-samples", options.node_samples,
                  fmt::format("Points of the smallest nodes, 2 to 1000: fewer find thinner parts, more close larger "
                              "gaps; default {}",
                              options.node_samples))
      ->check(between(2.0, 1000.0));
  command
      .add_option("--least-part", options.least_part,
                  "Leave out parts with less than this share of the area, 0 to 1; default 0.01")
      ->check(between(0.0, 1.0));
  command
      .add_option("--gap-edges", options.gap_edges,
                  "Close holes with at most so many edges of the coarse mesh, 0 to 1000; default 16")
      ->check(CLI::Range(0, 1000));
}

}  // namespace

void add_reconstruct(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("reconstruct", "Reconstruct a mesh from points, also from scans that overlap and are noisy");
  const auto reconstruction = std::make_shared<Reconstruct>();
  describe_input(*command, reconstruction->files);
  describe_output(*command, reconstruction->files);
  describe_measure(*command, reconstruction->reference);
  describe_surface(*command, reconstruction->options);
  command
      ->add_option("--triangles", reconstruction->most_triangles,
                   fmt::format("The most triangles of the mesh; more are simplified. Default: {} for each point; a "
                               "very large number keeps all",
                               triangles_a_point))
      ->transform(whole_above_zero());
  describe_threads(*command, reconstruction->options.threads);
  command->callback([reconstruction] { run(*reconstruction); });
}

}  // namespace glark::tool
