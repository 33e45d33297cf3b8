// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/stream.h>

#include "glark/clients/stream/files/require_other_file.h"

namespace glark::stream {

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options) {
  return sample_file(large, small, options, SampleFormats{});
}

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options, const SampleFormats& formats) {
  const std::filesystem::path index = small.string() + ".cells";
  require_other_file(small, {large});
  require_other_file(index, {large});
  SampleReport report =
      sample(file_source(large, formats.large), options, small.parent_path(),
             [&](const Schema& schema) { return create_points(small, schema, std::nullopt, {.text = formats.text}); });
  if (std::filesystem::is_regular_file(large) && std::filesystem::is_regular_file(small))
    write_cells(index, {std::filesystem::file_size(large), report.points, report.cells});
  return report;
}

}  // namespace glark::stream
