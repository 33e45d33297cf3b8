// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/depth.h>

#include <array>

int main() {
  const std::array<std::uint32_t, 3> triangles = {0, 1, 2};
  const std::array<float, 3> wanted = {2, 2, 2};
  std::array<float, 3> tags = {};
  const glark::depth::Tagger tagger(3, triangles, 6);
  tagger.manual(wanted, tags);
  return tagger.refined_triangles(tags) == 16 ? 0 : 1;
}
