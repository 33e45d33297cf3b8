// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/temporary_file.h"

#include <fcntl.h>
#include <glark/stream.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace glark::stream {
namespace {

[[noreturn]] void fail_in(const std::string& folder, const std::string& what) {
  const int error = errno;
  throw Error(Element::file, 0,
              folder + ": a temporary file " + what + ": " + std::strerror(error) + "; " +
                  (error == ENOSPC || error == EDQUOT ? "make room on the disk, or use a folder on another one"
                                                      : "use a folder that can be written"));
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& folder)
    : folder_(folder.empty() ? "." : folder.string()),
      nameless_(std::in_place, folder),
      descriptor_(nameless_->descriptor()) {
  if (descriptor_ < 0) fail_in(folder_, "cannot be made");
}

TemporaryFile::TemporaryFile(const KeptFile& file)
    : folder_(file.path.parent_path().string()),
      descriptor_(open(file.path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600)) {
  if (descriptor_ < 0) fail_in(folder_, "cannot be made");
}

void TemporaryFile::continue_at(std::uint64_t size) {
  struct stat status {};
  if (fstat(descriptor_, &status) != 0 || static_cast<std::uint64_t>(status.st_size) < size)
    throw Error(Element::file, 0, folder_ + ": a file of the work is shorter than it was; start without resume");
  end_ = size;
}

TemporaryFile::~TemporaryFile() {
  if (!nameless_ && descriptor_ >= 0) close(descriptor_);
}

std::uint64_t TemporaryFile::append(std::span<const char> bytes) {
  std::uint64_t begin = 0;
  {
    const std::lock_guard lock(mutex_);
    begin = end_;
    end_ += bytes.size();
  }
  write(begin, bytes);
  return begin;
}

void TemporaryFile::write(std::uint64_t offset, std::span<const char> bytes) {
  if (!common::write_at(descriptor_, offset, bytes)) fail_in(folder_, "cannot be written");
}

void TemporaryFile::flush() {
  if (fdatasync(descriptor_) != 0) fail_in(folder_, "cannot be written");
}

void TemporaryFile::read(std::uint64_t offset, std::span<char> bytes) const {
  if (!common::read_at(descriptor_, offset, bytes)) fail_in(folder_, "cannot be read");
}

}  // namespace glark::stream
