// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
// Source: A. Barr, Global and Local Deformations of Solid Primitives, 1984. Barr bends about an axis of the coordinates;
// here two places and a direction tell the part and the plane.
#include "glark/clients/edit/brush/motion.h"
#include "glark/clients/edit/brush/rotation.h"

namespace glark::edit {
namespace {

[[noreturn]] void fail_without_line(const char* name) {
  throw Error(Element::operation, 0,
              std::string(name) + ": both ends of the line are at one place; write two places that differ");
}

// A field over all samples beyond the plane through `from`; move(d, t) is the new place of the difference d from `from`,
// which is t away along the line.
template <class Move>
Field field_beyond(const Vector& from, const Vector3d& along, const Samples& now, const Move& move) {
  Field field;
  const Vector3d begin = common::to_vector(from);
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Vector3d d = now.position(i) - begin;
    const double t = common::dot(d, along);
    if (!(t > 0)) continue;
    field.samples.push_back(static_cast<std::uint32_t>(i));
    field.weights.push_back(1);
    field.by.push_back(move(d, t) - d);
  }
  return field;
}

}  // namespace

Field field_of(const Bend& bend, const Samples& now) {
  const Vector3d line = common::to_vector(bend.to) - common::to_vector(bend.from), along = common::unit(line);
  if (common::is_zero(along)) fail_without_line("bend");
  const Vector3d wanted = common::unit(common::to_vector(bend.towards));
  const Vector3d across = wanted - along * common::dot(wanted, along), towards = common::unit(across);
  if (!(common::length(across) > 1e-9))
    throw Error(Element::operation, 0,
                "bend: the direction of the arc's centre is that of the line; write one that points to its side");
  const double length = common::length(line), angle = radians(bend.angle);
  if (angle == 0) return {};
  const double radius = length / angle;
  return field_beyond(bend.from, along, now, [&](const Vector3d& d, double t) {
    const double height = common::dot(d, towards);
    const Vector3d rest = d - along * t - towards * height;
    const double on_arc = std::min(t, length), beyond = t - on_arc, phi = angle * on_arc / length;
    const double s = std::sin(phi), c = std::cos(phi);
    return rest + along * ((radius - height) * s + beyond * c) + towards * (radius * (1 - c) + height * c + beyond * s);
  });
}

Field field_of(const Twist& twist, const Samples& now) {
  const Vector3d line = common::to_vector(twist.to) - common::to_vector(twist.from), along = common::unit(line);
  if (common::is_zero(along)) fail_without_line("twist");
  const double length = common::length(line), angle = radians(twist.angle);
  return field_beyond(twist.from, along, now, [&](const Vector3d& d, double t) {
    return rotated(d, along, angle * std::min(1.0, t / length));
  });
}

}  // namespace glark::edit
