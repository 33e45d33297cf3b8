// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Files that belong together: none of them appears until all can.
#pragma once

#include <glark/maps.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/write/output_file.h"

namespace glark::maps {

// Its functions throw Error for files that cannot be written.
class FileSet {
 public:
  void add(const std::filesystem::path& file, std::string_view bytes) {
    with_errors([&] { files_.emplace_back(std::make_unique<geometry::OutputFile>(file))->write(bytes); });
  }
  void commit() {
    with_errors([&] {
      for (const auto& file : files_) file->prepare();
      for (const auto& file : files_) file->commit();
    });
  }

 private:
  template <class Step>
  static void with_errors(const Step& step) {
    try {
      step();
    } catch (const geometry::Error& error) {
      throw Error(Element::file, 0, error.what());
    }
  }

  std::vector<std::unique_ptr<geometry::OutputFile>> files_;
};

}  // namespace glark::maps
