// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/format/layouts.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {

void require_streamed_ending(const std::filesystem::path& file) {
  require_name(file, "the output");
  const std::string format = format_of(file, "");
  if (is_compressed(file))
    throw Error(Element::file, 0, file.string() + ": compressed files are only read; write the file, then run zstd");
  for (const char* known : {".ply", ".las", ".raw", ".stl", ".xyz", ".pts"})
    if (format == known) return;
  throw Error(Element::file, 0,
              file.string() + ": the ending \"" + format +
                  "\" names no format that glark streams to; use .ply, .las, .stl, .xyz, .pts or .raw");
}

std::unique_ptr<PointWriter> create_points(const std::filesystem::path& file, const Schema& schema,
                                           std::optional<std::uint64_t> count, const WriteOptions& options) {
  require_streamed_ending(file);
  const std::string format = format_of(file, "");
  const Creation creation{file, schema, count, options};
  if (format == ".ply") return options.text ? text_writer(creation, format) : ply_writer(creation);
  if (format == ".las") return las_writer(creation);
  if (format == ".raw") return raw_writer(creation);
  if (format == ".stl") return stl_writer(creation);
  return text_writer(creation, format);
}

}  // namespace glark::stream
