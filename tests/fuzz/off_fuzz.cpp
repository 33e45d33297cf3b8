// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any bytes as an OFF file: points with whole attributes and triangles of points, or an Error.
#include <cstdlib>

#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/read/off_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glark::geometry;
  try {
    Input input = memory_input("fuzz.off", {reinterpret_cast<const char*>(data), size});
    const Geometry geometry = read_off(input, {.skip_invalid = size % 2 == 1}).geometry;
    for (const std::uint32_t corner : geometry.triangles)
      if (corner >= geometry.point_count()) std::abort();
    if (!geometry.normals.empty() && geometry.normals.size() != geometry.positions.size()) std::abort();
    if (!geometry.colours.empty() && geometry.colours.size() != 4 * geometry.point_count()) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
