// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Loops over many elements, by the caller alone or shared with others.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace glark::qas {

class Workers {
 public:
  // threads: at most; 0: as many as the machine has.
  explicit Workers(unsigned threads) {
    if (threads == 1) return;
    const int most = tbb::info::default_concurrency();  // TBB complains of more
    arena_ = std::make_unique<tbb::task_arena>(
        threads == 0 ? most : std::min(most, static_cast<int>(std::min(threads, 1024U))));
    arena_->initialize();
  }

  // body(begin, end) over all of 0 .. count, in pieces of `grain` at least.
  template <typename Body>
  void each(std::size_t count, const Body& body, std::size_t grain = 2048) const {
    if (!arena_ || count <= grain) {
      if (count > 0) body(std::size_t{0}, count);
      return;
    }
    arena_->execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, grain),
          [&](const auto& range) { body(range.begin(), range.end()); }, tbb::static_partitioner());
    });
  }

 private:
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace glark::qas
