// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/history/history.h"

#include <cassert>
#include <cerrno>
#include <cstring>

namespace glark::edit {
namespace {

[[noreturn]] void fail_with_steps(const std::filesystem::path& folder, const std::string& what) {
  const int error = errno;
  throw Error(Element::file, 0,
              folder.string() + ": the file of steps to undo " + what + ": " + std::strerror(error) + "; " +
                  (error == ENOSPC || error == EDQUOT ? "make room on the disk" : "use a folder that can be written"));
}

}  // namespace

History::History(const std::filesystem::path& folder)
    : folder_(folder.empty() ? std::filesystem::temp_directory_path() : folder), file_(folder_) {
  if (file_.descriptor() < 0) fail_with_steps(folder_, "cannot be made");
}

void History::add(std::span<const char> change) {
  const std::uint64_t begin = done_ == 0 ? 0 : records_[done_ - 1].begin + records_[done_ - 1].size;
  // The changes that were undone are overwritten.
  records_.resize(done_);
  write({begin, change.size()}, change);
  records_.push_back({begin, change.size()});
  ++done_;
}

std::vector<char> History::last_done() const {
  assert(done_ > 0);
  return read(records_[done_ - 1]);
}

std::vector<char> History::first_undone() const {
  assert(done_ < records_.size());
  return read(records_[done_]);
}

void History::undo(std::span<const char> change) {
  assert(done_ > 0 && change.size() == records_[done_ - 1].size);
  write(records_[done_ - 1], change);
  --done_;
}

void History::redo(std::span<const char> change) {
  assert(done_ < records_.size() && change.size() == records_[done_].size);
  write(records_[done_], change);
  ++done_;
}

std::vector<char> History::read(const Record& record) const {
  std::vector<char> bytes(record.size);
  if (!common::read_at(file_.descriptor(), record.begin, bytes)) fail_with_steps(folder_, "cannot be read");
  return bytes;
}

void History::write(const Record& record, std::span<const char> bytes) {
  if (!common::write_at(file_.descriptor(), record.begin, bytes)) fail_with_steps(folder_, "cannot be written");
}

}  // namespace glark::edit
