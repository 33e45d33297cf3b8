// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A file without a name: nothing is left of it when the process ends, however it ends.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

namespace glark::common {

// Writes all bytes from `offset` on. False: errno tells why.
inline bool write_at(int descriptor, std::uint64_t offset, std::span<const char> bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        pwrite(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno != EINTR) return false;
    done += count < 0 ? 0 : static_cast<std::size_t>(count);
  }
  return true;
}

// Fills all bytes. False: errno tells why; EIO if the file is shorter.
inline bool read_at(int descriptor, std::uint64_t offset, std::span<char> bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        pread(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (count == 0) errno = EIO;
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    done += count < 0 ? 0 : static_cast<std::size_t>(count);
  }
  return true;
}

class NamelessFile {
 public:
  // Empty: the current folder. If the file cannot be made, descriptor() is negative, and errno tells why.
  explicit NamelessFile(const std::filesystem::path& folder) : descriptor_(open_in(folder.empty() ? "." : folder)) {}
  ~NamelessFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  static int open_in(const std::filesystem::path& folder) {
    const int descriptor = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (descriptor >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) return descriptor;
    // Some file systems have no files without names. Then the name is there for a moment.
    std::string name = (folder / ".glark-XXXXXX").string();
    const int named = mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0) unlink(name.c_str());
    return named;
  }

  int descriptor_;
};

}  // namespace glark::common
