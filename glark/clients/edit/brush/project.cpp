// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <optional>

#include "glark/clients/edit/brush/paint.h"
#include "glark/clients/edit/brush/picture.h"
#include "glark/clients/edit/brush/rotation.h"

namespace glark::edit {
namespace {

constexpr double samples_of_a_cell = 8;
constexpr double least_cosine = 0.2;  // between view and normal; limits the depth tolerance on steep surfaces

// A projector. Places in the picture go from 0 to 1, from the left and from the top.
class Projector {
 public:
  Projector(const Project& project, double aspect) : eye_(common::to_vector(project.eye)), aspect_(aspect) {
    forward_ = common::unit(common::to_vector(project.target) - eye_);
    right_ = common::unit(common::cross(forward_, common::unit(common::to_vector(project.up))));
    if (common::is_zero(forward_) || common::is_zero(right_))
      throw Error(Element::operation, 0,
                  "project: the eye is at the target, or looks along the up direction; write another TARGET or UP");
    up_ = common::cross(right_, forward_);
    slope_ = std::tan(radians(project.angle) / 2);
  }

  struct Place {
    double x, y, depth;
  };
  // Returns nothing for a point outside the picture.
  std::optional<Place> place_of(const Vector3d& p) const {
    const Vector3d d = p - eye_;
    const double depth = common::dot(d, forward_), half = depth * slope_;
    if (!(depth > 0)) return std::nullopt;
    const Place place{(common::dot(d, right_) / (half * aspect_) + 1) / 2, (1 - common::dot(d, up_) / half) / 2, depth};
    const bool is_inside = place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1;
    return is_inside ? std::optional(place) : std::nullopt;
  }
  // The cosine between the normal and the direction to the eye; a missing normal faces the eye.
  double cosine(const Vector3d& p, const Vector3d& normal) const {
    return common::is_zero(normal) ? 1 : common::dot(common::unit(eye_ - p), normal);
  }
  // The height of the picture at a depth.
  double height(double depth) const { return 2 * depth * slope_; }

 private:
  Vector3d eye_, forward_, right_, up_;
  double aspect_, slope_ = 1;
};

// The least depth of the samples in each cell of the picture.
class DepthCells {
 public:
  explicit DepthCells(const std::vector<std::optional<Projector::Place>>& places) {
    double count = 0;
    for (const auto& place : places) count += place ? 1 : 0;
    side_ = std::max(1, static_cast<int>(std::sqrt(count / samples_of_a_cell)));
    depths_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_),
                   std::numeric_limits<double>::infinity());
    for (const auto& place : places)
      if (place)
        depths_[cell(column(place->x), column(place->y))] =
            std::min(depths_[cell(column(place->x), column(place->y))], place->depth);
  }

  int side() const { return side_; }
  // In the cell of the place and those around it.
  double least_depth(const Projector::Place& place) const {
    double least = place.depth;
    const int x = column(place.x), y = column(place.y);
    for (int j = std::max(0, y - 1); j <= std::min(side_ - 1, y + 1); ++j)
      for (int i = std::max(0, x - 1); i <= std::min(side_ - 1, x + 1); ++i)
        least = std::min(least, depths_[cell(i, j)]);
    return least;
  }

 private:
  int column(double x) const { return std::min(side_ - 1, static_cast<int>(x * side_)); }
  std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }

  int side_ = 1;
  std::vector<double> depths_;
};

// The colours of the picture at the samples that the projector sees. A mirror reflects the samples, not the projector.
std::vector<std::optional<Colour>> colours_of(const Project& project, const Picture& picture, const Symmetric& mirror,
                                              const Samples& now) {
  const double aspect = picture.width() / picture.height();
  const Projector projector(project, aspect);
  const auto position = [&](std::size_t i) {
    Vector3d p = now.position(i);
    if (mirror.on) p[mirror.axis] = mirror.at + (mirror.at - p[mirror.axis]);
    return p;
  };
  const auto normal = [&](std::size_t i) {
    const Vector3f n = now.normal(i);
    Vector3d shown{n.x, n.y, n.z};
    if (mirror.on) shown[mirror.axis] = -shown[mirror.axis];
    return shown;
  };
  std::vector<std::optional<Projector::Place>> places(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) places[i] = projector.place_of(position(i));
  const DepthCells cells(places);
  std::vector<std::optional<Colour>> colours(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!places[i]) continue;
    const double cosine = projector.cosine(position(i), normal(i));
    const double side = projector.height(places[i]->depth) * std::max(1.0, aspect) / cells.side();
    const bool is_hidden = places[i]->depth > cells.least_depth(*places[i]) + 3 * side / std::max(least_cosine, cosine);
    if (cosine > 0 && !is_hidden)
      colours[i] = picture.at(places[i]->x * picture.width(), places[i]->y * picture.height());
  }
  return colours;
}

}  // namespace

Colouring colouring_of(const Project& project, const Symmetric& mirror, const Samples& now) {
  const Picture picture(project.picture);
  const auto straight = colours_of(project, picture, {}, now);
  auto reflected = straight;
  if (mirror.on) reflected = colours_of(project, picture, mirror, now);
  Colouring colouring;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!straight[i] && !reflected[i]) continue;
    const Colour a = straight[i].value_or(reflected[i].value_or(Colour{})), b = reflected[i].value_or(a);
    colouring.samples.push_back(static_cast<std::uint32_t>(i));
    colouring.colours.push_back(mixed(now.colour(i), mixed(a, b, 0.5), project.strength));
  }
  return colouring;
}

}  // namespace glark::edit
