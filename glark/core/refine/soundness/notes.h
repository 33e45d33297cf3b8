// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The inputs of the vertex stage, and the reasons why values jump or have no meaning between vertices.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glark/core/refine/soundness/value.h"

namespace glark::refine {

// A place in the application's shaders.
struct Place {
  std::size_t unit = 0;
  int line = 0;
};

class Notes {
 public:
  explicit Notes(std::size_t units) : units_(units) {}

  // The bit of that input in Value::inputs. Inputs from number 64 on share a bit.
  std::uint64_t input(const std::string& name);
  // `value`, if it varies at all, made at least as bad as `variation`. The reason is "CONSTRUCT of INPUTS" at `place`.
  Value worsened(Value value, Variation variation, const Place& place, std::string_view construct);
  // The inputs that a value depends on.
  std::set<std::string> inputs_of(const Value& value) const;
  // "line 12: floor() of 'vertexId'"; empty if the value has no reason.
  std::string explain(const Value& value) const;

 private:
  struct Reason {
    Place place;
    std::string construct;
    std::uint64_t inputs = 0;
  };

  std::size_t units_;
  std::vector<std::string> inputs_;
  std::vector<Reason> reasons_;
};

}  // namespace glark::refine
