// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The contents of a file: points with attributes, and triangles if there are any.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace glark::geometry {

// An error in a file. what() names the file, the element and the remedy.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What an image shows beyond texture coordinates of 0 to 1.
enum class Wrap : std::uint8_t { repeat, mirror, clamp };

// The colours of a surface, as they are shown.
struct Image {
  unsigned width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // red, green, blue: 3 per pixel; the first row is the upper one, at t = 1
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
};

inline constexpr std::uint32_t no_image = 0xFFFFFFFF;

struct Geometry {
  // Georeferenced coordinates have more digits than a float. So a position is `origin` plus three floats. The origin is
  // zero if floats suffice.
  std::array<double, 3> origin{};
  std::vector<float> positions;            // 3 per point
  std::vector<float> normals;              // 3 per point, or empty; zero where a point has no normal
  std::vector<std::uint8_t> colours;       // red, green, blue, alpha: 4 per point, or empty
  std::vector<float> texture_coordinates;  // 2 per point, or empty
  std::vector<std::uint32_t> triangles;    // 3 indices per triangle, or empty
  // Pictures of materials, if ReadOptions asks for them, and the one of each triangle, or no_image. Both may be empty.
  std::vector<Image> images;
  std::vector<std::uint32_t> triangle_images;
  bool colours_tint_images = false;  // the colours of points multiply those of images, as linear colours
  // Triangle strips, one after the other, and their lengths. A PLY file gets the strips instead of the triangles.
  std::vector<std::uint32_t> strips;
  std::vector<std::uint32_t> strip_sizes;

  std::size_t point_count() const { return positions.size() / 3; }
  std::size_t triangle_count() const { return triangles.size() / 3; }
};

// Receives the points and triangles of a file one after the other.
class Visitor {
 public:
  virtual ~Visitor() = default;
  // A position that is not finite is one of those that are left out.
  virtual void add_point(const std::array<double, 3>& position, const std::array<float, 3>& normal) = 0;
  // Three indices of points, which count those that are left out.
  virtual void add_triangle(const std::array<std::uint32_t, 3>& corners) = 0;
};

struct ReadOptions {
  // Leave out points with NaN or infinite coordinates, and their triangles; false: throw Error.
  bool skip_invalid = false;
  // The format by its ending, ".ply" for example; empty: that of the file's name.
  std::string format = {};
  bool images = false;  // reads the pictures of materials, too
  // Keeps what reading drops from a mesh: points of OFF that equal others, and vertices of OBJ that nothing uses.
  bool all_points = false;
  // Receives what summarise_file() reads; null: nobody does.
  Visitor* visitor = nullptr;
};

struct Reading {
  Geometry geometry;
  std::vector<std::string> warnings;  // data that was lost in reading
};

// What a file has, without the points themselves.
struct Summary {
  std::uint64_t points = 0, triangles = 0;
  bool normals = false, colours = false, texture_coordinates = false;
  std::array<double, 3> origin{};       // as in Geometry
  std::array<double, 3> low{}, high{};  // the bounding box
  std::vector<std::string> warnings;
};

// Throws Error if `bytes` bytes do not fit into the memory of this machine.
void require_memory(const std::string& file, double bytes);

}  // namespace glark::geometry
