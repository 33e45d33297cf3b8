// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// By how much the results of the application's queries are too high, because they have counted our captures. The number is
// negative for a query that had to begin again, and so has lost what it had counted before.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "glark/gl/types.h"

namespace glark::core {

class QuerySurplus {
 public:
  void add(GLuint query, std::int64_t triangles) { surplus_[query] += triangles; }
  void forget(GLuint query) { surplus_.erase(query); }
  // Null: nothing was added to that query.
  const std::int64_t* find(GLuint query) const {
    const auto found = surplus_.find(query);
    return found != surplus_.end() ? &found->second : nullptr;
  }

 private:
  std::unordered_map<GLuint, std::int64_t> surplus_;
};

}  // namespace glark::core
