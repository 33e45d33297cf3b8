// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark reconstruct FILE -o OUT: reconstructs a mesh from points.
#include <fmt/format.h>
#include <glark/reconstruct.h>

#include <array>
#include <memory>
#include <utility>

#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/quality.h"
#include "glark/tool/scan/rgb.h"

namespace glark::tool {
namespace {

struct Reconstruct {
  Files files;
  std::string reference;
  reconstruct::ReconstructOptions options;
};

struct Seconds {
  double normals = 0;
  double reconstruction = 0;
};

reconstruct::Reconstructed reconstruct(geometry::Geometry& points, const Reconstruct& command, Seconds& seconds) {
  if (points.normals.empty()) {
    warn(command.files.input + ": it has no normals; they are estimated, and their orientation is guessed");
    Progress progress("estimating normals");
    progress.show(-1);
    points.normals = vstree::estimate_normals({.positions = points.positions});
    seconds.normals = progress.seconds();
  }
  Progress progress("reconstructing");
  progress.show(-1);
  const std::vector<std::uint8_t> colours = rgb_of(points.colours);
  reconstruct::Reconstructed result = reconstruct::reconstruct(
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
  return report;
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

void run(const Reconstruct& command) {
  check_output(command.files);
  geometry::Geometry points = load(command.files.input, command.files);
  warn_of_alpha(points.colours, command.files.input);
  Seconds seconds;
  reconstruct::Reconstructed result = reconstruct(points, command, seconds);
  if (result.triangles.empty())
    warn(command.files.input +
         ": the mesh is empty, for its points are on no surface. A point far away from all others makes the box too "
         "large; remove such points");
  const Report numbers = report_of(result);
  const geometry::Geometry mesh = mesh_of(std::move(result), points.origin);
  store(mesh, command.files);
  Report report;
  report["input"] = contents_of(points);
  report["output"] = contents_of(mesh);
  report.update(numbers);
  if (seconds.normals > 0) report["normals_seconds"] = seconds.normals;
  report["seconds"] = seconds.reconstruction;
  if (!command.reference.empty()) {
    report["topology"] = topology_report(mesh);
    report["quality"] = quality_report(mesh, command.reference, command.files);
  }
  print(report, command.files.json);
}

}  // namespace

void add_reconstruct(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("reconstruct", "Reconstruct a mesh from points, also from scans that overlap and are noisy");
  const auto reconstruction = std::make_shared<Reconstruct>();
  reconstruct::ReconstructOptions& options = reconstruction->options;
  describe_input(*command, reconstruction->files);
  describe_output(*command, reconstruction->files);
  describe_measure(*command, reconstruction->reference);
  command
      ->add_option("--threshold", options.threshold,
                   "Finer detail is noise, as a part of the bounding box's diagonal; default 0: the noise is measured")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option(
          "--error", options.error,
          "Refine until the mesh is this near to the points, as a part of the diagonal; default: until it is as "
          "dense as the points")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--levels", options.levels, "Most levels of refinement, 0 to 6; default 2")
      ->check(CLI::Range(0, 6));
  command
      ->add_option("--node-samples", options.node_samples,
                   fmt::format("Points of the smallest nodes, 2 to 1000: fewer find thinner parts, more close larger "
                               "gaps; default {}",
                               options.node_samples))
      ->check(CLI::Range(2.0, 1000.0));
  command
      ->add_option("--least-part", options.least_part,
                   "Leave out parts with less than this share of the area, 0 to 1; default 0.01")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--gap-edges", options.gap_edges,
                   "Close holes with at most so many edges of the coarse mesh, 0 to 1000; default 16")
      ->check(CLI::Range(0, 1000));
  describe_threads(*command, options.threads);
  command->callback([reconstruction] { run(*reconstruction); });
}

}  // namespace glark::tool
