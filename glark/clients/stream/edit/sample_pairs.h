// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A sampling before and after its editing, read side by side, some samples at a time.
#pragma once

#include <glark/point_stream.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "glark/clients/stream/files/temporary_file.h"

namespace glark::stream {

struct SamplePair {
  Points before;
  std::span<const double> positions, channels;  // after the edit
};

class SamplePairs {
 public:
  // Samples correspond by their order, or by a channel "index" of `to`: then the samples of `to` are sorted into a
  // temporary file in the folder. Throws Error for files that cannot be read, if the numbers of samples differ or there
  // are none, or if an index is out of range or repeated.
  SamplePairs(std::filesystem::path from, std::filesystem::path to, const std::filesystem::path& folder);

  const Schema& before() const { return before_; }
  const Schema& after() const { return after_; }
  std::size_t count() const { return count_; }
  // Gives all samples from the first one on, in the order of `from`. Throws Error for coordinates above 1e18, too.
  void each(const std::function<void(const SamplePair& pair)>& take) const;

 private:
  void join(const std::filesystem::path& folder);
  std::unique_ptr<PointReader> open_after() const;

  std::filesystem::path from_, to_;
  Schema before_, after_;
  std::size_t count_ = 0;
  std::unique_ptr<TemporaryFile> joined_;  // [count] positions and channels, by index
};

// Throws Error for a coordinate with which floats cannot compute. first: the index of the first point.
void require_within_floats(std::span<const double> positions, std::uint64_t first, const std::string& file);
// Throws Error for a sampling without samples, and for an edited one with another number.
void require_same_count(const std::filesystem::path& from, std::size_t count, const std::filesystem::path& to,
                        std::size_t count_after);
[[noreturn]] void fail_for_index(const std::string& file, std::size_t vertex, double index, std::size_t count);

}  // namespace glark::stream
