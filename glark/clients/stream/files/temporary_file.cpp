// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/temporary_file.h"

#include <fcntl.h>
#include <glark/stream.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

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

TemporaryFile::TemporaryFile(const std::filesystem::path& folder) : folder_(folder.empty() ? "." : folder.string()) {
  descriptor_ = open(folder_.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor_ < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {
    std::string name = folder_ + "/.glark-XXXXXX";
    descriptor_ = mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ >= 0) unlink(name.c_str());
  }
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
  if (descriptor_ >= 0) close(descriptor_);
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
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_in(folder_, "cannot be written");
    done += static_cast<std::size_t>(count);
  }
}

void TemporaryFile::read(std::uint64_t offset, std::span<char> bytes) const {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) errno = EIO;
    if (count <= 0) fail_in(folder_, "cannot be read");
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace glark::stream
