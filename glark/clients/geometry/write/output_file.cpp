// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/write/output_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>

#include "glark/clients/common/named_files.h"
#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t block_size = std::size_t{1} << 20;
constexpr mode_t permissions = 0666;  // minus the umask

// Follows links, so that they stay links: their target is replaced. A target that does not exist is made.
fs::path resolved(const fs::path& file) {
  constexpr int most_links = 40;  // as in Linux; the system rejects a loop when the file is opened
  if (file.empty()) throw Error("the name of the output is empty; name a file");
  std::error_code error;
  const fs::path full = fs::absolute(file, error);
  fs::path real = fs::weakly_canonical(full, error);
  for (int i = 0; !error && i < most_links && fs::is_symlink(real, error); ++i)
    real = fs::weakly_canonical(real.parent_path() / fs::read_symlink(real, error), error);
  return real.empty() ? full : real;
}

// The name of the temporary file beside `file`. The system limits names, so that of a long one is cut.
fs::path name_aside(const fs::path& file, const std::string& end) {
  return file.parent_path() / ("." + file.filename().string().substr(0, NAME_MAX - 1 - end.size()) + end);
}

// Removes the temporary file that a killed process has left. A process that still runs holds a lock on its file, so the
// file is removed only if this process gets the lock.
void remove_abandoned(const fs::path& name) {
  const int descriptor = open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return;
  struct stat locked {};
  struct stat named {};
  const bool abandoned = flock(descriptor, LOCK_EX | LOCK_NB) == 0 && fstat(descriptor, &locked) == 0 &&
                         S_ISREG(locked.st_mode) && lstat(name.c_str(), &named) == 0 && locked.st_ino == named.st_ino &&
                         locked.st_dev == named.st_dev;
  if (abandoned) unlink(name.c_str());
  close(descriptor);
}

// Tells remove_abandoned() that a process has the file. Some file systems have no locks; nothing is removed there.
void hold(int descriptor) { [[maybe_unused]] const int ignored = flock(descriptor, LOCK_EX | LOCK_NB); }

// Makes a temporary file beside `file`: make(name) returns whether it could. Other names are tried while the name is
// taken (EEXIST). Returns the name, or an empty one with the error in errno.
template <class Make>
fs::path make_aside(const fs::path& file, const Make& make) {
  const fs::path usual = name_aside(file, ".glark-new");
  for (const fs::path& name : {usual, usual, name_aside(file, fmt::format(".{}", getpid()))}) {
    if (make(name)) {
      common::NamedFiles::add(name.string());
      return name;
    }
    if (errno != EEXIST) return {};
    remove_abandoned(name);
    errno = EEXIST;
  }
  return {};
}

// Gives the new file the owner and the mode of the file that it replaces. Only root may give files away; without the
// owner, the bits that run a program as its owner or group are dropped.
void take_over(int descriptor, const struct stat& replaced) {
  bool same_owner = fchown(descriptor, replaced.st_uid, replaced.st_gid) == 0;
  if (!same_owner && fchown(descriptor, static_cast<uid_t>(-1), replaced.st_gid) == 0)
    same_owner = replaced.st_uid == geteuid();
  const mode_t kept = same_owner ? 07777 : 0777;
  [[maybe_unused]] const int ignored = fchmod(descriptor, replaced.st_mode & kept);  // some file systems have no modes
}

}  // namespace

OutputFile::OutputFile(const fs::path& file) : file_(resolved(file)) {
  std::error_code error;
  const fs::file_status status = fs::status(file_, error);
  if (status.type() == fs::file_type::none) {  // a name that is too long, for example
    errno = error.value();
    fail("cannot be written");
  }
  if (fs::is_directory(status)) throw Error(file.string() + ": is a folder; name a file in it");
  direct_ = fs::exists(status) && !fs::is_regular_file(status);
  if (direct_) {
    descriptor_ = open(file_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    // The file has no name at first, so that nothing is left behind if the process is killed.
    descriptor_ = open(file_.parent_path().c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, permissions);
    if (descriptor_ < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {
      aside_ = make_aside(file_, [this](const fs::path& name) {
        descriptor_ = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
        return descriptor_ >= 0;
      });
    }
  }
  if (descriptor_ < 0) fail("cannot be written");
  if (!direct_) hold(descriptor_);
  struct stat replaced {};
  if (!direct_ && stat(file_.c_str(), &replaced) == 0) take_over(descriptor_, replaced);
  buffer_.reserve(block_size);
}

OutputFile::OutputFile(const fs::path& file, const fs::path& partial, std::uint64_t kept)
    : file_(resolved(file)), aside_(partial), stays_(true) {
  std::error_code error;
  if (fs::is_directory(file_, error)) throw Error(file.string() + ": is a folder; name a file in it");
  descriptor_ = open(aside_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, permissions);
  struct stat status {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) fail("cannot be written");
  if (static_cast<std::uint64_t>(status.st_size) < kept)
    throw Error(partial.string() + ": is shorter than it was; start again without resume");
  if (ftruncate(descriptor_, static_cast<off_t>(kept)) != 0 || lseek(descriptor_, 0, SEEK_END) < 0)
    fail("cannot be written");
  struct stat replaced {};
  if (stat(file_.c_str(), &replaced) == 0) take_over(descriptor_, replaced);
  buffer_.reserve(block_size);
}

OutputFile::~OutputFile() {
  if (!aside_.empty() && !stays_) {
    common::NamedFiles::remove(aside_.string());
    unlink(aside_.c_str());  // while its lock is held
  }
  if (descriptor_ >= 0) close(descriptor_);
}

void OutputFile::fail(const std::string& what) const {
  const int error = errno;
  throw Error(file_.string() + ": " + what + ": " + std::strerror(error) + "; " +
              (error == ENOSPC || error == EDQUOT ? "make room on the disk or name a file elsewhere"
                                                  : "name a file in a folder that can be written"));
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() >= block_size) flush();
}

void OutputFile::flush() {
  for (std::size_t done = 0; done < buffer_.size();) {
    const ssize_t count = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("writing failed");
    done += static_cast<std::size_t>(count);
  }
  buffer_.clear();
}

void OutputFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  flush();
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count =
        pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("writing failed");
    done += static_cast<std::size_t>(count);
  }
}

void OutputFile::prepare() {
  flush();
  if (direct_) return;
  if (fsync(descriptor_) != 0) fail("writing failed");
  if (aside_.empty()) {
    const std::string from = fmt::format("/proc/self/fd/{}", descriptor_);
    aside_ = make_aside(file_, [&from](const fs::path& name) {
      return linkat(AT_FDCWD, from.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    });
    if (aside_.empty()) fail("cannot be put in its place");
  }
}

void OutputFile::commit() {
  prepare();
  if (direct_) return;
  common::NamedFiles::remove(aside_.string());  // from now on the name may be that of another process
  if (rename(aside_.c_str(), file_.c_str()) != 0) fail("cannot be put in its place");
  aside_.clear();
}

}  // namespace glark::geometry
