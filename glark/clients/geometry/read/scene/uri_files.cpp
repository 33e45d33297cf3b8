// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/scene/uri_files.h"

#include <charconv>

namespace glark::geometry {

std::string decoded_uri(const std::string& uri) {
  std::string bytes;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    const char* const digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
      bytes += static_cast<char>(value);
      i += 2;
    } else {
      bytes += uri[i];
    }
  }
  return bytes;
}

std::filesystem::path file_of_uri(const std::filesystem::path& folder, const std::string& uri) {
  std::error_code error;
  const std::filesystem::path plain = folder / uri, decoded = folder / decoded_uri(uri);
  return std::filesystem::is_regular_file(plain, error) ? plain : decoded;
}

std::string UriFiles::existing(const std::string& file) const {
  if (!file.starts_with(folder_)) return file;
  const std::size_t begin = file.find_first_not_of('/', folder_.size());
  return begin == std::string::npos ? file : file_of_uri(folder_, file.substr(begin)).string();
}

bool UriFiles::Exists(const char* file) const { return DefaultIOSystem::Exists(existing(file).c_str()); }

Assimp::IOStream* UriFiles::Open(const char* file, const char* mode) {
  return DefaultIOSystem::Open(existing(file).c_str(), mode);
}

}  // namespace glark::geometry
