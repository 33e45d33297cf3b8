// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/history/history.h"

#include <fcntl.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace glark::edit {
namespace {

[[noreturn]] void fail_with_steps(const std::filesystem::path& folder, const std::string& what) {
  const int error = errno;
  throw Error(Element::file, 0,
              folder.string() + ": the file of steps to undo " + what + ": " + std::strerror(error) + "; " +
                  (error == ENOSPC || error == EDQUOT ? "make room on the disk" : "use a folder that can be written"));
}

// Opens a file without a name.
int open_nameless(const std::string& folder) {
  const int descriptor = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) return descriptor;
  std::string name = folder + "/.glark-XXXXXX";
  const int named = mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) unlink(name.c_str());
  return named;
}

}  // namespace

History::History(const std::filesystem::path& folder)
    : folder_(folder.empty() ? std::filesystem::temp_directory_path() : folder),
      descriptor_(open_nameless(folder_.string())) {
  if (descriptor_ < 0) fail_with_steps(folder_, "cannot be made");
}

History::~History() {
  if (descriptor_ >= 0) close(descriptor_);
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
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t got = pread(descriptor_, &bytes[at], bytes.size() - at, static_cast<off_t>(record.begin + at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail_with_steps(folder_, "cannot be read");
    at += static_cast<std::size_t>(got);
  }
  return bytes;
}

void History::write(const Record& record, std::span<const char> bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t put = pwrite(descriptor_, &bytes[at], bytes.size() - at, static_cast<off_t>(record.begin + at));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) fail_with_steps(folder_, "cannot be written");
    at += static_cast<std::size_t>(put);
  }
}

}  // namespace glark::edit
