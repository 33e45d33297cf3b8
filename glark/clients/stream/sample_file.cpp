// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/stream.h>

#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/refine/index_text.h"

namespace glark::stream {

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options) {
  require_name(small, "the sampling");
  const std::string cells = small.string() + ".cells";
  require_replaceable_index(cells);
  SampleReport report = sample(file_source(large), options, small.parent_path(),
                               [&](const Schema& schema) { return create_points(small, schema); });
  std::error_code error;
  if (std::filesystem::is_regular_file(large, error) && std::filesystem::is_regular_file(small, error))
    write_cells(cells, {std::filesystem::file_size(large), report.points, report.cells});
  return report;
}

}  // namespace glark::stream
