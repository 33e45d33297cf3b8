// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sets of connected samples. Each sample is reversed or not, relative to the first sample of its set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::vstree {

// Number i stands for sample i as it is, and number count + i for the reversed sample. So each set has a mirror image.
class SignedParts {
 public:
  explicit SignedParts(std::size_t count) : count_(static_cast<std::uint32_t>(count)), sets_(2 * count) {}

  struct Place {
    std::uint32_t root;  // the first sample of the set
    bool reversed;
  };
  Place find(std::uint32_t i) {
    const std::uint32_t as_it_is = sets_.find(i), reversed = sets_.find(i + count_);
    return as_it_is < reversed ? Place{as_it_is, false} : Place{reversed, true};
  }

  // Connects two samples. `reversed`: one is reversed relative to the other. Returns false and changes nothing if they
  // are connected already.
  bool connect(std::uint32_t a, std::uint32_t b, bool reversed) {
    const std::uint32_t root = sets_.find(a);
    if (root == sets_.find(b) || root == sets_.find(b + count_)) return false;
    sets_.join(a, reversed ? b + count_ : b);
    sets_.join(a + count_, reversed ? b : b + count_);
    return true;
  }

 private:
  std::uint32_t count_;
  common::DisjointSets sets_;
};

}  // namespace glark::vstree
