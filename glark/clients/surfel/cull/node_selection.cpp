// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/cull/node_selection.h"

#include <cstdint>
#include <vector>

namespace glark::surfel {
namespace {

constexpr unsigned all_planes = 0x3F;

Vector centre_of(const Node& node) { return (to_vector(node.low) + to_vector(node.high)) * 0.5F; }
float radius_of(const Node& node) { return length(to_vector(node.high) - to_vector(node.low)) * 0.5F; }

}  // namespace

void select_nodes(std::span<const Node> nodes, const View& view, const Camera& camera, const AddPoints& add_points,
                  Frame& frame) {
  struct Visit {
    std::uint32_t node;
    unsigned planes;
  };
  thread_local std::vector<Visit> stack;
  stack.assign(1, {0, view.cull_frustum ? all_planes : 0});
  while (!stack.empty()) {
    Visit visit = stack.back();
    stack.pop_back();
    const Node& node = nodes[visit.node];
    if (node.low[0] > node.high[0]) continue;
    ++frame.visited;
    if (visit.planes != 0 && camera.is_outside(node, visit.planes)) {
      ++frame.out_of_frustum;
    } else if (view.cull_back_faces && camera.is_back_facing(node)) {
      ++frame.back_faces;
    } else if (view.point_pixels > 0 &&
               camera.projected_diameter(centre_of(node), radius_of(node)) <= view.point_pixels) {
      frame.points.push_back(node.representative);
    } else if (node.left != none) {
      stack.push_back({node.right, visit.planes});
      stack.push_back({node.left, visit.planes});
    } else if (node.count == 0) {
      add_points(visit.node, frame.points);
    } else {
      frame.counts.push_back(static_cast<std::int32_t>(node.count));
      frame.offsets.push_back(reinterpret_cast<const void*>(std::uintptr_t{node.first} * sizeof(std::uint32_t)));
      frame.indices += node.count;
      ++frame.strips;
    }
  }
}

}  // namespace glark::surfel
