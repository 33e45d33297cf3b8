// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The files that a glTF file names. A name is a URI, whose bytes may be written as %20. Some programs do not encode names,
// so a file of the name as it is comes first where there is one.
// Specification: RFC 3986, section 2.1
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string>

namespace glark::geometry {

// Returns the bytes that a URI stands for.
std::string decoded_uri(const std::string& uri);

// Returns the file that a URI names in a folder, whether it exists or not.
std::filesystem::path file_of_uri(const std::filesystem::path& folder, const std::string& uri);

// Assimp does not decode the names of buffers.
class UriFiles final : public Assimp::DefaultIOSystem {
 public:
  explicit UriFiles(const std::filesystem::path& folder) : folder_(folder.string()) {}

  bool Exists(const char* file) const override;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

 private:
  std::string existing(const std::string& file) const;

  std::string folder_;
};

}  // namespace glark::geometry
