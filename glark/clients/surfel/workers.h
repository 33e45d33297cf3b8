// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Loops and recursions, by the caller alone or shared with others. What they compute does not depend on who does it.
#pragma once

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace glark::surfel {

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

  // body(begin, end) over all of 0 .. count, in pieces of about `grain`.
  template <typename Body>
  void each(std::size_t count, std::size_t grain, const Body& body) const {
    if (!arena_ || count <= grain) {
      for (std::size_t begin = 0; begin < count; begin += grain) body(begin, std::min(count, begin + grain));
      return;
    }
    arena_->execute([&] {
      tbb::parallel_for(std::size_t{0}, (count + grain - 1) / grain,
                        [&](std::size_t piece) { body(piece * grain, std::min(count, (piece + 1) * grain)); });
    });
  }

  template <typename A, typename B>
  void both(const A& a, const B& b) const {
    if (!arena_) {
      a();
      b();
      return;
    }
    arena_->execute([&] { tbb::parallel_invoke(a, b); });
  }

 private:
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace glark::surfel
