// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Several processes that work on one scan together, on one machine or on many. This interface hides who carries their
// messages: MPI in glark/tool/mpi, threads of one process in tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::stream {

// The messages that a rank has sent.
struct Traffic {
  std::uint64_t bytes = 0;
  std::uint64_t messages = 0;
};

// All ranks call the same functions in the same order, in one thread each.
class Ranks {
 public:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);

  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  virtual std::size_t rank() const = 0;  // 0 to size() - 1
  virtual std::size_t size() const = 0;

  // Gives numbers[r] to rank r. Returns what each rank gave to this one: [size()].
  std::vector<std::uint64_t> exchange(std::span<const std::uint64_t> numbers);
  // Sends bytes to one rank, and fills `received` by those of another one, who sends just as many. Either may be nobody.
  void send_receive(std::size_t to, std::span<const char> bytes, std::size_t from, std::span<char> received);

  // The messages that this rank has sent by both functions. A number for another rank counts as a message.
  const Traffic& traffic() const { return traffic_; }

 private:
  virtual std::vector<std::uint64_t> do_exchange(std::span<const std::uint64_t> numbers) = 0;
  virtual void do_send_receive(std::size_t to, std::span<const char> bytes, std::size_t from,
                               std::span<char> received) = 0;

  Traffic traffic_;
};

// A process that works alone.
class OneRank final : public Ranks {
 public:
  std::size_t rank() const override { return 0; }
  std::size_t size() const override { return 1; }

 private:
  std::vector<std::uint64_t> do_exchange(std::span<const std::uint64_t> numbers) override;
  void do_send_receive(std::size_t to, std::span<const char> bytes, std::size_t from,
                       std::span<char> received) override;
};

}  // namespace glark::stream
