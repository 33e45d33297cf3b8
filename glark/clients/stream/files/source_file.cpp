// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/source_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <glark/stream.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "glark/clients/stream/files/names.h"

namespace glark::stream {
namespace {

[[noreturn]] void fail_to_read(const std::string& file, const std::string& problem) {
  throw Error(Element::file, 0, file + ": " + problem);
}

}  // namespace

SourceFile::SourceFile(const std::filesystem::path& file) : name_(file.string()) {
  require_name(file, "an input");
  if (file == "-")
    fail_to_read(name_,
                 "standard input can be read only once, and this takes several passes; write it to a disk first");
  descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail_to_read(name_, std::string("cannot be read: ") + std::strerror(errno) + "; check the name");
  struct stat status {};
  if (fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(descriptor_);
    fail_to_read(name_, "is not a regular file, and several passes need one; write it to a disk first");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

SourceFile::~SourceFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

SourceFile::SourceFile(SourceFile&& other) noexcept
    : name_(std::move(other.name_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

FileState SourceFile::state() const {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0) fail_to_read(name_, std::string("cannot be read: ") + std::strerror(errno));
  return {static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

void SourceFile::require_unchanged(const FileState& before) const {
  const FileState now = state();
  if (now == before) return;
  fail_to_read(
      name_, fmt::format("the file changed while it was read: it had {} bytes, now {}; start again when nothing writes "
                         "to it",
                         before.size, now.size));
}

void SourceFile::read(std::uint64_t offset, std::span<char> to) const {
  for (std::size_t done = 0; done < to.size();) {
    const ssize_t got = pread(descriptor_, to.data() + done, to.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      fail_to_read(name_, fmt::format("reading at byte {} failed: {}; check the disk or copy the file", offset + done,
                                      std::strerror(errno)));
    if (got == 0)
      fail_to_read(name_,
                   fmt::format("the file ends at byte {}, in the middle of its points; it is cut off or was changed, "
                               "get it again",
                               offset + done));
    done += static_cast<std::size_t>(got);
  }
}

void SourceFile::will_read(std::uint64_t offset, std::uint64_t size) const {
  posix_fadvise(descriptor_, static_cast<off_t>(offset), static_cast<off_t>(size), POSIX_FADV_WILLNEED);
}

}  // namespace glark::stream
