// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/ranks.h"

#include <algorithm>
#include <cassert>

namespace glark::stream {

std::vector<std::uint64_t> Ranks::exchange(std::span<const std::uint64_t> numbers) {
  assert(numbers.size() == size());
  traffic_.messages += size() - 1;
  traffic_.bytes += sizeof(std::uint64_t) * (size() - 1);
  return do_exchange(numbers);
}

void Ranks::send_receive(std::size_t to, std::span<const char> bytes, std::size_t from, std::span<char> received) {
  if (to != nobody && to != rank()) {
    ++traffic_.messages;
    traffic_.bytes += bytes.size();
  }
  do_send_receive(to, bytes, from, received);
}

std::vector<std::uint64_t> OneRank::do_exchange(std::span<const std::uint64_t> numbers) {
  return {numbers.begin(), numbers.end()};
}

void OneRank::do_send_receive(std::size_t to, std::span<const char> bytes, std::size_t from, std::span<char> received) {
  if (to == 0 && from == 0) std::copy(bytes.begin(), bytes.end(), received.begin());
}

}  // namespace glark::stream
