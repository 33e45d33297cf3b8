// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Loops and recursions, by the caller alone or shared with others. What they compute must not depend on who does it.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace glark {

class Workers {
 public:
  // threads: at most; 0: as many as the machine has.
  explicit Workers(unsigned threads) {
    const int most = tbb::info::default_concurrency();  // TBB complains of more
    count_ = threads == 0 ? most : std::min(most, static_cast<int>(std::min(threads, 1024U)));
    if (count_ == 1) return;
    arena_ = std::make_unique<tbb::task_arena>(count_);
    arena_->initialize();
  }

  std::size_t count() const { return static_cast<std::size_t>(count_); }

  // body(begin, end) over all of 0 .. count, in pieces of `grain` at least, fewer for whoever is slow.
  template <typename Body>
  void each(std::size_t count, std::size_t grain, const Body& body) const {
    if (is_alone(count, grain, body)) return;
    arena_->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                        [&](const auto& range) { body(range.begin(), range.end()); });
    });
  }

  // One piece for each worker: the least to do beside the work, where all elements take the same time.
  template <typename Body>
  void evenly(std::size_t count, const Body& body, std::size_t grain = 2048) const {
    if (is_alone(count, grain, body)) return;
    arena_->execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, grain),
          [&](const auto& range) { body(range.begin(), range.end()); }, tbb::static_partitioner());
    });
  }

  // Pieces that begin at multiples of `grain`, for any number of workers: a piece may have a place for what it finds.
  template <typename Body>
  void in_pieces(std::size_t count, std::size_t grain, const Body& body) const {
    const auto piece = [&](std::size_t i) { body(i * grain, std::min(count, (i + 1) * grain)); };
    const std::size_t pieces = (count + grain - 1) / grain;
    if (!arena_ || pieces < 2) {
      for (std::size_t i = 0; i < pieces; ++i) piece(i);
      return;
    }
    arena_->execute([&] { tbb::parallel_for(std::size_t{0}, pieces, piece); });
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
  // True when the caller has done it all.
  template <typename Body>
  bool is_alone(std::size_t count, std::size_t grain, const Body& body) const {
    if (arena_ && count > grain) return false;
    if (count > 0) body(std::size_t{0}, count);
    return true;
  }

  int count_ = 1;
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace glark
