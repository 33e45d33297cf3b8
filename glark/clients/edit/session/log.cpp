// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/session/log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <glark/edit.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "glark/clients/common/fnv.h"

namespace glark::edit {
namespace {

constexpr std::string_view first_line = "glark edit log 1\n";
constexpr std::size_t checksum_digits = 16;

// It begins with the checksum of the line before.
std::uint64_t checksum_of(std::string_view line, std::uint64_t before) {
  return common::add_to_fnv(before ^ common::fnv_of_nothing, line);
}

[[noreturn]] void fail_in_log(const std::filesystem::path& file, const std::string& what) {
  const int error = errno;
  throw Error(Element::file, 0,
              fmt::format("{}: the log {}: {}; {}", file.string(), what, std::strerror(error),
                          error == ENOSPC || error == EDQUOT ? "make room on the disk, then repeat the operation"
                                                             : "use a session folder that can be written"));
}

std::string contents_of(int descriptor, const std::filesystem::path& file) {
  std::string contents;
  char part[1 << 16];
  for (;;) {
    const ssize_t got = ::read(descriptor, part, sizeof(part));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_in_log(file, "cannot be read");
    if (got == 0) return contents;
    contents.append(part, static_cast<std::size_t>(got));
  }
}

}  // namespace

Log::Log(const std::filesystem::path& file)
    : file_(file), descriptor_(open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail_in_log(file_, "cannot be opened");
  try {
    const std::string contents = contents_of(descriptor_, file_);
    if (first_line.starts_with(contents)) {
      begin();
    } else {
      read(contents);
      if (size_ < contents.size()) cut();
    }
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Log::~Log() { close(descriptor_); }

// A new log, or one whose first line is not complete.
void Log::begin() {
  cut();
  write(first_line);
}

void Log::read(std::string_view contents) {
  if (!contents.starts_with(first_line))
    throw Error(Element::file, 0,
                fmt::format("{}: line 1 is not \"{}\"; this is no log of glark edit", file_.string(),
                            first_line.substr(0, first_line.size() - 1)));
  size_ = first_line.size();
  while (size_ < contents.size()) {
    const std::string_view rest = contents.substr(size_);
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    const std::string_view text = line.substr(std::min(line.size(), checksum_digits + 1));
    const std::uint64_t sum = checksum_of(text, checksum_);
    const bool is_good = end != std::string_view::npos && line.starts_with(fmt::format("{:016x} ", sum));
    if (!is_good && end != std::string_view::npos && end + 1 < rest.size())
      throw Error(Element::file, lines_.size(),
                  fmt::format("{}: line {} is damaged, its checksum is not that of its text; to go on with the {} "
                              "operations before, remove this line and all lines after it",
                              file_.string(), line_number(lines_.size()), lines_.size()));
    if (!is_good) {
      has_dropped_line_ = true;
      return;
    }
    lines_.emplace_back(text);
    checksum_ = sum;
    size_ += end + 1;
  }
}

void Log::append(const std::string& line) {
  const std::uint64_t sum = checksum_of(line, checksum_);
  write(fmt::format("{:016x} {}\n", sum, line));
  checksum_ = sum;
  lines_.push_back(line);
}

void Log::write(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t put = pwrite(descriptor_, &bytes[at], bytes.size() - at, static_cast<off_t>(size_ + at));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) {
      const int error = errno;
      cut();
      errno = error;
      fail_in_log(file_, "cannot be written");
    }
    at += static_cast<std::size_t>(put);
  }
  if (fdatasync(descriptor_) != 0) {
    const int error = errno;
    cut();
    errno = error;
    fail_in_log(file_, "cannot be written");
  }
  size_ += bytes.size();
}

// Cuts off what follows the complete lines.
void Log::cut() {
  if (ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) fail_in_log(file_, "cannot be cut");
}

}  // namespace glark::edit
