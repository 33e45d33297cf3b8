// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/sorted_records.h"

#include <glark/point_stream.h>

#include <algorithm>
#include <cstring>
#include <queue>
#include <utility>

namespace glark::stream {
namespace {

constexpr std::size_t least_capacity = 64;   // records in memory
constexpr std::size_t write_size = 1 << 18;  // bytes
constexpr std::size_t most_read = 1 << 20, key_size = sizeof(std::uint64_t);

}  // namespace

// Reads a run, some records at a time.
class SortedRecords::RunReader {
 public:
  RunReader(const TemporaryFile& file, const Run& run, std::size_t record_size, std::size_t records)
      : file_(file), at_(run.begin), end_(run.end), stride_(key_size + record_size), most_(records * stride_) {
    next();
  }
  bool at_end() const { return buffer_.empty(); }
  std::uint64_t key() const { return key_; }
  std::span<const char> record() const { return std::span(buffer_).subspan(place_ + key_size, stride_ - key_size); }
  void next() {
    if (!buffer_.empty()) place_ += stride_;
    if (place_ >= buffer_.size()) {
      buffer_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(most_, end_ - at_)));
      file_.read(at_, buffer_);
      at_ += buffer_.size();
      place_ = 0;
    }
    if (!buffer_.empty()) std::memcpy(&key_, &buffer_[place_], key_size);
  }

 private:
  const TemporaryFile& file_;
  std::uint64_t at_, end_;
  std::size_t stride_, most_, place_ = 0;
  std::vector<char> buffer_;
  std::uint64_t key_ = 0;
};

SortedRecords::SortedRecords(std::size_t record_size, std::size_t memory, std::filesystem::path folder)
    : size_(record_size),
      memory_(memory),
      capacity_(std::max(least_capacity, (memory - std::min(memory, write_size)) / (record_size + sizeof(Keyed)))),
      folder_(std::move(folder)) {}

void SortedRecords::add(std::uint64_t key, std::span<const char> record) {
  if (keys_.size() == capacity_) write_run();
  if (keys_.capacity() < capacity_ && keys_.size() == keys_.capacity()) {  // doubled, but not beyond the memory
    const std::size_t next = std::min(capacity_, std::max(least_capacity, 2 * keys_.size()));
    keys_.reserve(next);
    records_.reserve(next * size_);
  }
  keys_.push_back({key, keys_.size()});
  records_.insert(records_.end(), record.begin(), record.end());
}

void SortedRecords::sort_by_keys() {
  std::sort(keys_.begin(), keys_.end(),
            [](const Keyed& a, const Keyed& b) { return a.key < b.key || (a.key == b.key && a.place < b.place); });
}

void SortedRecords::write_run() {
  if (!file_) file_ = std::make_unique<TemporaryFile>(folder_);
  sort_by_keys();
  const std::uint64_t begin = file_->size();
  std::vector<char> bytes;
  bytes.reserve(write_size + key_size + size_);
  for (const Keyed& keyed : keys_) {
    const char* key = reinterpret_cast<const char*>(&keyed.key);
    bytes.insert(bytes.end(), key, key + key_size);
    const std::span<const char> record = record_at(keyed.place);
    bytes.insert(bytes.end(), record.begin(), record.end());
    if (bytes.size() < write_size) continue;
    file_->append(bytes);
    bytes.clear();
  }
  file_->append(bytes);
  runs_.push_back({begin, file_->size()});
  keys_.clear();
  records_.clear();
}

void SortedRecords::each(const std::function<void(std::uint64_t key, std::span<const char> record)>& take) {
  if (runs_.empty()) {
    sort_by_keys();
    for (const Keyed& keyed : keys_) take(keyed.key, record_at(keyed.place));
  } else {
    if (!keys_.empty()) write_run();
    std::vector<Keyed>().swap(keys_);
    std::vector<char>().swap(records_);
    merge(take);
  }
  std::vector<Keyed>().swap(keys_);
  std::vector<char>().swap(records_);
  runs_.clear();
  file_.reset();
}

void SortedRecords::merge(const std::function<void(std::uint64_t key, std::span<const char> record)>& take) {
  const std::size_t share = std::min(memory_ / runs_.size(), most_read), records = share / (key_size + size_);
  if (records == 0)
    throw Error(Element::option, 0,
                "glark-stream: the memory is too small to sort so many samples on the disk; give more of it");
  std::vector<std::unique_ptr<RunReader>> readers;
  for (const Run& run : runs_) readers.push_back(std::make_unique<RunReader>(*file_, run, size_, records));
  using Next = std::pair<std::uint64_t, std::size_t>;  // the key, the run
  std::priority_queue<Next, std::vector<Next>, std::greater<>> next;
  for (std::size_t run = 0; run < readers.size(); ++run) next.emplace(readers[run]->key(), run);
  while (!next.empty()) {
    const auto [key, run] = next.top();
    next.pop();
    RunReader& reader = *readers[run];
    take(key, reader.record());
    reader.next();
    if (!reader.at_end()) next.emplace(reader.key(), run);
  }
}

}  // namespace glark::stream
