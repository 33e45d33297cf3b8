// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Ranks that are threads of this process, so that sanitizers and debuggers see all of them.
#pragma once

#include <condition_variable>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "glark/clients/stream/ranks/ranks.h"

namespace glark::stream {

// Keeps what a rank has sent until another one takes it.
class Mail {
 public:
  void send(std::size_t from, std::size_t to, std::span<const char> bytes) {
    const std::lock_guard lock(mutex_);
    letters_[{from, to}].emplace_back(bytes.begin(), bytes.end());
    has_more_.notify_all();
  }
  std::vector<char> take(std::size_t from, std::size_t to) {
    std::unique_lock lock(mutex_);
    std::deque<std::vector<char>>& letters = letters_[{from, to}];
    has_more_.wait(lock, [&] { return !letters.empty(); });
    std::vector<char> bytes = std::move(letters.front());
    letters.pop_front();
    return bytes;
  }

 private:
  std::mutex mutex_;
  std::condition_variable has_more_;
  std::map<std::pair<std::size_t, std::size_t>, std::deque<std::vector<char>>> letters_;
};

class ThreadRank final : public Ranks {
 public:
  ThreadRank(Mail& mail, std::size_t rank, std::size_t size) : mail_(mail), rank_(rank), size_(size) {}
  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return size_; }

 private:
  std::vector<std::uint64_t> do_exchange(std::span<const std::uint64_t> numbers) override {
    std::vector<std::uint64_t> received(size_);
    for (std::size_t to = 0; to < size_; ++to)
      mail_.send(rank_, to, {reinterpret_cast<const char*>(&numbers[to]), sizeof(std::uint64_t)});
    for (std::size_t from = 0; from < size_; ++from)
      std::memcpy(&received[from], mail_.take(from, rank_).data(), sizeof(std::uint64_t));
    return received;
  }
  void do_send_receive(std::size_t to, std::span<const char> bytes, std::size_t from,
                       std::span<char> received) override {
    if (to != nobody) mail_.send(rank_, to, bytes);
    if (from == nobody) return;
    const std::vector<char> letter = mail_.take(from, rank_);
    std::copy(letter.begin(), letter.end(), received.begin());
  }

  Mail& mail_;
  std::size_t rank_, size_;
};

// Calls work(ranks) for each rank, in a thread of its own.
inline void run_ranks(std::size_t size, const std::function<void(Ranks& ranks)>& work) {
  Mail mail;
  std::vector<std::thread> threads;
  for (std::size_t rank = 0; rank < size; ++rank)
    threads.emplace_back([&mail, &work, rank, size] {
      ThreadRank ranks(mail, rank, size);
      work(ranks);
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace glark::stream
