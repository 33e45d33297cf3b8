// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/simplify/simplify_command.h"

#include <fmt/format.h>

#include <utility>

#include "glark/clients/geometry/measure/area.h"
#include "glark/clients/geometry/measure/topology.h"
#include "glark/tool/scan/parts/memory_option.h"
#include "glark/tool/scan/peak_memory.h"
#include "glark/tool/scan/quality.h"
#include "glark/tool/scan/rgb.h"
#include "glark/tool/scan/simplified.h"
#include "glark/tool/scan/simplify/connections.h"
#include "glark/tool/scan/simplify/within_error.h"
#include "glark/tool/scan/validators.h"

namespace glark::tool {
namespace {

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

// Warns about attributes that the result does not have, and about a target that is not reached.
void warn_of_losses(const geometry::Geometry& geometry, const Coarse& coarse, const SimplifyCommand& command) {
  const std::string& file = command.files.input;
  const std::size_t seams = coarse.method == vstree::Method::cluster ? seam_points(geometry) : 0;
  if (seams > 0) {
    warn(fmt::format(
        "{}: its texture coordinates have seams at {} points; the result keeps one side of a seam, so that triangles "
        "there show a wrong part of the texture: use --method collapse, or bake the texture into colours first",
        file, seams));
  }
  warn_of_alpha(geometry.colours, file);
  const std::size_t target = command.options.target, count = coarse.geometry.triangle_count();
  const bool was_stopped = coarse.measured.has_value();
  if (coarse.method == vstree::Method::collapse && target > 0 && count > target && !was_stopped)
    warn(fmt::format(
        "{}: no further edge can collapse; {} triangles are left, more than --target {}; --fast gives fewer", file,
        count, target));
  if (was_stopped && count == geometry.triangle_count())
    warn(fmt::format("{}: no collapse of edges stays within --max-error; the result is the whole input", file));
}

// Warns if much fewer triangles are left than the target allows, and no --max-error explains why.
void warn_of_few(const geometry::Geometry& geometry, const Coarse& coarse, const SimplifyCommand& command) {
  const std::size_t target = command.options.target, count = coarse.geometry.triangle_count();
  if (geometry.triangles.empty() || count == 0 || 10 * count >= 9 * target) return;
  warn(fmt::format("{}: {} triangle{} left, far fewer than --target {}: {}", command.files.input, count,
                   count == 1 ? " is" : "s are", target,
                   coarse.method == vstree::Method::cluster
                       ? "sheets that are nearer to each other than the clusters are wide cancel out or become one; "
                         "use --method collapse"
                       : "with so few, sheets of the surface meet, and triangles that cover each other are removed; "
                         "allow more by --target"));
}

// Returns whether the input has no more triangles, or points without triangles, than the target allows.
bool is_within_target(const geometry::Geometry& geometry, std::size_t target) {
  return target > 0 && target >= (geometry.triangles.empty() ? geometry.point_count() : geometry.triangle_count());
}

// Returns a target for which triangles are left, at most twice the least one; 0 if a few tries find none.
std::size_t target_that_works(const geometry::Geometry& geometry, vstree::SimplifyOptions options) {
  constexpr int most_tries = 12;
  for (int i = 0; i < most_tries; ++i) {
    options.target *= 2;
    if (options.target >= geometry.triangle_count()) return 0;
    if (!simplified(geometry, options).geometry.triangles.empty()) return options.target;
  }
  return 0;
}

// Throws if nothing is left, so that an empty mesh replaces no file.
void require_contents(const Coarse& result, const geometry::Geometry& geometry, const SimplifyCommand& command) {
  const geometry::Geometry& coarse = result.geometry;
  const bool lost_triangles = coarse.triangles.empty() && !geometry.triangles.empty();
  if (coarse.point_count() > 0 && !lost_triangles) return;
  const std::size_t target = command.options.target;
  const bool is_flat = geometry::area_of(geometry) == 0;
  std::string cause = "all its triangles are so flat or small that they vanish";
  std::string remedy = target > 0 ? "allow more by --target" : "keep some by --target, or allow less by --error";
  if (const std::size_t works = target > 0 && !is_flat ? target_that_works(geometry, command.options) : 0; works > 0) {
    cause = fmt::format("--target {} is too small for its shape", target);
    remedy = fmt::format("--target {} works", works);
  } else if (target > 0 && !is_flat && result.method == vstree::Method::cluster) {
    cause =
        "its sheets lie on each other, or so near that their triangles face each other in the same clusters and cancel";
    remedy = "use --method collapse";
  }
  throw geometry::Error(command.files.input + ": " + cause + ", and the result is empty; nothing is written; " +
                        remedy);
}

Coarse coarse_of(const SimplifyInput& input, const SimplifyCommand& command, double& seconds) {
  const geometry::Geometry& geometry = input.geometry;
  if (is_within_target(geometry, command.options.target)) {
    if (input.is_whole)
      warn(fmt::format("{}: it has no more {} than --target allows; the result is the whole input", command.files.input,
                       geometry.triangles.empty() ? "points" : "triangles"));
    return {geometry, input.is_whole ? vstree::Method::collapse : vstree::Method::cluster, 0, {}};
  }
  Coarse coarse{};
  {
    Progress progress("simplifying");
    progress.show(-1);
    const vstree::SimplifyOptions& options = command.options;
    const bool is_bound = options.max_error > 0 && options.method != vstree::Method::cluster;
    coarse = is_bound && !geometry.triangles.empty() ? simplified_within_error(geometry, options)
                                                     : simplified(geometry, options);
    seconds = progress.seconds();
  }
  warn_of_losses(geometry, coarse, command);
  warn_of_few(geometry, coarse, command);
  return coarse;
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

// Adds the options that choose the method. Without them, small meshes collapse, unless an option is about clusters.
void describe_method(CLI::App& command, SimplifyCommand& simplification) {
  vstree::SimplifyOptions& options = simplification.options;
  CLI::Option* const method =
      command
          .add_option("--method", options.method,
                      "cluster (fast) or collapse (collapse edges: nearer to the surface); default: collapse below "
                      "200000 triangles if there is a --target or --max-error")
          ->transform(one_of<vstree::Method>({{"cluster", vstree::Method::cluster},
                                              {"collapse", vstree::Method::collapse},
                                              {"automatic", vstree::Method::automatic}}))
          ->type_name("NAME");
  command.add_flag("--fast", simplification.is_fast, "The same as --method cluster")->excludes(method);
  command
      .add_option("--max-error", options.max_error,
                  "Collapse: the greatest distance between the result and the input, as a part of the bounding box's "
                  "diagonal; measured; default: no limit")
      ->check(above_zero())
      ->excludes("--fast")
      ->excludes("--error");
}

}  // namespace

SimplifyInput read_whole(const SimplifyCommand& command) {
  geometry::Geometry geometry = load(command.files.input, command.files);
  Report contents = contents_of(geometry);
  return {std::move(geometry), std::move(contents)};
}

Report simplify(const SimplifyCommand& command, const SimplifyInput& input, const Progress& reading) {
  double seconds = 0;
  const Coarse simplification = coarse_of(input, command, seconds);
  const geometry::Geometry& coarse = simplification.geometry;
  require_contents(simplification, input.geometry, command);
  store(coarse, command.files);
  Report report;
  report["input"] = input.contents;
  report["output"] = contents_of(coarse);
  const bool is_collapsed = simplification.method == vstree::Method::collapse;
  report["method"] = is_collapsed ? "collapse" : "cluster";
  if (simplification.measured)
    report["measured_error_percent"] = 100 * *simplification.measured;
  else if (is_collapsed)
    report["estimated_error_percent"] = 100 * static_cast<double>(simplification.error);
  report["seconds"] = input.is_whole ? seconds : reading.seconds();  // with the sampling
  if (input.is_whole && !input.geometry.triangles.empty())
    report.update(connections_report(input.geometry, coarse, command.files.output));
  if (!input.is_whole) report["peak_memory_bytes"] = peak_memory();
  if (!command.reference.empty()) {
    report["topology"] = topology_report(coarse);
    report["quality"] = quality_report(coarse, command.reference, command.files);
  }
  return report;
}

void describe(CLI::App& command, SimplifyCommand& simplification) {
  vstree::SimplifyOptions& options = simplification.options;
  describe_input(command, simplification.files, {"las", "raw"});
  describe_output(command, simplification.files);
  CLI::Option* target = command
                            .add_option("--target", options.target,
                                        "The most triangles of the result, or points if there are no triangles. The "
                                        "result is the whole input if this has no more")
                            ->transform(whole_above_zero());
  command
      .add_option("--error", options.threshold,
                  "Without a target: the error of a cluster, for l2 and qef relative to the bounding box's diagonal; "
                  "default 1e-4")
      ->check(above_zero())
      ->excludes(target);
  describe_method(command, simplification);
  describe_clusters(command, options);
  describe_threads(command, options.threads);
  describe_memory(command, simplification.memory);
}

void set_method(const CLI::App& command, SimplifyCommand& simplification) {
  const auto is_given = [&](const char* name) { return command.get_option(name)->count() > 0; };
  if (is_given("--method")) return;
  const bool is_about_clusters = is_given("--clustering") || is_given("--metric") || is_given("--representative");
  simplification.options.method =
      simplification.is_fast || is_about_clusters ? vstree::Method::cluster : vstree::Method::automatic;
}

}  // namespace glark::tool
