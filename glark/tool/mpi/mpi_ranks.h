// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Ranks whose messages MPI carries. No other file includes mpi.h.
#pragma once

#include "glark/clients/stream/ranks/ranks.h"

namespace glark::tool {

// The processes that mpirun has started. One object in a program, as long as anything is sent.
class MpiRanks final : public stream::Ranks {
 public:
  MpiRanks(int& argc, char**& argv);
  ~MpiRanks() override;

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return size_; }
  // The cores of this machine, shared evenly by the ranks that run on it; at least 1.
  unsigned threads() const { return threads_; }
  // Ends all ranks now: this one has given up where the others wait for it.
  [[noreturn]] void abort(int status);

 private:
  std::vector<std::uint64_t> do_exchange(std::span<const std::uint64_t> numbers) override;
  void do_send_receive(std::size_t to, std::span<const char> bytes, std::size_t from,
                       std::span<char> received) override;

  std::size_t rank_ = 0, size_ = 1;
  unsigned threads_ = 1;
};

}  // namespace glark::tool
