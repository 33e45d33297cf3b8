// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Bytes from each rank to each rank.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "glark/clients/stream/ranks/agreement.h"

namespace glark::stream {

using TakeBytes = std::function<void(std::size_t from, std::span<const char> bytes)>;

// Gives to_each[r] to rank r. Calls take(from, bytes) for each rank that has sent some, and for this one. Only the bytes
// of one other rank are in memory at a time. Returns the problem of `take`, or an empty text: it is for
// require_no_problem(), since the others still wait for this rank.
// Based on: pairwise exchange; in step k, each rank sends to the k-th rank after it.
std::string deliver(Ranks& ranks, std::span<const std::span<const char>> to_each, const TakeBytes& take);

// The same for values of one type: values[r] goes to rank r. Throws RanksError on all ranks for a problem of `take`.
template <class Value, class Take>
void deliver_values(Ranks& ranks, const std::vector<std::vector<Value>>& values, const Take& take) {
  std::vector<std::span<const char>> bytes;
  for (const std::vector<Value>& some : values) bytes.push_back(bytes_of(std::span<const Value>(some)));
  require_no_problem(ranks, deliver(ranks, bytes, [&](std::size_t from, std::span<const char> got) {
                       std::vector<Value> taken(got.size() / sizeof(Value));
                       std::copy(got.begin(), got.end(), bytes_of(taken).begin());
                       take(from, std::span<const Value>(taken));
                     }));
}

}  // namespace glark::stream
