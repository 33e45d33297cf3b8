// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/brush/ball.h"
#include "glark/clients/edit/brush/free_region.h"
#include "glark/clients/edit/brush/motion.h"
#include "glark/clients/edit/brush/rotation.h"

namespace glark::edit {
namespace {

// A part of a rigid motion. Positions could not be interpolated: a surface that turns would shrink.
Vector3d part_of(const Deform& deform, const Vector3d& p, double part) {
  const Vector3d centre = common::to_vector(deform.handle.centre);
  const Vector3d axis = common::unit(common::to_vector(deform.axis));
  return centre + rotated(p - centre, axis, part * radians(deform.angle)) + part * common::to_vector(deform.by);
}

// Parts of the motion of each operation: [operations][samples]. Handles have the whole motion of their own operation;
// a sample of several handles has an even part of each.
std::vector<std::vector<double>> parts_of(std::span<const Deform> deforms, const Samples& now,
                                          std::vector<std::uint32_t>& handles) {
  std::vector<std::vector<double>> parts(deforms.size(), std::vector<double>(now.size()));
  std::vector<int> counts(now.size());
  for (std::size_t k = 0; k < deforms.size(); ++k)
    for (const std::uint32_t i : samples_in(deforms[k].handle, now).samples) {
      parts[k][i] = 1;
      if (++counts[i] == 1) handles.push_back(i);
    }
  for (std::vector<double>& each : parts)
    for (const std::uint32_t i : handles) each[i] /= counts[i];
  return parts;
}

std::vector<std::uint32_t> free_samples(std::span<const Deform> deforms, const Samples& now,
                                        const std::vector<std::uint32_t>& handles) {
  std::vector<bool> is_free(now.size());
  for (const Deform& deform : deforms)
    for (const std::uint32_t i : samples_in(deform.free, now).samples) is_free[i] = true;
  for (const std::uint32_t i : handles) is_free[i] = false;
  std::vector<std::uint32_t> free;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (is_free[i]) free.push_back(static_cast<std::uint32_t>(i));
  return free;
}

}  // namespace

Motion motion_of(std::span<const Deform> deforms, const Shape& shape) {
  for (const Deform& deform : deforms)
    if (deform.angle != 0 && deform.axis == Vector{})
      throw Error(Element::operation, 0, "deform: the axis is 0 0 0; write the direction of the axis");
  std::vector<std::uint32_t> handles;
  std::vector<std::vector<double>> parts = parts_of(deforms, shape.now, handles);
  const std::vector<std::uint32_t> free = free_samples(deforms, shape.now, handles);
  fair_values(shape.graph, shape.now, free, parts);
  Motion motion;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Vector3d p = shape.now.position(i);
    Vector3d by;
    bool moves = false;
    for (std::size_t k = 0; k < deforms.size(); ++k) {
      if (parts[k][i] == 0) continue;
      by += part_of(deforms[k], p, parts[k][i]) - p;
      moves = true;
    }
    if (!moves) continue;
    motion.samples.push_back(static_cast<std::uint32_t>(i));
    motion.positions.push_back(p + by);
  }
  return motion;
}

}  // namespace glark::edit
