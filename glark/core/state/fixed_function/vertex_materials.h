// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glMaterial between glBegin and glEnd, outside of display lists.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "glark/core/state/arrays/current_values.h"
#include "glark/core/state/fixed_function/material_parameters.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

// A call of glMaterial.
struct MaterialChange {
  void (*call)(const gl::Dispatch& gl, const MaterialChange& material);
  GLenum face = 0;
  GLenum name = 0;
  std::array<std::uint32_t, 4> words{};           // values, as bits
  std::array<GLfloat, 4> components{0, 0, 0, 1};  // values, as GL keeps them

  MaterialSet parameters() const { return parameters_set_by(face, name); }
};

class VertexMaterials {
 public:
  // Vertex shaders do not see a change before glEnd: it waits until then.
  void defer(const MaterialChange& change) { deferred_.push_back(change); }
  std::vector<MaterialChange> take_deferred() { return std::exchange(deferred_, {}); }

  // glMaterial set these parameters between the vertices of a primitive. The following primitives capture them.
  void note(MaterialSet parameters) { noted_ |= parameters; }
  // glMaterial has set these parameters after glBegin, before the first vertex: they may vary between the vertices.
  void expect(MaterialSet parameters) { expected_ |= parameters & ~constant_; }
  MaterialSet may_vary() const { return noted_ | expected_; }
  // From now on, parameters that did not vary are not expected to.
  void primitive_ended() {
    constant_ |= expected_ & ~noted_;
    expected_ = 0;
  }

  // The vertices of the open capture carry these parameters in attributes.
  void carry(MaterialSet parameters) { carried_ = parameters; }
  MaterialSet carried() const { return carried_; }
  // The application's value of the attribute that carries a parameter.
  CurrentValue& displaced(int parameter) { return displaced_[static_cast<std::size_t>(parameter)]; }

 private:
  MaterialSet noted_ = 0;
  MaterialSet expected_ = 0;
  MaterialSet constant_ = 0;
  MaterialSet carried_ = 0;
  std::array<CurrentValue, material_parameters> displaced_{};
  std::vector<MaterialChange> deferred_;
};

}  // namespace glark::core
