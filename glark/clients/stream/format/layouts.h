// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The layouts of the formats whose points are records of one size. Each function throws Error for a bad header.
#pragma once

#include <optional>

#include "glark/clients/geometry/parse/ply_header.h"
#include "glark/clients/stream/files/source_file.h"
#include "glark/clients/stream/format/layout.h"

namespace glark::stream {

// Returns the places of the numbers in a binary record of the element vertex.
Layout vertex_layout(const geometry::ply::Element& vertex, const std::string& file);
// Reads the header again, which was read before. Text has no layout.
std::optional<Layout> ply_layout(const SourceFile& file);

Layout stl_layout(const SourceFile& file);
Layout raw_layout(const SourceFile& file);

// Chooses the layout by the ending; none for text.
std::optional<Layout> layout_of(const SourceFile& file, const std::string& format);

// The ending of a name in lower case, without ".zst".
std::string format_of(const std::filesystem::path& file, const std::string& format);
bool is_compressed(const std::filesystem::path& file);

}  // namespace glark::stream
