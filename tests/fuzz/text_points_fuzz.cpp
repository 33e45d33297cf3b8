// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any bytes as a text file of points: points, or an Error.
#include <cstdlib>

#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/read/text_points.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glark::geometry;
  try {
    Input input = memory_input("fuzz.pts", {reinterpret_cast<const char*>(data), size});
    const TextPoints kind = size % 3 == 0 ? TextPoints::xyz : TextPoints::pts;
    const Geometry geometry = read_text_points(input, kind, {.skip_invalid = size % 2 == 1}).geometry;
    if (geometry.positions.size() % 3 != 0 || geometry.positions.empty()) std::abort();
    if (!geometry.colours.empty() && geometry.colours.size() != 4 * geometry.point_count()) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
