// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/stream.h>

#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/files/require_other_file.h"
#include "glark/clients/stream/refine/index_text.h"

namespace glark::stream {

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
  SampleReport report =
      sample(file_source(large, formats.large), options, small.parent_path(),
             [&](const Schema& schema) { return create_points(small, schema, std::nullopt, {.text = formats.text}); });
  std::error_code error;
  if (std::filesystem::is_regular_file(large, error) && std::filesystem::is_regular_file(small, error))
    write_cells(index, {std::filesystem::file_size(large), report.points, report.cells});
  return report;
}

}  // namespace glark::stream
