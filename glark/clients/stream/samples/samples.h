// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::stream {

// Samples before and after an edit. Positions are relative to an origin that the user knows.
struct Samples {
  std::vector<common::Vector3f> before, after;
  std::vector<common::Vector3f> normals, normals_after;  // of unit length, or zero
  std::vector<float> values;                             // [channels * samples], after the edit
  std::vector<std::uint8_t> is_edited;                   // [channels * samples]: the value was another one before

  std::size_t size() const { return before.size(); }
  std::size_t channels() const { return before.empty() ? 0 : values.size() / before.size(); }
  void resize(std::size_t count, std::size_t channels);
  // Copies a sample to the place `to`. channels: those of both.
  void copy(const Samples& from, std::size_t place, std::size_t to, std::size_t channels);
};

// A sample near a point, and its weight.
struct Neighbour {
  std::uint32_t index = 0;
  float weight = 0;
};

}  // namespace glark::stream
