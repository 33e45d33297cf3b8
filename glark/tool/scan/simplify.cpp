// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark simplify FILE -o OUT: reduces the number of triangles, or of points if there are no triangles.
#include <fmt/format.h>

#include <glark/vstree.h>

#include <memory>

#include "glark/clients/geometry/measure/topology.h"
#include "glark/tool/scan/commands.h"
#include "glark/tool/scan/files.h"
#include "glark/tool/scan/quality.h"
#include "glark/tool/scan/rgb.h"
#include "glark/tool/scan/simplified.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {
namespace {

struct Simplify {
  Files files;
  std::string reference;
  vstree::SimplifyOptions options;
};

// Counts the places where triangles meet with different texture coordinates.
std::size_t seam_points(const geometry::Geometry& geometry) {
  const std::vector<float>& all = geometry.texture_coordinates;
  if (all.empty() || geometry.triangles.empty()) return 0;
  const std::vector<std::uint32_t> first = geometry::first_at_same_place(geometry.positions);
  std::size_t count = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::size_t other = first[i];
    count += all[2 * i] != all[2 * other] || all[2 * i + 1] != all[2 * other + 1] ? 1 : 0;
  }
  return count;
}

// Warns about attributes that the result does not have.
void warn_of_losses(const geometry::Geometry& geometry, const std::string& file) {
  if (const std::size_t seams = seam_points(geometry); seams > 0) {
    warn(fmt::format(
        "{}: its texture coordinates have seams at {} points; the result keeps one side of a seam, so that triangles "
        "there show a wrong part of the texture: remove the texture, or bake it into colours first",
        file, seams));
  }
  warn_of_alpha(geometry.colours, file);
}

// Returns whether the input has no more triangles, or points without triangles, than the target allows.
bool is_within_target(const geometry::Geometry& geometry, std::size_t target) {
  return target > 0 && target >= (geometry.triangles.empty() ? geometry.point_count() : geometry.triangle_count());
}

// Throws if nothing is left, so that an empty mesh replaces no file.
void require_contents(const geometry::Geometry& coarse, const geometry::Geometry& geometry, const Simplify& command) {
  const bool lost_triangles = coarse.triangles.empty() && !geometry.triangles.empty();
  if (coarse.point_count() > 0 && !lost_triangles) return;
  throw geometry::Error(
      command.files.input +
      ": all its triangles are so flat or small that they vanish, and the result is empty; nothing is written; " +
      (command.options.target > 0 ? "allow more by --target" : "keep some by --target, or allow less by --error"));
}

geometry::Geometry coarse_of(const geometry::Geometry& geometry, const Simplify& command, double& seconds) {
  if (is_within_target(geometry, command.options.target)) {
    warn(fmt::format("{}: it has no more {} than --target allows; the result is the whole input", command.files.input,
                     geometry.triangles.empty() ? "points" : "triangles"));
    return geometry;
  }
  warn_of_losses(geometry, command.files.input);
  Progress progress("simplifying");
  progress.show(-1);
  geometry::Geometry coarse = simplified(geometry, command.options);
  seconds = progress.seconds();
  return coarse;
}

void simplify(const Simplify& command) {
  check_output(command.files);
  const geometry::Geometry geometry = load(command.files.input, command.files);
  double seconds = 0;
  const geometry::Geometry coarse = coarse_of(geometry, command, seconds);
  require_contents(coarse, geometry, command);
  store(coarse, command.files);
  Report report;
  report["input"] = contents_of(geometry);
  report["output"] = contents_of(coarse);
  report["seconds"] = seconds;
  if (!command.reference.empty()) {
    report["topology"] = topology_report(coarse);
    report["quality"] = quality_report(coarse, command.reference, command.files);
  }
  print(report, command.files.json);
}

// Adds the options that choose clusters and the points that replace them.
void describe_clusters(CLI::App& command, vstree::SimplifyOptions& options) {
  using vstree::Clustering;
  using vstree::Metric;
  using vstree::Representative;
  command
      .add_option("--clustering", options.clustering,
                  "Cells that make the clusters: vstree, octree or grid; default vstree")
      ->transform(one_of<Clustering>(
          {{"vstree", Clustering::volume_surface}, {"octree", Clustering::octree}, {"grid", Clustering::grid}}))
      ->type_name("KIND");
  command
      .add_option("--metric", options.metric,
                  "Error of a cluster: l2, l21 (normals), qef or density (samples); default l2")
      ->transform(one_of<Metric>(
          {{"l2", Metric::l2}, {"l21", Metric::l21}, {"qef", Metric::qef}, {"density", Metric::density}}))
      ->type_name("METRIC");
  command
      .add_option("--representative", options.representative,
                  "Position of the point of a cluster: qef or centroid; default qef")
      ->transform(one_of<Representative>({{"qef", Representative::qef}, {"centroid", Representative::centroid}}))
      ->type_name("KIND");
}

}  // namespace

void add_simplify(CLI::App& app) {
  CLI::App* command = app.add_subcommand("simplify", "Reduce triangles, or points if there are no triangles");
  const auto simplification = std::make_shared<Simplify>();
  vstree::SimplifyOptions& options = simplification->options;
  describe_input(*command, simplification->files);
  describe_output(*command, simplification->files);
  describe_measure(*command, simplification->reference);
  CLI::Option* target = command
                            ->add_option("--target", options.target,
                                         "The most triangles of the result, or points if there are no triangles. The "
                                         "result is the whole input if this has no more")
                            ->transform(whole_above_zero());
  command
      ->add_option("--error", options.threshold,
                   "Without a target: the error of a cluster, for l2 and qef relative to the bounding box's diagonal; "
                   "default 1e-4")
      ->check(above_zero())
      ->excludes(target);
  describe_clusters(*command, options);
  describe_threads(*command, options.threads);
  command->callback([simplification] { simplify(*simplification); });
}

}  // namespace glark::tool
