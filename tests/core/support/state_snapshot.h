// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// All state values that a context returns.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/core/support/gl.h"

namespace glark::core::test {

class StateSnapshot {
 public:
  // The names that the context accepts: all values of 16 bits are tried once.
  struct Names {
    std::vector<GLenum> floats;
    std::vector<GLenum> integers;
    std::vector<GLenum> enables;
    std::vector<GLenum> pointers;
  };
  static Names find_names();

  static StateSnapshot take(const Names& names);

  // One line for each value that differs; "" if none does. Names in `except` are left out.
  std::string difference(const StateSnapshot& other, const std::vector<std::string>& except = {}) const;
  std::vector<std::string> differing_names(const StateSnapshot& other) const;
  std::size_t size() const { return values_.size(); }

 private:
  void take_indexed();
  void take_vertex_attributes();
  void take_textures();
  void take_queries();
  template <typename Value>
  void store(const std::string& name, const std::vector<Value>& value);

  std::map<std::string, std::string> values_;  // bytes, because NaN is equal to itself here
};

}  // namespace glark::core::test
