// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any bytes as a LAS file: records that lie within the file, or an Error.
#include <cstdlib>

#include "glark/clients/stream/format/las_header.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace glark::stream;
  const std::span<const char> bytes(reinterpret_cast<const char*>(data), size);
  try {
    const std::size_t begin = std::min(size, longest_las_header);
    const LasHeader header = parse_las_header("fuzz.las", bytes.first(begin), size);
    const Layout layout = las_layout(header);
    if (layout.begin > size || layout.records > (size - layout.begin) / layout.record_size) std::abort();
    // The records are a copy of their own, so that AddressSanitizer sees each byte beyond them.
    const std::vector<char> records(
        bytes.begin() + static_cast<std::ptrdiff_t>(layout.begin),
        bytes.begin() + static_cast<std::ptrdiff_t>(layout.begin + layout.records * layout.record_size));
    PointArrays arrays;
    decode(layout, records.data(), layout.records, {}, arrays);
    if (arrays.positions.size() != 3 * layout.records) std::abort();
    if (arrays.channels.size() != layout.schema.channels.size() * layout.records) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
