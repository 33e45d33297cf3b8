// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Loops over many elements and over unequal tasks, by the caller alone or shared with others.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace glark::vstree {

class Workers {
 public:
  // threads: at most; 0: as many as the machine has.
  explicit Workers(unsigned threads) {
    const int most = tbb::info::default_concurrency();  // TBB complains of more
    count_ = threads == 0 ? most : std::min(most, static_cast<int>(std::min(threads, 1024U)));
    if (count_ > 1) arena_ = std::make_unique<tbb::task_arena>(count_);
  }

  std::size_t count() const { return static_cast<std::size_t>(count_); }

  // body(begin, end) over all of 0 .. count, in pieces of `grain` at least.
  template <typename Body>
  void each(std::size_t count, std::size_t grain, const Body& body) const {
    if (!arena_ || count <= grain) {
      if (count > 0) body(std::size_t{0}, count);
      return;
    }
    arena_->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                        [&](const auto& range) { body(range.begin(), range.end()); });
    });
  }

 private:
  int count_ = 1;
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace glark::vstree
