// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What one operation changes. A change holds the other values: those after the operation if it is undone, else those
// before. Exchanging them with the values of the shape undoes it or does it again, to the last bit.
#pragma once

#include "glark/clients/edit/shape/shape.h"

namespace glark::edit {

struct Change {
  std::vector<std::uint32_t> moved, turned, painted;  // samples
  std::vector<Vector3d> positions;                    // of `moved`
  std::vector<Vector3f> normals;                      // of `turned`
  std::vector<Colour> colours;                        // of `painted`
  bool has_colours = false;
  // Samples that a refinement adds. They are here in any case, in the shape only while the operation is not undone.
  std::uint64_t first = 0;  // where they begin
  Samples added_before, added;
};

// Exchanges the values. Where samples are added or cut off, the neighbours are found again.
void exchange(Change& change, Shape& shape, const common::Workers& workers);

std::vector<char> bytes_of(const Change& change);
Change change_of(std::span<const char> bytes);

}  // namespace glark::edit
