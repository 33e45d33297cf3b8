// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Rules of the user: draws in such a state get such a refinement.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "glark/core/refinement.h"
#include "glark/gl/types.h"

namespace glark::core {

// The state of a draw that rules ask for. The statistics tell draws apart by it.
struct DrawState {
  std::uint64_t program = 0;  // hash of its sources; 0: unknown
  bool fixed_function = false;
  bool depth_test = false;
  bool depth_writes = false;
  GLenum depth_function = 0;
  bool blend = false;
  bool color_writes = true;  // glColorMask
  bool depth_only = false;   // no colour can change: the mask is closed, or the framebuffer has no colour buffer
  std::array<unsigned, 2> viewport{};
  auto operator<=>(const DrawState&) const = default;
};

// A draw matches if it has every value that is set.
struct DrawRule {
  std::optional<std::uint64_t> program = {};
  std::optional<bool> fixed_function = {};
  std::optional<bool> depth_test = {};
  std::optional<bool> depth_writes = {};
  std::optional<GLenum> depth_function = {};
  std::optional<bool> blend = {};
  std::optional<bool> color_writes = {};
  std::optional<bool> depth_only = {};
  std::optional<std::array<unsigned, 2>> viewport = {};

  std::optional<Refinement> refinement = {};  // empty: the draw stays unrefined
  bool operator==(const DrawRule&) const = default;
};

}  // namespace glark::core
