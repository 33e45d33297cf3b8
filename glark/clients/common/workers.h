// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Parallel loops. The results of a loop must not depend on which thread runs a piece of it.
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

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace glark::common {

// Tells ThreadSanitizer the order: the code before a loop, then the pieces of the loop, then the code after it.
// ThreadSanitizer cannot see this order, because oneTBB is not compiled for it.
class Handover {
 public:
#ifdef __SANITIZE_THREAD__
  void give() { __tsan_release(this); }
  void take() { __tsan_acquire(this); }
#else
  void give() {}
  void take() {}
#endif
};

class Workers {
 public:
  // threads: the maximum number of threads; 0 for as many as the machine has.
  explicit Workers(unsigned threads) {
    const int most = tbb::info::default_concurrency();  // TBB warns about a greater number
    count_ = threads == 0 ? most : std::min(most, static_cast<int>(std::min(threads, 1024U)));
    if (count_ == 1) return;
    arena_ = std::make_unique<tbb::task_arena>(count_);
    arena_->initialize();
  }

  std::size_t count() const { return static_cast<std::size_t>(count_); }

  // Calls body(begin, end) for pieces of 0 .. count, each of at least `grain` elements. Slow threads get fewer pieces.
  template <typename Body>
  void each(std::size_t count, std::size_t grain, const Body& body) const {
    if (is_alone(count, grain, body)) return;
    share([&](const auto& piece) {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                        [&](const auto& range) { piece([&] { body(range.begin(), range.end()); }); });
    });
  }

  // Calls body with one piece for each worker. This has the least overhead where all elements take the same time.
  template <typename Body>
  void evenly(std::size_t count, const Body& body, std::size_t grain = 2048) const {
    if (is_alone(count, grain, body)) return;
    share([&](const auto& piece) {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, grain),
          [&](const auto& range) { piece([&] { body(range.begin(), range.end()); }); }, tbb::static_partitioner());
    });
  }

  // Calls body with pieces that begin at multiples of `grain`, for any number of workers. So piece i may write to
  // element i of an array.
  template <typename Body>
  void in_pieces(std::size_t count, std::size_t grain, const Body& body) const {
    const auto piece = [&](std::size_t i) { body(i * grain, std::min(count, (i + 1) * grain)); };
    const std::size_t pieces = (count + grain - 1) / grain;
    if (!arena_ || pieces < 2) {
      for (std::size_t i = 0; i < pieces; ++i) piece(i);
      return;
    }
    share([&](const auto& shared) {
      tbb::parallel_for(std::size_t{0}, pieces, [&](std::size_t i) { shared([&] { piece(i); }); });
    });
  }

  template <typename A, typename B>
  void both(const A& a, const B& b) const {
    if (!arena_) {
      a();
      b();
      return;
    }
    share([&](const auto& piece) { tbb::parallel_invoke([&] { piece(a); }, [&] { piece(b); }); });
  }

 private:
  // Calls loop(piece). The loop must run each of its pieces by piece(code).
  template <typename Loop>
  void share(const Loop& loop) const {
    Handover before, after;
    before.give();
    arena_->execute([&] {
      loop([&](const auto& piece) {
        before.take();
        piece();
        after.give();
      });
    });
    after.take();
  }

  // Runs a small loop in the calling thread and returns true; otherwise returns false.
  template <typename Body>
  bool is_alone(std::size_t count, std::size_t grain, const Body& body) const {
    if (arena_ && count > grain) return false;
    if (count > 0) body(std::size_t{0}, count);
    return true;
  }

  int count_ = 1;
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace glark::common
