// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Records of one size, sorted by a number. Those that do not fit into the memory go through a temporary file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "glark/clients/stream/files/temporary_file.h"

namespace glark::stream {

// Based on: Knuth, The Art of Computer Programming 3, ch. 5.4.1, multiway merging: sorted runs, and one merge of all.
class SortedRecords {
 public:
  // memory: bytes for records that are being sorted or merged. folder: for the temporary file.
  SortedRecords(std::size_t record_size, std::size_t memory, std::filesystem::path folder);

  // Throws Error for a full disk.
  void add(std::uint64_t key, std::span<const char> record);
  // Gives all records, the least key first; records with the same key in the order in which they were added. The records
  // are gone then. Throws Error if the memory is too small for so many records, and if a disk cannot be read.
  void each(const std::function<void(std::uint64_t key, std::span<const char> record)>& take);

 private:
  struct Keyed {
    std::uint64_t key;
    std::size_t place;
  };
  struct Run {
    std::uint64_t begin, end;  // bytes of the file
  };
  class RunReader;

  void sort_by_keys();
  void write_run();
  void merge(const std::function<void(std::uint64_t key, std::span<const char> record)>& take);
  std::span<const char> record_at(std::size_t place) const { return {&records_[place * size_], size_}; }

  std::size_t size_, memory_, capacity_;
  std::filesystem::path folder_;
  std::vector<Keyed> keys_;    // of the records in memory
  std::vector<char> records_;  // in memory
  std::vector<Run> runs_;
  std::unique_ptr<TemporaryFile> file_;  // of the runs: each record follows its key
};

}  // namespace glark::stream
