// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads the triangles of a binary PLY file, beginning with any of them. All faces must be triangles, so that their records
// have the same size.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "glark/clients/geometry/parse/ply_header.h"
#include "glark/clients/stream/files/source_file.h"

namespace glark::tool {

using TakeCorners = std::function<void(const std::array<std::uint32_t, 3>& corners)>;

class FaceRecords {
 public:
  // begin: the first byte of the faces.
  FaceRecords(const std::filesystem::path& file, const geometry::ply::Header& header, std::uint64_t begin);

  std::uint64_t count() const { return faces_.count; }
  // Gives the triangles from `begin` to `end`. Returns false at a face that is no triangle: then it is unknown where the
  // next one begins. If this does not happen for any range, all ranges were right. Throws Error if the file ends.
  bool each(std::uint64_t begin, std::uint64_t end, const TakeCorners& take) const;

 private:
  stream::SourceFile file_;
  geometry::ply::Encoding encoding_;
  geometry::ply::Element faces_;
  std::uint64_t begin_ = 0, stride_ = 0;  // bytes
};

// Returns nothing if the file is no binary PLY file whose only lists are the corners of faces.
std::unique_ptr<FaceRecords> faces_in(const std::filesystem::path& file, const std::string& format);

}  // namespace glark::tool
