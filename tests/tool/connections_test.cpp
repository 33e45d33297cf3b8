// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/simplify/connections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace glark::tool {
namespace {

// Triangles that share the edge from 0 to 1, and a point for each of them. The last one may be apart.
geometry::Geometry fan(std::uint32_t triangles, bool is_last_apart = false) {
  geometry::Geometry fan;
  fan.positions = {0, 0, 0, 1, 0, 0};
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const auto x = static_cast<float>(i);
    fan.positions.insert(fan.positions.end(), {x, 1, x * x});
    fan.triangles.insert(fan.triangles.end(), {0, 1, i + 2});
  }
  if (!is_last_apart) return fan;
  fan.positions.insert(fan.positions.end(), {8, 8, 8, 9, 8, 8});
  const std::uint32_t last = triangles + 1;
  std::copy_n(std::array{last, last + 1, last + 2}.begin(), 3, fan.triangles.end() - 3);
  return fan;
}

TEST(Connections, ThatStayAreNotTold) {
  testing::internal::CaptureStderr();
  const Report report = connections_report(fan(3), fan(3), "a.ply");
  EXPECT_EQ("", testing::internal::GetCapturedStderr());
  EXPECT_EQ(1, report["parts_before"]);
  EXPECT_EQ(1, report["parts_after"]);
  EXPECT_EQ(0, report["non_manifold_edges_added"]);
}

TEST(Connections, PartsAreToldIfTheirNumberChanges) {
  testing::internal::CaptureStderr();
  connections_report(fan(2), fan(2, true), "a.ply");
  EXPECT_EQ("glark: a.ply: 1 connected part became 2\n", testing::internal::GetCapturedStderr());
  testing::internal::CaptureStderr();
  connections_report(fan(2, true), fan(2), "a.ply");
  EXPECT_EQ("glark: a.ply: 2 connected parts became 1\n", testing::internal::GetCapturedStderr());
}

TEST(Connections, EdgesOfMoreThanTwoTrianglesAreToldIfThereAreMore) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(1, connections_report(fan(2), fan(4), "a.ply")["non_manifold_edges_added"]);
  EXPECT_EQ("glark: a.ply: edges of more than two triangles: 1; the input has 0\n",
            testing::internal::GetCapturedStderr());
  testing::internal::CaptureStderr();
  connections_report(fan(4), fan(2), "a.ply");
  EXPECT_EQ("", testing::internal::GetCapturedStderr());
}

}  // namespace
}  // namespace glark::tool
