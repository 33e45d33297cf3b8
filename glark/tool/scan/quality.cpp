// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/quality.h"

#include "glark/clients/geometry/measure/distance.h"
#include "glark/clients/geometry/measure/topology.h"

namespace glark::tool {

Report topology_report(const geometry::Geometry& geometry) {
  const geometry::Topology topology = geometry::topology_of(geometry);
  Report report;
  report["points_at_places_of_others"] = geometry.point_count() - topology.places;
  if (geometry.triangles.empty()) return report;
  report["points_without_triangles"] = topology.unused_points;
  report["degenerate_triangles"] = topology.degenerate_triangles;
  report["boundary_edges"] = topology.boundary_edges;
  report["non_manifold_edges"] = topology.non_manifold_edges;
  report["components"] = topology.components;
  report["triangles_of_the_largest"] = topology.largest_component;
  report["closed"] = topology.components > 0 && topology.boundary_edges == 0 && topology.non_manifold_edges == 0;
  return report;
}

void describe_measure(CLI::App& command, std::string& reference) {
  command.add_option("--measure", reference, "Compare with this file: Hausdorff and RMS distance, normals, edges")
      ->type_name("REFERENCE");
}

Report quality_report(const geometry::Geometry& result, const std::string& reference, const Files& files) {
  const geometry::Geometry other = load(reference, files);
  geometry::Distance distance;
  {
    Progress progress("measuring");
    distance = geometry::distance_between(result, other, [&](double fraction) { progress.show(fraction); });
  }
  const double percent = distance.diagonal > 0 ? 100 / distance.diagonal : 0;
  Report report;
  report["reference"] = reference;
  report["diagonal"] = distance.diagonal;
  report["hausdorff_percent"] = percent * distance.hausdorff();
  report["rms_percent"] = percent * distance.rms();
  report["rms_percent_to_reference"] = percent * distance.there.rms;
  report["rms_percent_from_reference"] = percent * distance.back.rms;
  if (distance.there.has_normals) report["normals_rms_degrees"] = distance.there.normal_rms_degrees;
  return report;
}

}  // namespace glark::tool
