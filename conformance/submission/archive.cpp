// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/submission/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

namespace glark::conformance {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30U;  // for one file: no report is larger

using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

[[noreturn]] void fail(const std::string& path, archive* handle) {
  const char* const why = archive_error_string(handle);
  throw std::runtime_error(path + ": " + (why != nullptr ? why : "no archive"));
}

// A temporary file, so that an archive appears whole or not at all.
class Unfinished {
 public:
  explicit Unfinished(std::string path) : path_(std::move(path)) {}
  ~Unfinished() {
    std::error_code gone_already;
    std::filesystem::remove(path_, gone_already);
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

void check_inside(const std::string& name) {
  const std::filesystem::path path(name);
  if (name.empty() || path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end())
    throw std::runtime_error('"' + name + "\" leads out of the report's folder");
}

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("no SHA-256");
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    constexpr char digits[] = "0123456789abcdef";
    text += digits[digest[i] >> 4U];
    text += digits[digest[i] & 15U];
  }
  return text;
}

void write_archive(const Files& files, const std::string& path) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
    throw std::runtime_error(path + ": not a plain file, so the archive cannot replace it");
  const Unfinished unfinished(path + ".part");
  const std::unique_ptr<archive, decltype(&archive_write_free)> out(archive_write_new(), archive_write_free);
  archive_write_add_filter_gzip(out.get());
  archive_write_set_filter_option(out.get(), "gzip", "timestamp", nullptr);
  archive_write_set_format_ustar(out.get());
  if (archive_write_open_filename(out.get(), unfinished.path().c_str()) != ARCHIVE_OK)
    fail(unfinished.path(), out.get());
  for (const auto& [name, bytes] : files) {
    const Entry entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    if (archive_write_header(out.get(), entry.get()) != ARCHIVE_OK ||
        archive_write_data(out.get(), bytes.data(), bytes.size()) != static_cast<la_ssize_t>(bytes.size()))
      fail(unfinished.path(), out.get());
  }
  if (archive_write_close(out.get()) != ARCHIVE_OK) fail(unfinished.path(), out.get());
  std::filesystem::rename(unfinished.path(), path);
}

Files read_archive(const std::string& path) {
  const std::unique_ptr<archive, decltype(&archive_read_free)> in(archive_read_new(), archive_read_free);
  archive_read_support_filter_gzip(in.get());
  archive_read_support_format_tar(in.get());
  if (archive_read_open_filename(in.get(), path.c_str(), 65536) != ARCHIVE_OK) fail(path, in.get());
  Files files;
  for (archive_entry* entry = nullptr;;) {
    const int status = archive_read_next_header(in.get(), &entry);
    if (status == ARCHIVE_EOF) return files;
    if (status != ARCHIVE_OK) fail(path, in.get());
    const char* const pathname = archive_entry_pathname(entry);
    const std::string name = pathname != nullptr ? pathname : "";
    check_inside(name);
    if (archive_entry_filetype(entry) != AE_IFREG) throw std::runtime_error(path + ": " + name + " is no plain file");
    const la_int64_t size = archive_entry_size(entry);
    if (size < 0 || static_cast<std::size_t>(size) > most_bytes)
      throw std::runtime_error(path + ": " + name + " is too large");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (archive_read_data(in.get(), bytes.data(), bytes.size()) != static_cast<la_ssize_t>(bytes.size()))
      fail(path, in.get());
    if (!files.emplace(name, std::move(bytes)).second) throw std::runtime_error(path + ": " + name + " is there twice");
  }
}

}  // namespace glark::conformance
