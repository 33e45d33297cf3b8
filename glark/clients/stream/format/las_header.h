// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The header of LAS files, versions 1.0 to 1.4, and the fields of point formats 0 to 10.
// Source: ASPRS, LAS Specification 1.4 R15, tables 3 to 18.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glark/clients/stream/files/source_file.h"
#include "glark/clients/stream/format/layout.h"

namespace glark::stream {

struct LasHeader {
  std::string file;  // for messages
  unsigned minor = 2;
  unsigned point_format = 0;
  std::uint16_t header_size = 227;
  std::uint32_t points_begin = 227;  // in bytes
  std::uint16_t record_size = 20;
  std::uint64_t points = 0;
  std::array<double, 3> scale{1, 1, 1}, offset{}, least{}, greatest{};
};

// Throws Error for a file that is no LAS file, is compressed (LAZ), or is too short for its points.
LasHeader read_las_header(const SourceFile& file);
// The same for bytes in memory: `bytes` has the beginning of the file, which has `size` bytes.
LasHeader parse_las_header(const std::string& file, std::span<const char> bytes, std::uint64_t size);

Layout las_layout(const LasHeader& header);
// Many programs write colours from 0 to 255 where LAS has 16 bits. If none of a few thousand points of the whole file has
// more, the schema says that the colours are bytes.
void read_byte_colours(const SourceFile& file, Layout& layout);

// The point format, 0, 2 or 7, that can hold these channels.
unsigned las_format_for(const Schema& schema);
// The bytes of the header of a new file. Formats from 6 on need version 1.4.
std::vector<char> las_header_bytes(const LasHeader& header);
// Puts the count and the bounding box into header bytes, which may be those of an existing file.
void patch_las_header(const LasHeader& header, std::span<char> bytes);

inline constexpr std::size_t longest_las_header = 375;

}  // namespace glark::stream
