// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Simplifies generated meshes to a tenth of their triangles: machine parts, smooth ones, open sheets, touching parts.
#include <glark/vstree.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <string>

#include "tests/bench_points/groups.h"
#include "tests/bench_points/measure/measure.h"
#include "tests/bench_points/measure/mesh_quality.h"
#include "tests/shapes/parts.h"

namespace glark::bench {
namespace {

using shapes::Part;

struct Kind {
  const char* name;
  vstree::Method method;
};
constexpr Kind kinds[] = {{"cluster", vstree::Method::cluster}, {"collapse", vstree::Method::collapse}};

void add_rows(const std::string& name, const Part& part, int rounds, Table& table) {
  constexpr std::size_t samples = 50000;
  const std::size_t target = part.triangle_count() / 10, points = part.positions.size() / 3;
  std::vector<std::uint32_t> peer;
  std::vector<vstree::Simplified> ours(std::size(kinds));
  std::vector<Work> works{{name + ", meshoptimizer simplify", [&] {
                             peer.resize(part.triangles.size());
                             peer.resize(meshopt_simplify(peer.data(), part.triangles.data(), part.triangles.size(),
                                                          part.positions.data(), points, 12, 3 * target, 1, 0,
                                                          nullptr));
                           }}};
  for (std::size_t i = 0; i < std::size(kinds); ++i) {
    works.push_back({std::string(kinds[i].name), [&, i] {
                       ours[i] = vstree::simplify({{.positions = part.positions}, part.triangles},
                                                  {.target = target, .threads = 1, .method = kinds[i].method});
                     }});
  }
  take_turns(works, rounds);
  const MeshView original{part.positions, part.triangles};
  const std::size_t before = non_manifold_by_position(original);
  for (std::size_t i = 0; i < works.size(); ++i) {
    const MeshView result =
        i == 0 ? MeshView{part.positions, peer} : MeshView{ours[i - 1].positions, ours[i - 1].triangles};
    const MeshDistances distances = distances_between(original, result, samples);
    const std::size_t after = non_manifold_by_position(result);
    table.rows.push_back({works[i].name, Number{works[i].cpu_seconds, 4},
                          Number{works[i].cpu_seconds / works[0].cpu_seconds, 2},
                          Number{static_cast<double>(result.triangles.size()) / 3, 0}, Number{distances.rms, 4},
                          Number{distances.greatest, 3}, Number{distances.borders, 3},
                          Number{static_cast<double>(after > before ? after - before : 0), 0}});
  }
}

}  // namespace

std::vector<Table> generated_mesh_tables(const Settings& settings) {
  const int rounds = std::min(settings.rounds, 3);
  const std::vector<std::string> columns{"",
                                         "CPU s",
                                         "of the peer's",
                                         "triangles",
                                         "RMS, % of the diagonal",
                                         "greatest",
                                         "borders",
                                         "more edges of three triangles"};
  Table machine{"Machine parts to a tenth, all positions", columns, {}};
  for (const unsigned seed : {1U, 2U}) {
    for (const shapes::NamedPart& part : shapes::machine_parts)
      add_rows(std::string(part.name) + " " + std::to_string(seed), part.make(seed, 3), rounds, machine);
  }
  Table others{"Smooth, open and touching parts to a tenth", columns, {}};
  for (const unsigned seed : {1U, 2U}) {
    add_rows("blob " + std::to_string(seed), shapes::blob(seed, 3), rounds, others);
    add_rows("cover " + std::to_string(seed), shapes::cover(seed, 2), rounds, others);
    add_rows("assembly " + std::to_string(seed), shapes::assembly(seed, 2), rounds, others);
  }
  return {machine, others};
}

}  // namespace glark::bench
