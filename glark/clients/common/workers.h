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

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace glark::common {

// ThreadSanitizer does not see that oneTBB, which is not compiled for it, hands what was done before a loop to its pieces and what they did
// to what comes after it.
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
    share([&](const auto& piece) {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                        [&](const auto& range) { piece([&] { body(range.begin(), range.end()); }); });
    });
  }

  // One piece for each worker: the least to do beside the work, where all elements take the same time.
  template <typename Body>
  void evenly(std::size_t count, const Body& body, std::size_t grain = 2048) const {
    if (is_alone(count, grain, body)) return;
    share([&](const auto& piece) {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, grain),
          [&](const auto& range) { piece([&] { body(range.begin(), range.end()); }); }, tbb::static_partitioner());
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
  // `loop` gets what its pieces have to be run by.
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

}  // namespace glark::common
