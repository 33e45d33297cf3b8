// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/stream.h>

#include <optional>

#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/files/require_other_file.h"
#include "glark/clients/stream/format/layouts.h"
#include "glark/clients/stream/refine/index_text.h"
#include "glark/clients/stream/sample/sample_and_publish.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

namespace fs = std::filesystem;

// Sampling reads a file several times. What is read from a pipe is gone.
void require_passes(const fs::path& large) {
  std::error_code error;
  const fs::file_status status = fs::status(large, error);
  if (fs::is_fifo(status) || fs::is_socket(status) || fs::is_character_file(status) || large == "-")
    throw Error(Element::file, 0,
                large.string() + ": is no regular file, and sampling reads it several times; write it to a disk first");
}

// What is wrong with the name of the output is said before the work.
void require_writable(const fs::path& small) {
  require_streamed_ending(small);
  if (format_of(small, "") == ".stl")
    throw Error(Element::file, 0,
                small.string() +
                    ": an STL file has triangles only, and samples are points; use .ply, .las, .xyz, .pts or .raw");
  std::error_code error;
  const fs::path folder = small.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    throw Error(Element::file, 0, small.string() + ": there is no folder " + folder.string() + "; make it first");
}

}  // namespace

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options) {
  return sample_file(large, small, options, SampleFormats{});
}

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options, const SampleFormats& formats) {
  require_name(small, "the sampling");
  const std::filesystem::path index = small.string() + ".cells";
  require_other_file(small, {large});
  require_other_file(index, {large});
  require_replaceable_index(index);
  require_passes(large);
  require_writable(small);
  return sample_and_publish(
      file_source(large, formats.large), options, small.parent_path(),
      [&](const Schema& schema) { return create_points(small, schema, std::nullopt, {.text = formats.text}); },
      [&](const SampleReport& report) {
        std::error_code error;
        if (std::filesystem::is_regular_file(large, error) && std::filesystem::is_regular_file(small, error))
          write_cells(index, {std::filesystem::file_size(large), report.points, report.cells, report.samples});
      });
}

}  // namespace glark::stream
