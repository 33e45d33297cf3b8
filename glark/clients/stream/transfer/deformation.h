// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The deformation of a point by the samples around it: projected barycentric coordinates.
// Source: Boubekeur 2007, ch. 4.4.2.
#pragma once

#include <array>
#include <span>

#include "glark/clients/stream/samples/samples.h"

namespace glark::stream {

// Three samples around a point, as even and as near as possible. Each chosen sample excludes a cone about its direction
// from the point, with an apex angle of 120 degrees; halves of it if too few samples are left.
// Returns false if no three samples span a triangle.
bool choose_triangle(const Samples& samples, const common::Vector3f& point, std::span<const Neighbour> neighbours,
                     std::array<std::uint32_t, 3>& triangle);

struct Deformed {
  common::Vector3f position;  // relative to the origin of the sampling
  common::Vector3f normal;    // of unit length; zero stays zero
};

Deformed deform(const Samples& samples, const common::Vector3f& point, const common::Vector3f& normal,
                std::span<const Neighbour> neighbours);

}  // namespace glark::stream
