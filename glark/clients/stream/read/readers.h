// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The readers behind open_points().
#pragma once

#include <memory>

#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/parse/ply_header.h"
#include "glark/clients/geometry/parse/text_row.h"
#include "glark/clients/stream/files/source_file.h"
#include "glark/clients/stream/format/layout.h"

namespace glark::stream {

// Records of one size in a regular file.
std::unique_ptr<PointReader> record_reader(SourceFile file, Layout layout, const ReadOptions& options);
// PLY from a pipe, compressed, or as text. The input stands after the header.
std::unique_ptr<PointReader> ply_stream_reader(geometry::Input input, const geometry::ply::Header& header,
                                               const ReadOptions& options);
// Lines of numbers.
std::unique_ptr<PointReader> lines_reader(geometry::Input input, geometry::TextPoints kind, const ReadOptions& options);

}  // namespace glark::stream
