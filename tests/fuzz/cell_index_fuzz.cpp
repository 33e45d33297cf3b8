// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any bytes as the index of a sampling: ranges within the scan that are the same after writing and reading, or an Error.
#include <cmath>
#include <cstdlib>

#include "glark/clients/stream/refine/index_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glark::stream;
  try {
    const CellIndex index = parse_index({reinterpret_cast<const char*>(data), size}, "fuzz.cells");
    for (const SampledCell& cell : index.cells)
      if (cell.first > cell.last || cell.last >= index.points || !std::isfinite(cell.side)) std::abort();
    const std::string text = index_text(index);
    if (index_text(parse_index(text, "again.cells")) != text) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
