// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Steps that all ranks finish, or none: an error of one rank becomes the error of all, so that no rank waits for one
// that has given up.
#pragma once

#include <glark/point_stream.h>

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "glark/clients/stream/ranks/ranks.h"

namespace glark::stream {

// The error of a step of some rank. All ranks throw it at the same place, so they may all end without waiting.
class RanksError : public Error {
 public:
  explicit RanksError(const std::string& what) : Error(Element::file, 0, what) {}
};

// Runs a step of this rank, then waits for the steps of all others. The step exchanges nothing. Throws RanksError on all
// ranks if a step has thrown anything derived from std::exception: the text of the lowest such rank.
void together(Ranks& ranks, const std::function<void()>& step);

// The same in two halves, for steps that end with an exchange: the text of what the step has thrown, or an empty one.
std::string problem_of(const std::function<void()>& step);
// Throws RanksError on all ranks if some rank has a problem.
void require_no_problem(Ranks& ranks, const std::string& problem);

// Throws RanksError if the number, which tells about a file, is not the same on all ranks.
void require_same(Ranks& ranks, std::uint64_t number, const std::string& file);

// Gives what a rank has to all ranks. The others' bytes are replaced. Based on: binomial trees, log2(ranks) messages in a
// row.
void broadcast(Ranks& ranks, std::vector<char>& bytes, std::size_t from = 0);

// Gives the bytes of all ranks to rank 0, one rank after the other. take(rank, bytes) is called there, for rank 0, too.
void gather(Ranks& ranks, std::span<const char> bytes,
            const std::function<void(std::size_t rank, std::span<const char> bytes)>& take);

// The same number from this rank to all ranks. Returns those of all ranks.
std::vector<std::uint64_t> share(Ranks& ranks, std::uint64_t number);
std::uint64_t sum(Ranks& ranks, std::uint64_t number);
std::uint64_t greatest(Ranks& ranks, std::uint64_t number);
double least(Ranks& ranks, double number);
double greatest(Ranks& ranks, double number);

template <class Value>
std::span<const char> bytes_of(std::span<const Value> values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}
template <class Value>
std::span<char> bytes_of(std::vector<Value>& values) {
  static_assert(std::is_trivially_copyable_v<Value>);
  return {reinterpret_cast<char*>(values.data()), values.size() * sizeof(Value)};
}

// Gives the values of rank 0 to all ranks.
template <class Value>
void broadcast_values(Ranks& ranks, std::vector<Value>& values) {
  const std::span<const char> own = bytes_of(std::span<const Value>(values));
  std::vector<char> bytes;
  if (ranks.rank() == 0) bytes.assign(own.begin(), own.end());
  broadcast(ranks, bytes);
  values.resize(bytes.size() / sizeof(Value));
  std::copy(bytes.begin(), bytes.end(), bytes_of(values).begin());
}

// Adds the numbers of all ranks, one by one. Rank 0 has the sums; the others have parts of them.
void add_up(Ranks& ranks, std::vector<std::uint64_t>& numbers);

}  // namespace glark::stream
