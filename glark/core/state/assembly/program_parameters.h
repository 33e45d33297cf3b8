// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Parameters of assembly programs that the application sets by number: four floats each. The hooks keep their values.
// Values that no hook has seen are unknown, and are asked for when they are needed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glark/gl/types.h"

namespace glark::core {

class ProgramParameters {
 public:
  using Value = std::array<GLfloat, 4>;

  // Values are known only within an epoch: an unseen call that may have changed any of them begins a new one.
  void set(std::uint64_t epoch, GLuint first, const GLfloat* values, GLsizei count) {
    enter(epoch);
    if (count <= 0 || first >= most || static_cast<GLuint>(count) > most - first) {
      return;  // GL refuses it, too
    }
    grow(first + static_cast<GLuint>(count));
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
      values_[first + i] = {values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3]};
      known_[first + i] = true;
    }
    ++stamp_;
  }

  // The values of a range. `ask(index, value)` reads one from GL.
  template <typename Ask>
  const GLfloat* read(std::uint64_t epoch, GLuint first, GLuint count, const Ask& ask) {
    enter(epoch);
    grow(first + count);
    for (GLuint i = first; i < first + count; ++i) {
      if (!known_[i]) {
        ask(i, values_[i].data());
        known_[i] = true;
      }
    }
    return values_[first].data();
  }

  // Changes whenever a value may have changed.
  std::uint64_t stamp(std::uint64_t epoch) {
    enter(epoch);
    return stamp_;
  }

 private:
  static constexpr GLuint most = 1 << 16;

  void enter(std::uint64_t epoch) {
    if (epoch_ != epoch) {
      epoch_ = epoch;
      known_.assign(known_.size(), false);
      ++stamp_;
    }
  }
  void grow(std::size_t size) {
    if (size > values_.size()) {
      values_.resize(size);
      known_.resize(size, false);
    }
  }

  std::vector<Value> values_;
  std::vector<bool> known_;
  std::uint64_t epoch_ = 0;
  std::uint64_t stamp_ = 1;
};

}  // namespace glark::core
