// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <new>
#include <numeric>

namespace glark::stream {

std::string problem_of(const std::function<void()>& step) {
  try {
    step();
  } catch (const std::bad_alloc&) {
    return "the memory is too small for this file; use more ranks with fewer on each machine";
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

void require_no_problem(Ranks& ranks, const std::string& problem) {
  const std::vector<std::uint64_t> sizes = share(ranks, problem.size());
  const auto failed = std::find_if(sizes.begin(), sizes.end(), [](std::uint64_t size) { return size > 0; });
  if (failed == sizes.end()) return;
  const auto rank = static_cast<std::size_t>(failed - sizes.begin());
  std::vector<char> text(problem.begin(), problem.end());
  broadcast(ranks, text, rank);
  const std::string who = ranks.size() > 1 ? fmt::format(" (rank {} of {})", rank, ranks.size()) : "";
  throw RanksError(std::string(text.begin(), text.end()) + who);
}

void together(Ranks& ranks, const std::function<void()>& step) { require_no_problem(ranks, problem_of(step)); }

void require_same(Ranks& ranks, std::uint64_t number, const std::string& file) {
  const std::vector<std::uint64_t> numbers = share(ranks, number);
  if (std::all_of(numbers.begin(), numbers.end(), [&](std::uint64_t other) { return other == numbers[0]; })) return;
  throw RanksError(file + ": is not the same file for all ranks; put it on a file system that all of them share");
}

void broadcast(Ranks& ranks, std::vector<char>& bytes, std::size_t from) {
  const std::size_t size = ranks.size(), place = (ranks.rank() + size - from) % size;
  const std::uint64_t count = share(ranks, bytes.size())[from];
  bytes.resize(static_cast<std::size_t>(count));
  if (count == 0) return;
  const auto rank_at = [&](std::size_t other) { return (other + from) % size; };
  for (std::size_t have = 1; have < size; have *= 2) {  // the places below have the bytes
    if (place < have && place + have < size) ranks.send_receive(rank_at(place + have), bytes, Ranks::nobody, {});
    if (place >= have && place < 2 * have) ranks.send_receive(Ranks::nobody, {}, rank_at(place - have), bytes);
  }
}

void gather(Ranks& ranks, std::span<const char> bytes,
            const std::function<void(std::size_t rank, std::span<const char> bytes)>& take) {
  const std::vector<std::uint64_t> sizes = share(ranks, bytes.size());
  if (ranks.rank() != 0) {
    if (!bytes.empty()) ranks.send_receive(0, bytes, Ranks::nobody, {});
    return;
  }
  take(0, bytes);
  std::vector<char> received;
  for (std::size_t rank = 1; rank < ranks.size(); ++rank) {
    received.resize(static_cast<std::size_t>(sizes[rank]));
    if (!received.empty()) ranks.send_receive(Ranks::nobody, {}, rank, received);
    take(rank, received);
  }
}

void add_up(Ranks& ranks, std::vector<std::uint64_t>& numbers) {
  std::vector<std::uint64_t> received(numbers.size());
  for (std::size_t step = 1; step < ranks.size(); step *= 2) {
    const std::size_t rank = ranks.rank(), part = rank % (2 * step);
    if (part == step)
      ranks.send_receive(rank - step, bytes_of(std::span<const std::uint64_t>(numbers)), Ranks::nobody, {});
    if (part != 0 || rank + step >= ranks.size()) continue;
    ranks.send_receive(Ranks::nobody, {}, rank + step, bytes_of(received));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] += received[i];
  }
}

std::vector<std::uint64_t> share(Ranks& ranks, std::uint64_t number) {
  return ranks.exchange(std::vector<std::uint64_t>(ranks.size(), number));
}

std::uint64_t sum(Ranks& ranks, std::uint64_t number) {
  const std::vector<std::uint64_t> numbers = share(ranks, number);
  return std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0});
}

std::uint64_t greatest(Ranks& ranks, std::uint64_t number) {
  const std::vector<std::uint64_t> numbers = share(ranks, number);
  return *std::max_element(numbers.begin(), numbers.end());
}

double least(Ranks& ranks, double number) {
  for (const std::uint64_t bits : share(ranks, std::bit_cast<std::uint64_t>(number)))
    number = std::min(number, std::bit_cast<double>(bits));
  return number;
}

double greatest(Ranks& ranks, double number) { return -least(ranks, -number); }

}  // namespace glark::stream
