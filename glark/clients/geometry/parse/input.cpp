// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/parse/input.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "glark/clients/common/descriptor.h"
#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 20;
constexpr std::size_t longest_word = 256;

bool is_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

class PlainFile {
 public:
  PlainFile(std::string name, int descriptor)
      : name_(std::move(name)), file_(std::make_shared<common::Descriptor>(descriptor)) {}

  std::size_t operator()(std::span<char> wanted) const {
    std::size_t have = 0;
    while (have < wanted.size()) {
      const ssize_t got = read(file_->number(), wanted.data() + have, wanted.size() - have);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0)
        throw Error(name_ + ": reading failed: " + std::strerror(errno) + "; check the disk or copy the file");
      if (got == 0) break;
      have += static_cast<std::size_t>(got);
    }
    return have;
  }

 private:
  std::string name_;
  std::shared_ptr<common::Descriptor> file_;
};

class Decompressed {
 public:
  Decompressed(std::string name, PlainFile file, std::span<const char> first)
      : name_(std::move(name)),
        file_(std::move(file)),
        stream_(ZSTD_createDStream(), ZSTD_freeDStream),
        packed_(std::max(ZSTD_DStreamInSize(), first.size())),
        in_{packed_.data(), first.size(), 0} {
    std::copy(first.begin(), first.end(), packed_.begin());
  }

  std::size_t operator()(std::span<char> wanted) {
    in_.src = packed_.data();  // the object may have moved
    ZSTD_outBuffer out{wanted.data(), wanted.size(), 0};
    while (out.pos < out.size) {
      if (in_.pos == in_.size) {
        in_ = {packed_.data(), file_(packed_), 0};
        if (in_.size == 0 && !frame_ended_) throw Error(name_ + ": the zstd data is cut off; get the file again");
        if (in_.size == 0) break;
      }
      const std::size_t state = ZSTD_decompressStream(stream_.get(), &out, &in_);
      if (ZSTD_isError(state) != 0)
        throw Error(name_ + ": the zstd data is damaged (" + ZSTD_getErrorName(state) + "); get the file again");
      frame_ended_ = state == 0;
    }
    return out.pos;
  }

 private:
  std::string name_;
  PlainFile file_;
  std::shared_ptr<ZSTD_DStream> stream_;
  std::vector<char> packed_;
  ZSTD_inBuffer in_;
  bool frame_ended_ = false;
};

}  // namespace

Input::Input(std::string name, Fill fill, std::optional<std::uint64_t> size)
    : name_(std::move(name)),
      fill_(std::move(fill)),
      size_(size),
      buffer_(static_cast<std::size_t>(std::min<std::uint64_t>(block_size, size.value_or(block_size) + 1))) {}

std::optional<std::uint64_t> Input::remaining() const {
  if (!size_) return std::nullopt;
  return *size_ > taken_ ? *size_ - taken_ : 0;
}

std::size_t Input::ensure(std::size_t count) {
  if (end_ - begin_ >= count || at_end_) return std::min(end_ - begin_, count);
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
            buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < count) buffer_.resize(count);
  const std::size_t got = fill_(std::span(buffer_).subspan(end_));
  at_end_ = got < buffer_.size() - end_;
  end_ += got;
  if (report_) report_(taken_);
  return std::min(end_, count);
}

std::span<const char> Input::take(std::size_t count) {
  const std::size_t have = ensure(count);
  const std::span<const char> taken(buffer_.data() + begin_, have);
  begin_ += have;
  taken_ += have;
  return taken;
}

bool Input::line(std::string_view& text) {
  std::size_t searched = 0;
  for (;;) {
    const char* from = buffer_.data() + begin_;
    const std::size_t have = end_ - begin_;
    if (const void* found = have > searched ? std::memchr(from + searched, '\n', have - searched) : nullptr) {
      const std::size_t length = static_cast<std::size_t>(static_cast<const char*>(found) - from);
      text = {take(length + 1).data(), length};
      break;
    }
    if (at_end_ && have == 0) return false;
    if (at_end_) {
      text = {take(have).data(), have};
      break;
    }
    if (have >= block_size)
      throw Error(
          fmt::format("{}: a line of more than {} bytes; this is not text, check the format", name_, block_size));
    searched = have;
    ensure(std::min(have + 1, block_size));
  }
  if (text.ends_with('\r')) text.remove_suffix(1);
  return true;
}

std::string_view Input::word() {
  for (;;) {
    while (begin_ < end_ && is_space(buffer_[begin_])) ++begin_, ++taken_;
    if (begin_ < end_ || ensure(1) == 0) break;
  }
  const std::size_t have = ensure(longest_word);
  std::size_t length = 0;
  while (length < have && !is_space(buffer_[begin_ + length])) ++length;
  if (length == longest_word)
    throw Error(
        fmt::format("{}: a word of more than {} letters where a number is due; the header says text, the contents do "
                    "not look like it",
                    name_, longest_word));
  const std::span<const char> taken = take(length);
  return {taken.data(), taken.size()};
}

Input open_input(const std::filesystem::path& path) {
  const std::string name = path.string();
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw Error(name + ": cannot be read: " + std::strerror(errno) + "; check the name");
  PlainFile file(name, descriptor);
  struct stat status {};
  if (fstat(descriptor, &status) != 0) throw Error(name + ": cannot be read: " + std::strerror(errno));
  if (S_ISDIR(status.st_mode)) throw Error(name + ": is a folder; name a file in it");
  auto first = std::make_shared<std::array<char, 4>>();
  const std::size_t have = file(*first);
  if (have == 0) throw Error(name + ": the file is empty; get it again or export it again");
  constexpr std::array<char, 4> magic{'\x28', '\xb5', '\x2f', '\xfd'};
  if (have == magic.size() && *first == magic) return {name, Decompressed(name, std::move(file), *first), std::nullopt};
  std::optional<std::uint64_t> size;
  if (S_ISREG(status.st_mode)) size = static_cast<std::uint64_t>(status.st_size);
  const auto fill = [file = std::move(file), first, have, given = std::size_t{0}](std::span<char> wanted) mutable {
    const std::size_t begun = std::min(have - given, wanted.size());
    std::copy_n(first->begin() + static_cast<std::ptrdiff_t>(given), begun, wanted.begin());
    given += begun;
    return begun + file(wanted.subspan(begun));
  };
  return {name, fill, size};
}

Input memory_input(std::string name, std::span<const char> bytes) {
  const std::uint64_t size = bytes.size();
  const auto fill = [bytes](std::span<char> wanted) mutable {
    const std::size_t count = std::min(bytes.size(), wanted.size());
    std::copy_n(bytes.begin(), count, wanted.begin());
    bytes = bytes.subspan(count);
    return count;
  };
  return {std::move(name), fill, size};
}

}  // namespace glark::geometry
