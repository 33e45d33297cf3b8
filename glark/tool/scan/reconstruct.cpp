// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark reconstruct FILE -o OUT: a mesh from points.
#include <glark/reconstruct.h>

#include <memory>

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

void reconstruct(const Reconstruct& command) {
  check_output(command.files);
  geometry::Geometry points = load(command.files.input, command.files);
  warn_of_alpha(points.colours, command.files.input);
  geometry::Geometry mesh;
  reconstruct::Reconstructed result;
  double normals_seconds = 0;
  double seconds = 0;
  if (points.normals.empty()) {
    warn(command.files.input + ": it has no normals; they are estimated, and their sides guessed");
    Progress progress("estimating normals");
    progress.show(-1);
    points.normals = vstree::estimate_normals({.positions = points.positions});
    normals_seconds = progress.seconds();
  }
  {
    Progress progress("reconstructing");
    progress.show(-1);
    const std::vector<std::uint8_t> colours = rgb_of(points.colours);
    result = reconstruct::reconstruct({.positions = points.positions, .normals = points.normals, .colours = colours},
                                 command.options);
    seconds = progress.seconds();
  }
  if (result.triangles.empty())
    warn(command.files.input +
         ": its points are on no surface; the mesh is empty. A point far away from all others makes the box too large: "
         "take it out");
  mesh.origin = points.origin;
  mesh.positions = std::move(result.positions);
  mesh.normals = std::move(result.normals);
  mesh.colours = rgba_of(result.colours);
  mesh.triangles = std::move(result.triangles);
  store(mesh, command.files);
  Report report;
  report["input"] = contents_of(points);
  report["output"] = contents_of(mesh);
  report["base_vertices"] = result.base_vertices;
  report["base_triangles"] = result.base_triangles;
  report["levels"] = result.levels;
  report["node_side"] = result.node_side;
  report["noise"] = result.noise;
  report["parts_left_out"] = result.left_out;
  if (normals_seconds > 0) report["normals_seconds"] = normals_seconds;
  report["seconds"] = seconds;
  if (!command.reference.empty()) {
    report["topology"] = topology_report(mesh);
    report["quality"] = quality_report(mesh, command.reference, command.files);
  }
  print(report, command.files.json);
}

}  // namespace

void add_reconstruct(CLI::App& app) {
  CLI::App* command = app.add_subcommand("reconstruct", "A mesh from points, of scans that overlap and are noisy too");
  const auto reconstruction = std::make_shared<Reconstruct>();
  reconstruct::ReconstructOptions& options = reconstruction->options;
  describe_input(*command, reconstruction->files);
  describe_output(*command, reconstruction->files);
  describe_measure(*command, reconstruction->reference);
  command
      ->add_option("--threshold", options.threshold,
                   "What is finer than this part of the bounding box's diagonal is noise; 0, which is what the points "
                   "show themselves, if not given")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--error", options.error,
                   "Refine until the mesh is so near to the points, as a part of the diagonal; as dense as they are if "
                   "not given")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--levels", options.levels, "Refine so often at most, 0 to 6; 2 if not given")
      ->check(CLI::Range(0, 6));
  command
      ->add_option("--node-samples", options.node_samples,
                   "Points of the smallest nodes, 2 to 1000: fewer find thinner parts, more close larger gaps; " +
                       CLI::detail::to_string(options.node_samples) + " if not given")
      ->check(CLI::Range(2.0, 1000.0));
  command
      ->add_option("--least-part", options.least_part,
                   "Leave out parts with less than this of the area, 0 to 1; 0.01 if not given")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--gap-edges", options.gap_edges,
                   "Close holes with so many edges of the coarse mesh around, 0 to 1000; 16 if not given")
      ->check(CLI::Range(0, 1000));
  describe_threads(*command, options.threads);
  command->callback([reconstruction] { reconstruct(*reconstruction); });
}

}  // namespace glark::tool
