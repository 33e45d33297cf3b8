// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/geometry.h"
#include "glark/clients/stream/files/names.h"
#include "glark/clients/stream/format/layouts.h"
#include "glark/clients/stream/read/checked_reader.h"
#include "glark/clients/stream/read/readers.h"

namespace glark::stream {
namespace {

namespace fs = std::filesystem;

bool is_text(const std::string& format) {
  return format == ".xyz" || format == ".txt" || format == ".asc" || format == ".csv" || format == ".pts";
}

// Reads a file in order: text, a pipe, or a compressed file.
std::unique_ptr<PointReader> open_stream(const fs::path& file, const std::string& format, const ReadOptions& options) {
  geometry::Input input = geometry::open_input(file);
  if (format == ".ply") {
    const geometry::ply::Header header = geometry::ply::read_header(input);
    return ply_stream_reader(std::move(input), header, options);
  }
  if (is_text(format))
    return lines_reader(std::move(input), format == ".pts" ? geometry::TextPoints::pts : geometry::TextPoints::xyz,
                        options);
  throw Error(Element::file, 0,
              format.empty() ? file.string() + ": has no ending that tells its format; give the option format"
                             : file.string() + ": only PLY and text can be read from a pipe or compressed, not " +
                                   format + "; write the file to a disk first");
}

std::unique_ptr<PointReader> open_any(const fs::path& file, const ReadOptions& options) {
  const std::string format = format_of(file, options.format);
  std::error_code unknown;  // opening the file tells what is wrong with it
  const bool is_pipe = fs::exists(file, unknown) && !fs::is_regular_file(file, unknown);
  if (is_text(format) || is_compressed(file) || is_pipe) return open_stream(file, format, options);
  SourceFile source(file);
  if (std::optional<Layout> layout = layout_of(source, format))
    return record_reader(std::move(source), std::move(*layout), options);
  return open_stream(file, format, options);
}

}  // namespace

PointReader::~PointReader() = default;
PointWriter::~PointWriter() = default;

std::unique_ptr<PointReader> open_points(const fs::path& file, const ReadOptions& options) {
  require_name(file, "an input");
  try {
    return std::make_unique<CheckedReader>(open_any(file, options));
  } catch (const geometry::Error& error) {
    throw Error(Element::file, 0, error.what());
  }
}

}  // namespace glark::stream
