// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The vertices of a fine mesh, then the centres of small triangles into which each of its triangles is divided.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "glark/clients/common/fnv.h"
#include "glark/clients/common/vector.h"
#include "glark/clients/maps/project/mesh_points.h"

namespace glark::maps {
namespace {

using Precise = common::Vector3d;

void require_pictures(const FineMesh& mesh, std::size_t vertices) {
  if (mesh.pictures.empty() && mesh.triangle_pictures.empty()) return;
  if (mesh.triangle_pictures.size() != mesh.triangles.size() / 3 ||
      (!mesh.texcoords.empty() && mesh.texcoords.size() != 2 * vertices))
    throw Error(
        Element::array, 0,
        fmt::format("the fine mesh has {} numbers of pictures and {} texture coordinates; give one for each of its "
                    "{} triangles, and two for each of its {} vertices",
                    mesh.triangle_pictures.size(), mesh.texcoords.size(), mesh.triangles.size() / 3, vertices));
  if ((!mesh.picture_wraps.empty() && mesh.picture_wraps.size() != mesh.pictures.size()) ||
      (!mesh.tints.empty() && mesh.tints.size() != 3 * vertices))
    throw Error(Element::array, 0,
                fmt::format("the fine mesh has {} wraps and {} numbers of tints; give one wrap for each of its {} "
                            "pictures, and three numbers for each of its {} vertices",
                            mesh.picture_wraps.size(), mesh.tints.size(), mesh.pictures.size(), vertices));
  for (std::size_t i = 0; i < mesh.pictures.size(); ++i)
    if (mesh.pictures[i].pixels.empty() ||
        mesh.pictures[i].pixels.size() != 3 * std::size_t{mesh.pictures[i].width} * mesh.pictures[i].height)
      throw Error(Element::array, i,
                  fmt::format("picture {} of the fine mesh has {} times {} pixels and {} numbers; give three for each",
                              i, mesh.pictures[i].width, mesh.pictures[i].height, mesh.pictures[i].pixels.size()));
  for (std::size_t t = 0; t < mesh.triangle_pictures.size(); ++t)
    if (mesh.triangle_pictures[t] != no_picture && mesh.triangle_pictures[t] >= mesh.pictures.size())
      throw Error(Element::triangle, t,
                  fmt::format("of the fine mesh has the picture {}, but there are {}", mesh.triangle_pictures[t],
                              mesh.pictures.size()));
}

// The coordinate of 0 to 1 that shows the same.
double wrapped(double coordinate, Wrap wrap) {
  if (!std::isfinite(coordinate)) return 0;
  if (wrap == Wrap::clamp) return std::clamp(coordinate, 0.0, 1.0);
  if (wrap == Wrap::mirror) return std::abs(coordinate - 2 * std::floor(coordinate / 2 + 0.5));
  return coordinate - std::floor(coordinate);
}

// Finds the two pixels around a coordinate. Returns the weight of the second one.
double pixels_at(double coordinate, unsigned size, Wrap wrap, std::array<std::size_t, 2>& pixels) {
  const double at = wrapped(coordinate, wrap) * size - 0.5;
  const double first = std::floor(at);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::int64_t pixel = static_cast<std::int64_t>(first) + static_cast<std::int64_t>(i);
    const std::int64_t last = std::int64_t{size} - 1;
    pixels[i] = static_cast<std::size_t>(wrap == Wrap::repeat ? (pixel + size) % size
                                                              : std::clamp(pixel, std::int64_t{0}, last));
  }
  return at - first;
}

// The colour of a picture at a texture coordinate, by bilinear filtering.
std::array<double, 3> colour_at(const Picture& picture, PictureWrap wrap, double s, double t) {
  std::array<std::size_t, 2> columns{}, rows{};
  const double x = pixels_at(s, picture.width, wrap.s, columns), y = pixels_at(1 - t, picture.height, wrap.t, rows);
  std::array<double, 3> colour{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = (i % 2 == 0 ? 1 - x : x) * (i / 2 == 0 ? 1 - y : y);
    const std::size_t pixel = 3 * (rows[i / 2] * picture.width + columns[i % 2]);
    for (std::size_t k = 0; k < 3; ++k) colour[k] += weight * picture.pixels[pixel + k];
  }
  return colour;
}

// Colours as they are shown (sRGB, IEC 61966-2-1), and linear ones, from 0 to 1.
double linear_of(double shown) { return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4); }
double shown_of(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

std::array<double, 256> linear_bytes() {
  std::array<double, 256> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = linear_of(static_cast<double>(i) / 255);
  return values;
}

void require(const FineMesh& mesh, double spacing) {
  if (!(spacing > 0))
    throw Error(Element::option, 0, fmt::format("spacing is {}; a length above zero is possible", spacing));
  const std::size_t vertices = mesh.positions.size() / 3;
  const auto fits = [&](std::size_t values) { return values == 0 || values == 3 * vertices; };
  if (mesh.positions.size() % 3 != 0 || mesh.triangles.size() % 3 != 0 || !fits(mesh.normals.size()) ||
      !fits(mesh.colours.size()))
    throw Error(Element::array, 0,
                fmt::format("the fine mesh has {} coordinates, {} of normals, {} of colours and {} indices; give three "
                            "for each vertex and triangle",
                            mesh.positions.size(), mesh.normals.size(), mesh.colours.size(), mesh.triangles.size()));
  require_pictures(mesh, vertices);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles[i] >= vertices)
      throw Error(Element::triangle, i / 3,
                  fmt::format("of the fine mesh has the vertex {}, but there are {}", mesh.triangles[i], vertices));
}

Precise vector_at(std::span<const float> values, std::size_t index) {
  return {static_cast<double>(values[3 * index]), static_cast<double>(values[3 * index + 1]),
          static_cast<double>(values[3 * index + 2])};
}

}  // namespace

MeshPoints::MeshPoints(const FineMesh& mesh, double spacing, std::string name)
    : mesh_(mesh), name_(std::move(name)), vertices_(mesh.positions.size() / 3) {
  schema_.position = stream::Number::float64;
  schema_.normals = !mesh.normals.empty() || !mesh.triangles.empty();
  if (!mesh.colours.empty() || !mesh.pictures.empty())
    for (const char* colour : {"red", "green", "blue"}) schema_.channels.push_back({colour, stream::Number::uint8});
  first_.push_back(vertices_);
  constexpr double most_parts = 4096;  // of an edge
  const double density = density_of_pixels();
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, common::length(vector_at(mesh.positions, mesh.triangles[3 * t + (k + 1) % 3]) -
                                                 vector_at(mesh.positions, mesh.triangles[3 * t + k])));
    const double pixels = std::min(pixels_of(t), density * area_of(t));
    const double wanted = std::max(std::ceil(longest / spacing), std::ceil(std::sqrt(pixels)));
    const double parts = std::isfinite(longest) ? std::clamp(wanted, 1.0, most_parts) : 1;
    parts_.push_back(static_cast<std::uint16_t>(parts));
    first_.push_back(first_.back() + std::uint64_t{parts_.back()} * parts_.back());
  }
  add_vertex_normals();
  if (mesh.pictures.empty()) return;
  triangle_of_.resize(vertices_, no_picture);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    triangle_of_[mesh.triangles[i]] = static_cast<std::uint32_t>(i / 3);
}

const Picture* MeshPoints::picture_of(std::size_t triangle) const {
  if (triangle >= mesh_.triangle_pictures.size() || mesh_.triangle_pictures[triangle] == no_picture) return nullptr;
  return &mesh_.pictures[mesh_.triangle_pictures[triangle]];
}

double MeshPoints::area_of(std::size_t triangle) const {
  const std::uint32_t* const corners = &mesh_.triangles[3 * triangle];
  const Precise a = vector_at(mesh_.positions, corners[0]);
  const double area = common::length(common::cross(vector_at(mesh_.positions, corners[1]) - a,
                                                   vector_at(mesh_.positions, corners[2]) - a)) /
                      2;
  return std::isfinite(area) ? area : 0;
}

double MeshPoints::density_of_pixels() const {
  constexpr double most_pixels = 1 << 24;
  constexpr double everything = std::numeric_limits<double>::max();
  const auto samples_with = [&](double density) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh_.triangle_pictures.size(); ++t)
      sum += std::min(pixels_of(t), density * area_of(t));
    return sum;
  };
  if (samples_with(everything) <= most_pixels) return everything;
  double low = 0, high = 1;
  while (samples_with(high) < most_pixels && high < everything / 4) high *= 4;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (samples_with(middle) < most_pixels ? low : high) = middle;
  }
  return low;
}

double MeshPoints::pixels_of(std::size_t triangle) const {
  const Picture* const picture = picture_of(triangle);
  if (picture == nullptr || mesh_.texcoords.empty()) return 0;
  const auto corner = [&](std::size_t k) {
    const std::size_t at = 2 * std::size_t{mesh_.triangles[3 * triangle + k]};
    return std::array<double, 2>{static_cast<double>(mesh_.texcoords[at]) * picture->width,
                                 static_cast<double>(mesh_.texcoords[at + 1]) * picture->height};
  };
  const std::array a = corner(0), b = corner(1), c = corner(2);
  const double pixels = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  return std::isfinite(pixels) ? pixels : 0;
}

PictureWrap MeshPoints::wrap_of(std::size_t triangle) const {
  return mesh_.picture_wraps.empty() ? PictureWrap{} : mesh_.picture_wraps[mesh_.triangle_pictures[triangle]];
}

void MeshPoints::tint(const std::array<std::uint32_t, 3>& corners, const std::array<double, 3>& weights,
                      std::array<double, 3>& colour) const {
  constexpr double white = 255;
  static const std::array<double, 256> linear_of_byte = linear_bytes();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double factor = 0;
    for (std::size_t k = 0; k < 3; ++k)
      factor += weights[k] * linear_of_byte[mesh_.tints[3 * std::size_t{corners[k]} + axis]];
    constexpr double nearly_white = 1 - 1e-9;
    if (factor < nearly_white) colour[axis] = white * shown_of(factor * linear_of(colour[axis] / white));
  }
}

// The colour of the triangle's picture, or that of its vertices; white without both.
std::array<double, 3> MeshPoints::colour(std::size_t triangle, const std::array<std::uint32_t, 3>& corners,
                                         const std::array<double, 3>& weights) const {
  std::array<double, 3> colour{};
  if (const Picture* const picture = picture_of(triangle)) {
    double s = 0, t = 0;
    for (std::size_t k = 0; k < 3 && !mesh_.texcoords.empty(); ++k) {
      s += weights[k] * static_cast<double>(mesh_.texcoords[2 * std::size_t{corners[k]}]);
      t += weights[k] * static_cast<double>(mesh_.texcoords[2 * std::size_t{corners[k]} + 1]);
    }
    colour = colour_at(*picture, wrap_of(triangle), s, t);
    if (!mesh_.tints.empty()) tint(corners, weights, colour);
    return colour;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < 3; ++k)
      colour[axis] +=
          weights[k] *
          (mesh_.colours.empty() ? 255 : static_cast<double>(mesh_.colours[3 * std::size_t{corners[k]} + axis]));
  return colour;
}

// A surface without normals is smooth where its triangles meet in small angles. At a crease, the normal of a corner is
// the mean of those triangles at its vertex that are on the same side of the crease.
void MeshPoints::add_crease_normals() {
  constexpr double cosine_of_crease = 0.7660444431189780;  // 40 degrees
  const std::size_t corners = mesh_.triangles.size();
  std::vector<common::Vector3f> directions(corners / 3);  // unit normals of the triangles
  for (std::size_t t = 0; t < directions.size(); ++t) {
    const Precise a = vector_at(mesh_.positions, mesh_.triangles[3 * t]);
    const Precise normal = common::unit(common::cross(vector_at(mesh_.positions, mesh_.triangles[3 * t + 1]) - a,
                                                      vector_at(mesh_.positions, mesh_.triangles[3 * t + 2]) - a));
    directions[t] = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
  }
  const auto meet = [&](std::size_t a, std::size_t b) {
    const auto cosine = static_cast<double>(common::dot(directions[a], directions[b]));
    return cosine >= cosine_of_crease || common::is_zero(directions[a]) || common::is_zero(directions[b]);
  };
  std::vector<std::uint32_t> begins(vertices_ + 1), order(corners);  // the corners of each vertex
  for (const std::uint32_t vertex : mesh_.triangles) ++begins[vertex + 1];
  for (std::size_t i = 0; i < vertices_; ++i) begins[i + 1] += begins[i];
  std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
  for (std::uint32_t i = 0; i < corners; ++i) order[next[mesh_.triangles[i]]++] = i;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::span<const std::uint32_t> around(
        &order[begins[mesh_.triangles[i]]],
        &order[begins[mesh_.triangles[i]]] + begins[mesh_.triangles[i] + 1] - begins[mesh_.triangles[i]]);
    if (std::all_of(around.begin(), around.end(), [&](std::uint32_t other) { return meet(i / 3, other / 3); }))
      continue;
    common::Vector3f sum{};
    for (const std::uint32_t other : around)
      if (meet(i / 3, other / 3)) sum += directions[other / 3] * static_cast<float>(area_of(other / 3));
    const common::Vector3f normal = common::unit(sum);
    creased_.push_back(i);
    crease_of_.emplace(mesh_.triangles[i], i);
    normals_.insert(normals_.end(), {normal.x, normal.y, normal.z});
  }
}

const float* MeshPoints::normal_at(std::size_t corner) const {
  const auto at = std::lower_bound(creased_.begin(), creased_.end(), corner);
  if (at != creased_.end() && *at == corner)
    return &normals_[3 * (vertices_ + static_cast<std::size_t>(at - creased_.begin()))];
  return &normals_[3 * std::size_t{mesh_.triangles[corner]}];
}

// Vertices without a normal get the mean normal of their triangles.
void MeshPoints::add_vertex_normals() {
  normals_.resize(3 * vertices_);
  if (!mesh_.normals.empty()) {
    std::copy(mesh_.normals.begin(), mesh_.normals.end(), normals_.begin());
    return;
  }
  std::vector<Precise> sums(vertices_);
  for (std::size_t t = 0; t < mesh_.triangles.size(); t += 3) {
    const Precise a = vector_at(mesh_.positions, mesh_.triangles[t]);
    const Precise normal = common::cross(vector_at(mesh_.positions, mesh_.triangles[t + 1]) - a,
                                         vector_at(mesh_.positions, mesh_.triangles[t + 2]) - a);
    for (std::size_t k = 0; k < 3; ++k) sums[mesh_.triangles[t + k]] += normal;
  }
  for (std::size_t i = 0; i < vertices_; ++i) {
    const Precise normal = common::unit(sums[i]);
    for (std::size_t k = 0; k < 3; ++k) normals_[3 * i + k] = static_cast<float>(normal[k]);
  }
  add_crease_normals();
}

void MeshPoints::seek(std::uint64_t point) {
  if (point > first_.back())
    throw Error(Element::point, point, fmt::format("is beyond the {} points of {}", first_.back(), name_));
  next_ = point;
}

stream::Points MeshPoints::read(std::size_t most) {
  if (most == 0) throw Error(Element::option, 0, "most is 0; 1 or more is possible");
  const std::uint64_t end = std::min(first_.back(), next_ + most);
  positions_.clear();
  out_normals_.clear();
  channels_.clear();
  stream::Points points;
  points.first = next_;
  for (; next_ < end; ++next_) add_point(next_);
  points.positions = positions_;
  points.normals = out_normals_;
  points.channels = channels_;
  return points;
}

// A vertex at a crease has several normals. So its point lies a little beside it, on a triangle, and has the normal there.
void MeshPoints::add_vertex(std::uint32_t vertex) {
  if (const auto crease = crease_of_.find(vertex); crease != crease_of_.end()) {
    const std::size_t t = crease->second / 3;
    const double part = 0.1 / parts_[t];
    std::array<double, 3> weights{part, part, part};
    weights.at(crease->second % 3) = 1 - 2 * part;
    add_mean(t, {mesh_.triangles[3 * t], mesh_.triangles[3 * t + 1], mesh_.triangles[3 * t + 2]},
             {normal_at(3 * t), normal_at(3 * t + 1), normal_at(3 * t + 2)}, weights);
    return;
  }
  const float* const normal = &normals_[3 * std::size_t{vertex}];
  add_mean(triangle_of_.empty() ? no_picture : triangle_of_[vertex], {vertex, vertex, vertex}, {normal, normal, normal},
           {1, 0, 0});
}

void MeshPoints::add_point(std::uint64_t index) {
  if (index < vertices_) {
    add_vertex(static_cast<std::uint32_t>(index));
    return;
  }
  const auto above = std::upper_bound(first_.begin(), first_.end(), index);
  const auto t = static_cast<std::size_t>(above - first_.begin()) - 1;
  const auto small = index - first_[t];
  const auto parts = static_cast<double>(parts_[t]);
  // Row r of small triangles has 2 r + 1 of them. Those with an even place point up.
  auto row = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(small)));
  while (row * row > small) --row;
  while ((row + 1) * (row + 1) <= small) ++row;
  const std::uint64_t place = small - row * row;
  const std::uint64_t pair = place / 2;
  const double third = place % 2 == 0 ? 1 / 3.0 : 2 / 3.0;
  const double second = (static_cast<double>(pair) + third) / parts;
  const double first = (static_cast<double>(row) + (place % 2 == 0 ? 2 / 3.0 : 1 / 3.0)) / parts - second;
  add_mean(t, {mesh_.triangles[3 * t], mesh_.triangles[3 * t + 1], mesh_.triangles[3 * t + 2]},
           {normal_at(3 * t), normal_at(3 * t + 1), normal_at(3 * t + 2)}, {1 - first - second, first, second});
}

void MeshPoints::add_mean(std::size_t triangle, const std::array<std::uint32_t, 3>& corners,
                          const std::array<const float*, 3>& normals, const std::array<double, 3>& weights) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double position = mesh_.origin[axis];
    double normal = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      position += weights[k] * static_cast<double>(mesh_.positions[3 * std::size_t{corners[k]} + axis]);
      normal += weights[k] * static_cast<double>(normals[k][axis]);
    }
    positions_.push_back(position);
    out_normals_.push_back(static_cast<float>(normal));
  }
  if (schema_.channels.empty()) return;
  const std::array<double, 3> shown = colour(triangle, corners, weights);
  channels_.insert(channels_.end(), shown.begin(), shown.end());
}

namespace {

// A checksum of all that the samples depend on.
std::uint64_t checksum(const FineMesh& mesh, double spacing) {
  std::uint64_t sum = common::add_array_to_fnv(common::fnv_of_nothing, std::span<const double>(mesh.origin));
  sum = common::add_array_to_fnv(sum, std::span<const double>(&spacing, 1));
  for (const std::span<const float> array : {mesh.positions, mesh.normals, mesh.texcoords})
    sum = common::add_array_to_fnv(sum, array);
  for (const std::span<const std::uint8_t> array : {mesh.colours, mesh.tints})
    sum = common::add_array_to_fnv(sum, array);
  for (const std::span<const std::uint32_t> array : {mesh.triangles, mesh.triangle_pictures})
    sum = common::add_array_to_fnv(sum, array);
  for (const Picture& picture : mesh.pictures) {
    sum = common::add_array_to_fnv(sum, std::span<const unsigned>(&picture.width, 1));
    sum = common::add_array_to_fnv(sum, picture.pixels);
  }
  return common::add_array_to_fnv(sum, mesh.picture_wraps);
}

}  // namespace

stream::Source mesh_source(const FineMesh& mesh, double spacing) {
  require(mesh, spacing);
  const std::string name = "the fine mesh";
  return {.name = name,
          .open = [mesh, spacing, name](const stream::ReadOptions&) -> std::unique_ptr<stream::PointReader> {
            return std::make_unique<MeshPoints>(mesh, spacing, name);
          },
          .identity = fmt::format("mesh {:016x}", checksum(mesh, spacing))};
}

}  // namespace glark::maps
