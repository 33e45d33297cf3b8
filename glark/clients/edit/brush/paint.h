// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samples that get other colours.
#pragma once

#include "glark/clients/edit/shape/shape.h"

namespace glark::edit {

struct Colouring {
  std::vector<std::uint32_t> samples;  // in ascending order
  std::vector<Colour> colours;
};

Colouring colouring_of(std::span<const Paint> paints, const Samples& now);
// With the mirror, the picture is also painted as the mirror shows it; a sample of both gets the mean.
Colouring colouring_of(const Project& project, const Symmetric& mirror, const Samples& now);

Colour mixed(const Colour& from, const Colour& to, double strength);

}  // namespace glark::edit
