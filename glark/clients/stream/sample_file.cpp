// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/stream.h>

namespace glark::stream {

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options) {
  SampleReport report = sample(file_source(large), options, small.parent_path(),
                               [&](const Schema& schema) { return create_points(small, schema); });
  if (std::filesystem::is_regular_file(large) && std::filesystem::is_regular_file(small))
    write_cells(small.string() + ".cells", {std::filesystem::file_size(large), report.points, report.cells});
  return report;
}

}  // namespace glark::stream
