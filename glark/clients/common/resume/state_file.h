// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Numbers and arrays in a file with a checksum: the state of a run that may be killed. They go to the file and come from
// it piece by piece, so that a state takes no memory.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace glark::common {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

class StateWriter {
 public:
  explicit StateWriter(std::FILE* file) : file_(file) {}

  template <class Value>
  void put(const Value& value) {
    put_all(std::span(&value, 1), false);
  }
  template <class Value>
  void put_all(std::span<const Value> values, bool with_count = true) {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (with_count) put(std::uint64_t{values.size()});
    write(values.data(), values.size_bytes());
  }
  // Adds the checksum. Returns false if something was not written; errno tells the cause.
  bool finish();

 private:
  void write(const void* bytes, std::size_t size);

  std::FILE* file_;
  std::uint64_t sum_ = 0;
  bool is_good_ = true;
};

// Reads what StateWriter has written. The functions return false where the bytes do not fit.
class StateReader {
 public:
  // Checks the checksum first: a damaged file has nothing to read.
  explicit StateReader(std::FILE* file);

  template <class Value>
  bool get(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return read(&value, sizeof(Value));
  }
  template <class Value>
  bool get_all(std::vector<Value>& values) {
    std::uint64_t count = 0;
    if (!get(count) || count > left_ / sizeof(Value)) return false;
    values.resize(static_cast<std::size_t>(count));
    return read(values.data(), values.size() * sizeof(Value));
  }
  bool at_end() const { return left_ == 0; }

 private:
  bool read(void* bytes, std::size_t size);

  std::FILE* file_;
  std::uint64_t left_ = 0;
};

}  // namespace glark::common
