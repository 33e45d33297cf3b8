// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/mpi/face_records.h"

#include <algorithm>

#include "glark/clients/geometry/parse/ply_values.h"

namespace glark::tool {
namespace {

namespace ply = geometry::ply;

constexpr std::size_t corners_of_triangle = 3;

bool is_corners(const ply::Property& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// Whether the element is faces whose only list is their corners.
bool is_faces(const ply::Element& element) {
  const auto lists = std::count_if(element.properties.begin(), element.properties.end(),
                                   [](const ply::Property& property) { return property.count_type.has_value(); });
  return element.name == "face" && lists == 1 &&
         std::any_of(element.properties.begin(), element.properties.end(), is_corners);
}

// The bytes of a triangle.
std::uint64_t stride_of(const ply::Element& faces) {
  std::uint64_t bytes = 0;
  for (const ply::Property& property : faces.properties)
    bytes += property.count_type ? size_of(*property.count_type) + corners_of_triangle * size_of(property.type)
                                 : size_of(property.type);
  return bytes;
}

}  // namespace

std::unique_ptr<FaceRecords> faces_in(const std::filesystem::path& file, const std::string& format) {
  if ((format.empty() ? file.extension() : std::filesystem::path(format)) != ".ply") return nullptr;
  geometry::Input input = geometry::open_input(file);
  const ply::Header header = ply::read_header(input);
  const std::optional<std::uint64_t> remaining = input.remaining();
  if (header.encoding == ply::Encoding::text || !remaining) return nullptr;
  std::uint64_t begin = std::filesystem::file_size(file) - *remaining;
  for (const ply::Element& element : header.elements) {
    if (is_faces(element)) return std::make_unique<FaceRecords>(file, header, begin);
    if (element.has_lists()) return nullptr;
    begin += element.count * element.least_size(header.encoding);
  }
  return nullptr;
}

FaceRecords::FaceRecords(const std::filesystem::path& file, const ply::Header& header, std::uint64_t begin)
    : file_(file),
      encoding_(header.encoding),
      faces_(*std::find_if(header.elements.begin(), header.elements.end(), is_faces)),
      begin_(begin),
      stride_(stride_of(faces_)) {}

bool FaceRecords::each(std::uint64_t begin, std::uint64_t end, const TakeCorners& take) const {
  std::uint64_t at = begin_ + begin * stride_;
  const std::uint64_t last = std::min(file_.size(), begin_ + end * stride_);
  geometry::Input input(
      file_.name(),
      [&](std::span<char> to) {
        const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), last - std::min(at, last)));
        file_.read(at, to.first(size));
        at += size;
        return size;
      },
      std::nullopt);
  ply::Values values(input, encoding_);
  std::vector<double> corners;
  for (std::uint64_t face = begin; face < end; ++face) {
    values.at(faces_, face);
    for (const ply::Property& property : faces_.properties) {
      if (!property.count_type) {
        values.number(property.type);
        continue;
      }
      values.list(property, corners);
      if (corners.size() != corners_of_triangle) return false;
    }
    take({static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
          static_cast<std::uint32_t>(corners[2])});
  }
  return true;
}

}  // namespace glark::tool
