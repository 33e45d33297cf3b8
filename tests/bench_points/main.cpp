// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark-bench-points: trees over points and simplification, side by side with what others do. docs/points.md has the figures.
//   glark-bench-points [--data FOLDER] [--samples N] [--rounds N]
#include <glark/vstree.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <nanoflann.hpp>
#include <string>

#include "tests/bench_points/scan.h"
#include "tests/bench_points/surface_distance.h"

namespace glark::bench {
namespace {

struct Settings {
  std::string data = GLARK_SCANS;
  std::size_t samples = 5000000;
  int rounds = 9;
};

double cpu_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Work {
  std::string name;
  std::function<void()> run;
  double least = 1e300;
};

// In turns, so that what else the machine does strikes all alike; the least CPU time of each.
void take_turns(std::vector<Work>& works, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    for (Work& work : works) {
      const double begin = cpu_seconds();
      work.run();
      work.least = std::min(work.least, cpu_seconds() - begin);
    }
  }
}

struct Cloud {
  const std::vector<float>& positions;
  std::size_t kdtree_get_point_count() const { return positions.size() / 3; }
  float kdtree_get_pt(std::size_t i, std::size_t k) const { return positions[3 * i + k]; }
  template <typename Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

void bench_build(const Settings& settings) {
  const Scan scan = sampled(read_scan(settings.data, "igea"), settings.samples);
  const vstree::PointSet points{.positions = scan.positions, .normals = scan.normals};
  std::printf("\n## Partition of %zu samples of igea, error L2 1e-4\n", settings.samples);
  std::printf(
      "| | CPU s | of the kd-tree's | leaves | of the octree's | bytes a sample |\n|---|---|---|---|---|---|\n");
  std::size_t leaves[4] = {}, bytes[4] = {};
  const auto build = [&](int i, bool surface, float delta_d) {
    const vstree::Tree tree(points, {.surface = surface, .delta_d = delta_d, .threads = 1});
    leaves[i] = tree.leaf_count();
    bytes[i] = tree.bytes();
  };
  using Index =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t>;
  const Cloud cloud{scan.positions};
  std::vector<Work> works;
  works.push_back({"volume-surface tree", [&] { build(0, true, 0.25F); }});
  works.push_back({"the same, delta_d 1/6 as in the thesis", [&] { build(1, true, 1.0F / 6); }});
  works.push_back({"octree of ours", [&] { build(2, false, 0.25F); }});
  works.push_back({"kd-tree of nanoflann, 64 a leaf", [&] {
                     Index index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(64));
                     index.buildIndex();
                   }});
  take_turns(works, std::max(2, settings.rounds / 3));
  for (std::size_t i = 0; i < works.size(); ++i) {
    std::printf("| %s | %.3f | %.2f ", works[i].name.c_str(), works[i].least, works[i].least / works.back().least);
    if (leaves[i] == 0) {
      std::printf("| | | |\n");
    } else {
      std::printf("| %zu | %.2f | %.1f |\n", leaves[i], static_cast<double>(leaves[i]) / static_cast<double>(leaves[2]),
                  static_cast<double>(bytes[i]) / static_cast<double>(settings.samples));
    }
  }
}

struct Result {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
};

void print(const Work& work, const Result& result, const Scan& scan, const std::vector<float>& samples, double sloppy) {
  const double diagonal = diagonal_of(scan.positions);
  const double there = SurfaceDistance(result.positions, result.triangles).rms(samples) / diagonal * 100;
  const double back = SurfaceDistance(scan.positions, scan.triangles)
                          .rms(samples_of(result.positions, result.triangles, samples.size() / 3)) /
                      diagonal * 100;
  const Edges edges = edges_of(result.triangles);
  std::printf("| %s | %zu | %.4f | %.2f | %.4f | %.4f | %zu | %zu |\n", work.name.c_str(), result.triangles.size() / 3,
              work.least, work.least / sloppy, there, back, edges.non_manifold, edges.boundary);
}

void bench_simplify(const Settings& settings, const std::string& name, std::size_t target) {
  const Scan scan = read_scan(settings.data, name);
  const std::size_t points = scan.positions.size() / 3;
  std::printf("\n## %s, %zu triangles, to %zu\n", name.c_str(), scan.triangles.size() / 3, target);
  std::printf(
      "| | triangles | CPU s | of sloppy's | RMS from the original, %% of the diagonal | RMS to it | non-manifold "
      "edges | "
      "boundary edges |\n|---|---|---|---|---|---|---|---|\n");
  std::vector<Work> works;
  std::vector<Result> results(6);
  const auto peer = [&](std::size_t i, auto&& call) {
    results[i].positions = scan.positions;
    results[i].triangles.resize(scan.triangles.size());
    results[i].triangles.resize(call(results[i].triangles.data()));
  };
  works.push_back({"meshoptimizer sloppy", [&] {
                     peer(0, [&](std::uint32_t* to) {
                       return meshopt_simplifySloppy(to, scan.triangles.data(), scan.triangles.size(),
                                                     scan.positions.data(), points, 12, 3 * target, 1, nullptr);
                     });
                   }});
  works.push_back({"meshoptimizer simplify", [&] {
                     peer(1, [&](std::uint32_t* to) {
                       return meshopt_simplify(to, scan.triangles.data(), scan.triangles.size(), scan.positions.data(),
                                               points, 12, 3 * target, 1, 0, nullptr);
                     });
                   }});
  const auto ours = [&](std::size_t i, vstree::Clustering clustering, vstree::Representative representative) {
    vstree::Simplified few =
        vstree::simplify({{.positions = scan.positions, .normals = scan.normals}, scan.triangles},
                         {.clustering = clustering, .representative = representative, .target = target, .threads = 1});
    results[i] = {std::move(few.positions), std::move(few.triangles)};
  };
  using vstree::Clustering, vstree::Representative;
  works.push_back({"volume-surface tree", [&] { ours(2, Clustering::volume_surface, Representative::qef); }});
  works.push_back({"the same, centroids", [&] { ours(3, Clustering::volume_surface, Representative::centroid); }});
  works.push_back({"octree", [&] { ours(4, Clustering::octree, Representative::qef); }});
  works.push_back({"grid", [&] { ours(5, Clustering::grid, Representative::qef); }});
  take_turns(works, settings.rounds);
  const std::vector<float> samples = samples_of(scan.positions, scan.triangles, 200000);
  for (std::size_t i = 0; i < works.size(); ++i) print(works[i], results[i], scan, samples, works[0].least);
}

Settings settings_of(int count, char** words) {
  Settings settings;
  for (int i = 1; i < count; i += 2) {
    const std::string word = words[i];
    if (i + 1 == count)
      throw std::runtime_error(word + ": give a value, or nothing; options are --data, --samples, --rounds");
    if (word == "--data") {
      settings.data = words[i + 1];
    } else if (word == "--samples") {
      settings.samples = std::stoul(words[i + 1]);
    } else if (word == "--rounds") {
      settings.rounds = std::stoi(words[i + 1]);
    } else {
      throw std::runtime_error(word + " is no option; --data FOLDER, --samples N and --rounds N are");
    }
  }
  return settings;
}

}  // namespace
}  // namespace glark::bench

int main(int count, char** words) {
  try {
    const glark::bench::Settings settings = glark::bench::settings_of(count, words);
    glark::bench::bench_build(settings);
    glark::bench::bench_simplify(settings, "igea", 25700);
    glark::bench::bench_simplify(settings, "armadillo", 8600);
    glark::bench::bench_simplify(settings, "bunny", 7000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glark-bench-points: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
