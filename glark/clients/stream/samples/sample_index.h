// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A k-d tree of positions.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::stream {

class SampleIndex {
 public:
  // The positions must stay where they are.
  explicit SampleIndex(const std::vector<common::Vector3f>& positions);
  ~SampleIndex();

  std::size_t size() const;
  // Finds the `count` nearest positions, or all if there are fewer: their indices and squared distances, the nearest
  // first. Several threads may call it.
  void nearest(const common::Vector3f& point, std::size_t count, std::vector<std::uint32_t>& indices,
               std::vector<float>& squares) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace glark::stream
