// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/pool_in_use.h"

#include <algorithm>

namespace glark::pattern {

bool PoolInUse::build(unsigned max_level) {
  const core::Quiet quiet = env_.state.quiet();
  if (!pool_.build(env_.gl, max_level, core::geomorphs(env_.options, env_.ark))) {
    return false;
  }
  ++number_;
  return true;
}

bool PoolInUse::ensure() {
  if (pool_.built() && pool_.nested() == core::geomorphs(env_.options, env_.ark)) {
    return true;
  }
  if (failed_) {
    return false;
  }
  core::ErrorScope errors(env_.errors);
  failed_ = !build(pool_.built() ? pool_.max_level() : std::max(env_.options.max_level, env_.options.level));
  return !failed_;
}

}  // namespace glark::pattern
