// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Table 6.5 of the thesis: the time of baking, and how near the displaced coarse mesh is to the scan.
#include <glark/maps.h>
#include <glark/reconstruct.h>
#include <glark/vstree.h>

#include <array>
#include <cmath>

#include "tests/bench_points/groups.h"
#include "tests/bench_points/measure/measure.h"
#include "tests/bench_points/measure/mesh_quality.h"
#include "tests/bench_points/measure/scan.h"
#include "tests/bench_points/measure/surface_distance.h"
#include "tests/maps/seen_model.h"

namespace glark::bench {
namespace {

constexpr std::size_t coarse_triangles = 20000;
constexpr double percent = 100;

struct Mesh {
  std::vector<float> positions, normals;
  std::vector<std::uint32_t> triangles;
  double noise = 0;
};

Mesh simplified(const Mesh& fine) {
  const vstree::Simplified few =
      vstree::simplify({{.positions = fine.positions, .normals = fine.normals}, fine.triangles},
                       {.target = coarse_triangles, .method = vstree::Method::automatic, .max_error = 1});
  return {few.positions, few.normals, few.triangles, fine.noise};
}

Mesh reconstructed(const Scan& scan) {
  const reconstruct::Reconstructed mesh =
      reconstruct::reconstruct({.positions = scan.positions, .normals = scan.normals}, {.least_part = 0.001F});
  return {mesh.positions, mesh.normals, mesh.triangles, static_cast<double>(mesh.noise)};
}

// Each triangle is divided into `parts` times `parts`, and its vertices are displaced.
Mesh displaced(const maps::Baked& model, std::size_t parts) {
  const maps::test::SeenModel seen(model);
  Mesh mesh;
  for (std::size_t t = 0; t < model.triangles.size() / 3; ++t) {
    std::vector<std::uint32_t> row_begins;
    for (std::size_t i = 0; i <= parts; ++i) {
      row_begins.push_back(static_cast<std::uint32_t>(mesh.positions.size() / 3));
      for (std::size_t j = 0; j <= i; ++j) {
        const auto whole = static_cast<double>(parts);
        const double second = static_cast<double>(j) / whole;
        const double top = 1 - static_cast<double>(i) / whole;
        const maps::test::Seen at = seen.at(t, {top, 1 - top - second, second});
        for (std::size_t k = 0; k < 3; ++k) mesh.positions.push_back(static_cast<float>(at.position[k]));
      }
    }
    for (std::uint32_t i = 0; i < parts; ++i) {
      for (std::uint32_t j = 0; j <= i; ++j) {
        const std::uint32_t a = row_begins[i] + j, b = row_begins[i + 1] + j;
        mesh.triangles.insert(mesh.triangles.end(), {a, b, b + 1});
        if (j < i) mesh.triangles.insert(mesh.triangles.end(), {a, b + 1, a + 1});
      }
    }
  }
  return mesh;
}

double rms_percent(const Mesh& mesh, std::span<const float> samples, double diagonal) {
  return percent * SurfaceDistance(mesh.positions, mesh.triangles).rms(samples) / diagonal;
}

struct Case {
  std::string name;
  bool is_mesh;
};

std::vector<Cell> row_of(const Case& given, const Settings& settings) {
  constexpr std::size_t sample_count = 100000;
  constexpr std::size_t parts = 8;
  const Scan scan = read_scan(settings.data, given.name);
  const Mesh fine = given.is_mesh ? Mesh{scan.positions, scan.normals, scan.triangles} : reconstructed(scan);
  const Mesh coarse = simplified(fine);
  const double spacing = diagonal_of(scan.positions) / 1500;
  const stream::Source source =
      given.is_mesh ? maps::mesh_source(
                          {.positions = scan.positions, .normals = scan.normals, .triangles = scan.triangles}, spacing)
                    : maps::mesh_source({.positions = scan.positions, .normals = scan.normals}, 1);
  maps::Baked model;
  std::vector<Work> works{
      {"bake", [&] {
         model = maps::bake({.positions = coarse.positions, .normals = coarse.normals, .triangles = coarse.triangles},
                            source, {.noise = coarse.noise, .threads = 1});
       }}};
  take_turns(works, std::min(settings.rounds, 3));
  const std::vector<float> samples =
      given.is_mesh ? samples_of(scan.positions, scan.triangles, sample_count) : scan.positions;
  const double diagonal = diagonal_of(scan.positions);
  const auto points = static_cast<double>(model.points);
  return {given.name,
          Number{points, 0},
          Number{works[0].cpu_seconds, 2},
          Number{points / works[0].cpu_seconds / 1e6, 2},
          Number{static_cast<double>(model.texels) / 1e6, 2},
          Number{works[0].peak_bytes.value_or(0) / 1e6, 0},
          Number{static_cast<double>(model.charts), 0},
          Number{rms_percent(coarse, samples, diagonal), 4},
          Number{rms_percent(displaced(model, parts), samples, diagonal), 4},
          given.is_mesh ? Cell{} : Cell{Number{rms_percent(fine, samples, diagonal), 4}},
          Number{255 * static_cast<double>(model.seams.colour.greatest), 2},
          Number{static_cast<double>(model.seams.normal.root_mean_square), 2}};
}

}  // namespace

std::vector<Table> map_tables(const Settings& settings) {
  Table table{"Appearance maps of 20 000 triangles, on one core",
              {"", "points", "CPU s", "M points/s", "M texels", "peak MB", "charts", "coarse mesh: RMS %",
               "displaced: RMS %", "reconstruction: RMS %", "seams: colour of 255", "seams: normals, RMS degrees"},
              {}};
  for (const Case& given :
       {Case{"igea", true}, Case{"horse", true}, Case{"armadillo", true}, Case{"bunny_scans", false},
        Case{"dragon_stand_scans", false}, Case{"happy_stand_scans", false}})
    table.rows.push_back(row_of(given, settings));
  table.note =
      "The whole of bake(): charts, both passes over the points, diffusion, seams, maps. RMS is the distance of "
      "samples of "
      "the mesh, or of all points of raw scans, from the surface, relative to the diagonal. Table 6.5 of the thesis "
      "has 250 M "
      "points in 890 s for filling and 170 s for diffusion (0.28 and 1.5 M points/s).";
  return {table};
}

}  // namespace glark::bench
