// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The pattern pool that a context draws from: built by glARKinit, or before the first refined draw.
#pragma once

#include <algorithm>
#include <cstdint>

#include "glark/core/pattern/gpu_pool.h"
#include "glark/core/state/environment.h"

namespace glark::pattern {

class PoolInUse {
 public:
  explicit PoolInUse(const core::Environment& environment) : env_(environment) {}

  // False without memory: the old pool is then kept. Wrap in an ErrorScope.
  bool build(unsigned max_level) {
    const core::Quiet quiet = env_.state.quiet();
    if (!pool_.build(env_.gl, max_level, core::geomorphs(env_.options, env_.ark))) {
      return false;
    }
    ++number_;
    return true;
  }
  // Builds the pool that the state asks for, unless it is there. False without memory: then it is not tried again.
  bool ensure() {
    const unsigned level = wanted_level();
    const bool fits =
        pool_.built() && pool_.max_level() >= level && pool_.nested() == core::geomorphs(env_.options, env_.ark);
    if (!fits && level != failed_level_) {
      core::ErrorScope errors(env_.errors);
      if (build(level)) {
        return true;
      }
      failed_level_ = level;
    }
    return fits;
  }

  const GpuPool& pool() const { return pool_; }
  std::uint64_t number() const { return number_; }  // counts the pools that were built; 0: no pool yet
  void release() { pool_.release(env_.gl); }

 private:
  // The level of transparent refinement may change between two frames. glARKinit says the level for its calls.
  unsigned wanted_level() const {
    const unsigned built = pool_.built() ? pool_.max_level() : 0;
    const bool asks = env_.options.transparent || !pool_.built();
    return asks ? std::max({env_.options.max_level, env_.options.level, built}) : built;
  }

  const core::Environment& env_;
  GpuPool pool_;
  std::uint64_t number_ = 0;
  unsigned failed_level_ = core::max_supported_level + 1;  // there was no memory for it
};

}  // namespace glark::pattern
