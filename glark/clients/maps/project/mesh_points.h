// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/maps.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace glark::maps {

// A reader whose points are samples of a mesh. A triangle whose longest edge has n times the spacing gives n * n of them,
// or one for each pixel if these are more. All pixels together give at most 16 million: where a picture repeats often on
// a small area, samples are fewer than pixels.
class MeshPoints final : public stream::PointReader {
 public:
  MeshPoints(const FineMesh& mesh, double spacing, std::string name);

  const std::string& name() const override { return name_; }
  const stream::Schema& schema() const override { return schema_; }
  std::optional<std::uint64_t> count() const override { return first_.back(); }
  stream::Points read(std::size_t most) override;
  bool can_seek() const override { return true; }
  void seek(std::uint64_t point) override;

 private:
  void add_vertex_normals();
  void add_crease_normals();
  void add_point(std::uint64_t index);
  // The pixels that a triangle shows; 0 without a picture.
  double pixels_of(std::size_t triangle) const;
  double area_of(std::size_t triangle) const;
  // The most samples for pixels in a unit of area, so that all together are not too many.
  double density_of_pixels() const;
  void add_vertex(std::uint32_t vertex);
  // The normal at a corner. corner: 3 * triangle + 0, 1 or 2
  const float* normal_at(std::size_t corner) const;
  const Picture* picture_of(std::size_t triangle) const;
  PictureWrap wrap_of(std::size_t triangle) const;
  // Multiplies a colour of 0 to 255 by the tint at a place in a triangle.
  void tint(const std::array<std::uint32_t, 3>& corners, const std::array<double, 3>& weights,
            std::array<double, 3>& colour) const;
  std::array<double, 3> colour(std::size_t triangle, const std::array<std::uint32_t, 3>& corners,
                               const std::array<double, 3>& weights) const;
  // normals: of the corners.
  void add_mean(std::size_t triangle, const std::array<std::uint32_t, 3>& corners,
                const std::array<const float*, 3>& normals, const std::array<double, 3>& weights);

  FineMesh mesh_;
  std::string name_;
  stream::Schema schema_;
  std::uint64_t vertices_ = 0, next_ = 0;
  std::vector<std::uint16_t> parts_;                            // of the longest edge of each triangle
  std::vector<std::uint64_t> first_;                            // the first point of each triangle, and the end
  std::vector<float> normals_;                                  // of the vertices, then of corners at creases
  std::vector<std::uint32_t> creased_;                          // the corners at creases, in their order
  std::unordered_map<std::uint32_t, std::uint32_t> crease_of_;  // of vertices: one of the corners there
  std::vector<std::uint32_t> triangle_of_;  // one of the triangles of each vertex, for its colour; only with pictures
  std::vector<double> positions_, channels_;
  std::vector<float> out_normals_;
};

}  // namespace glark::maps
