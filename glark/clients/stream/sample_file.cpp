// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample_files.h"

#include <optional>
#include <utility>

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

SampleFiles::SampleFiles(fs::path large, fs::path small, SampleFormats formats)
    : large_(std::move(large)),
      small_(std::move(small)),
      index_(small_.string() + ".cells"),
      formats_(std::move(formats)) {
  require_name(small_, "the sampling");
  require_other_file(small_, {large_});
  require_other_file(index_, {large_});
  require_replaceable_index(index_);
  require_passes(large_);
  require_writable(small_);
}

std::unique_ptr<PointWriter> SampleFiles::create(const Schema& schema) const {
  return create_points(small_, schema, std::nullopt, {.text = formats_.text});
}

void SampleFiles::write_index(const SampleReport& report) const {
  std::error_code error;
  if (fs::is_regular_file(large_, error) && fs::is_regular_file(small_, error))
    write_cells(index_, {fs::file_size(large_), report.points, report.cells, report.samples});
}

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options) {
  return sample_file(large, small, options, SampleFormats{});
}

SampleReport sample_file(const std::filesystem::path& large, const std::filesystem::path& small,
                         const SampleOptions& options, const SampleFormats& formats) {
  const SampleFiles files(large, small, formats);
  return sample_and_publish(
      files.source(), options, files.folder(), [&](const Schema& schema) { return files.create(schema); },
      [&](const SampleReport& report) { files.write_index(report); });
}

}  // namespace glark::stream
