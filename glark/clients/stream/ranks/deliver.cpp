// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/deliver.h"

namespace glark::stream {

std::string deliver(Ranks& ranks, std::span<const std::span<const char>> to_each, const TakeBytes& take) {
  const std::size_t size = ranks.size(), rank = ranks.rank();
  std::vector<std::uint64_t> sizes;
  for (const std::span<const char>& bytes : to_each) sizes.push_back(bytes.size());
  const std::vector<std::uint64_t> coming = ranks.exchange(sizes);
  std::string problem;
  const auto take_some = [&](std::size_t from, std::span<const char> bytes) {
    if (problem.empty() && !bytes.empty()) problem = problem_of([&] { take(from, bytes); });
  };
  take_some(rank, to_each[rank]);
  std::vector<char> received;
  for (std::size_t k = 1; k < size; ++k) {
    const std::size_t to = (rank + k) % size, from = (rank + size - k) % size;
    received.resize(static_cast<std::size_t>(coming[from]));
    ranks.send_receive(sizes[to] > 0 ? to : Ranks::nobody, to_each[to], coming[from] > 0 ? from : Ranks::nobody,
                       received);
    take_some(from, received);
  }
  return problem;
}

}  // namespace glark::stream
