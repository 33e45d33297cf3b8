// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The loops that the client libraries share visit each element once, for any number of threads.
#include "glark/clients/common/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace glark::common::test {
namespace {

template <typename Loop>
void expect_each_once(const Loop& loop) {
  for (const unsigned threads : {1U, 2U, 0U}) {
    const Workers workers(threads);
    EXPECT_LE(workers.count(), threads == 0 ? 1024U : threads);
    for (const std::size_t count : {0U, 1U, 9U, 10U, 11U, 5000U}) {
      std::vector<std::atomic<int>> visits(count);
      loop(workers, count, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const std::atomic<int>& visit : visits) EXPECT_EQ(visit, 1) << count << " with " << threads;
    }
  }
}

TEST(Workers, LoopsVisitEachElementOnce) {
  expect_each_once([](const Workers& workers, std::size_t count, const auto& body) { workers.each(count, 10, body); });
  expect_each_once(
      [](const Workers& workers, std::size_t count, const auto& body) { workers.evenly(count, body, 10); });
  expect_each_once(
      [](const Workers& workers, std::size_t count, const auto& body) { workers.in_pieces(count, 10, body); });
}

TEST(Workers, PiecesAreTheSameForAnyNumberOfThreads) {
  const auto begins = [](unsigned threads) {
    std::mutex mutex;
    std::set<std::size_t> found;
    Workers(threads).in_pieces(95, 10, [&](std::size_t begin, std::size_t end) {
      EXPECT_EQ(end, std::min<std::size_t>(95, begin + 10));
      const std::lock_guard lock(mutex);
      found.insert(begin);
    });
    return found;
  };
  EXPECT_EQ(begins(1), (std::set<std::size_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}));
  EXPECT_EQ(begins(2), begins(1));
  EXPECT_EQ(begins(0), begins(1));
}

TEST(Workers, OneThreadIsTheCallers) {
  const Workers alone(1);
  const auto check = [caller = std::this_thread::get_id()](auto...) { EXPECT_EQ(std::this_thread::get_id(), caller); };
  alone.each(100, 1, check);
  alone.evenly(100, check, 1);
  alone.in_pieces(100, 1, check);
  alone.both(check, check);
}

TEST(Workers, BothAreDone) {
  for (const unsigned threads : {1U, 2U}) {
    int first = 0, second = 0;
    Workers(threads).both([&] { first = 1; }, [&] { second = 2; });
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 2);
  }
}

}  // namespace
}  // namespace glark::common::test
