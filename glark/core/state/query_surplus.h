// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles that our captures added to the results of the application's queries.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "glark/gl/types.h"

namespace glark::core {

class QuerySurplus {
 public:
  // Modulo 2^64: a negative number takes away.
  void add(GLuint query, std::int64_t triangles) { surplus_[query] += static_cast<std::uint64_t>(triangles); }
  void forget(GLuint query) { surplus_.erase(query); }
  // Null: nothing was added to that query.
  const std::uint64_t* find(GLuint query) const {
    const auto found = surplus_.find(query);
    return found != surplus_.end() ? &found->second : nullptr;
  }

 private:
  std::unordered_map<GLuint, std::uint64_t> surplus_;
};

}  // namespace glark::core
