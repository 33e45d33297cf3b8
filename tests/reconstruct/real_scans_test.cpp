// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tests on real scans, if there are any in the folder GLARK_SCANS of CMake.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/bench_points/measure/scan.h"
#include "tests/bench_points/measure/surface_distance.h"
#include "tests/reconstruct/meshes.h"

namespace glark::reconstruct::test {
namespace {

class RealScans : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(GLARK_SCANS)) GTEST_SKIP() << "there are no scans in " << GLARK_SCANS;
  }

  static Reconstructed of(const std::string& name) {
    const bench::Scan scan = bench::read_scan(GLARK_SCANS, name);
    return reconstruct({.positions = scan.positions, .normals = scan.normals});
  }
};

TEST_F(RealScans, OfClosedModelsAreClosed) {
  for (const char* name : {"igea", "horse", "armadillo", "nefertiti"}) {
    const Reconstructed mesh = of(name);
    expect_manifold(mesh);
    EXPECT_EQ(topology_of(mesh).boundary, 0U) << name;
    EXPECT_EQ(topology_of(mesh).parts, 1U) << name;
    EXPECT_EQ(volume(mesh) > 0, std::string(name) != "horse") << name;  // its normals point inwards
  }
}

TEST_F(RealScans, OfAHeadAreClose) {
  const bench::Scan scan = bench::read_scan(GLARK_SCANS, "igea");
  const Reconstructed mesh = of("igea");
  const double percent = 100 / bench::diagonal_of(scan.positions);
  const std::vector<float> there = bench::samples_of(mesh.positions, mesh.triangles, 100000);
  const std::vector<float> back = bench::samples_of(scan.positions, scan.triangles, 100000);
  EXPECT_LT(bench::SurfaceDistance(scan.positions, scan.triangles).rms(there) * percent, 0.0032);
  EXPECT_LT(bench::SurfaceDistance(mesh.positions, mesh.triangles).rms(back) * percent, 0.0032);
}

// Raw scans overlap and are noisy.
TEST_F(RealScans, OfAStatueAreOneSurface) {
  const Reconstructed mesh = of("happy_stand_scans");
  expect_manifold(mesh);
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(topology.parts, 1U);
  EXPECT_LT(topology.boundary, 5000U);
  const bench::Scan scan = bench::read_scan(GLARK_SCANS, "happy_stand_scans");
  std::vector<float> some;
  for (std::size_t i = 0; i < scan.positions.size(); i += 150)
    some.insert(some.end(), &scan.positions[i], &scan.positions[i] + 3);
  const double rms = bench::SurfaceDistance(mesh.positions, mesh.triangles).rms(some);
  EXPECT_LT(rms / bench::diagonal_of(scan.positions), 8e-4);
}

}  // namespace
}  // namespace glark::reconstruct::test
