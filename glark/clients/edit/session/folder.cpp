// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/session/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <glark/edit.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "glark/clients/edit/session/names.h"

namespace glark::edit {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker = "session";
constexpr std::string_view title = "glark edit session 1\n";

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw Error(Element::file, 0, file.string() + ": " + what);
}

[[noreturn]] void fail_with_number(const fs::path& file, const std::string& what) {
  const int error = errno;
  fail(file, what + ": " + std::strerror(error) + "; use a session folder that can be written");
}

// Differs if the scan has changed.
std::string identity_of(const fs::path& scan) {
  struct stat status {};
  if (stat(scan.c_str(), &status) != 0)
    fail(scan, std::string("cannot be read: ") + std::strerror(errno) + "; check the name of the scan");
  if (!S_ISREG(status.st_mode)) fail(scan, "is no regular file; write the scan to a file first");
  return fmt::format("{}scan of {} bytes, changed at {}.{:09}\n", title, status.st_size, status.st_mtim.tv_sec,
                     status.st_mtim.tv_nsec);
}

std::string contents_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void synchronise(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_good = descriptor >= 0 && fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) close(descriptor);
  errno = error;
  if (!is_good) fail_with_number(file, "cannot be brought onto the disk");
}

}  // namespace

Folder::Folder(fs::path folder, const fs::path& scan) : folder_(std::move(folder)) {
  const std::string identity = identity_of(scan);
  std::error_code error;
  if (fs::exists(path(marker), error)) {
    if (!check(identity, scan)) make(identity);
  } else if (!fs::exists(folder_, error) || (fs::is_directory(folder_, error) && fs::is_empty(folder_, error))) {
    make(identity);
  } else {
    fail(folder_,
         "is there, and is no session of glark edit; nothing in it is changed: give another folder by --session");
  }
  lock();
}

Folder::~Folder() {
  if (lock_ >= 0) close(lock_);
}

void Folder::make(const std::string& identity) {
  if (mkdir(folder_.c_str(), 0777) != 0 && errno != EEXIST) fail_with_number(folder_, "cannot be made");
  const fs::path file = path(marker);
  const int descriptor = open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) fail_with_number(file, "cannot be made");
  const bool is_good = write(descriptor, identity.data(), identity.size()) == static_cast<ssize_t>(identity.size());
  close(descriptor);
  if (!is_good) fail_with_number(file, "cannot be written");
  keep(marker);
}

bool Folder::check(const std::string& identity, const fs::path& scan) const {
  const std::string kept = contents_of(path(marker));
  if (identity.starts_with(kept)) return kept == identity;
  // Without a sampling there is no operation yet, so that nothing is lost.
  if (kept.starts_with(title) && !fs::exists(path(cells_file))) return false;
  if (!kept.starts_with(title)) fail(path(marker), "is no file of glark edit; give another folder by --session");
  fail(scan,
       fmt::format("is not the scan of the session {}, or has changed since; restore it, or begin another session "
                   "by --session",
                   folder_.string()));
}

void Folder::lock() {
  lock_ = open(path(marker).c_str(), O_RDONLY | O_CLOEXEC);
  if (lock_ < 0) fail_with_number(path(marker), "cannot be opened");
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  const bool is_used = errno == EWOULDBLOCK;
  close(lock_);
  lock_ = -1;
  if (is_used) fail(folder_, "is used by another glark edit; close that one first");
  fail_with_number(path(marker), "cannot be locked");
}

void Folder::require_same_scan(const fs::path& scan) const {
  if (contents_of(path(marker)) != identity_of(scan))
    fail(scan,
         fmt::format("has changed since the session {} began; restore it, or begin another session", folder_.string()));
}

void Folder::require_outside(const fs::path& file) const {
  std::error_code error;
  const fs::path inside = fs::weakly_canonical(fs::absolute(folder_), error);
  for (fs::path at = fs::weakly_canonical(fs::absolute(file), error); at.has_relative_path(); at = at.parent_path())
    if (at == inside) fail(file, "lies in the folder of the session, which belongs to the session; save it elsewhere");
}

void Folder::keep(const std::string& name) const {
  synchronise(path(name));
  synchronise(folder_);
}

}  // namespace glark::edit
