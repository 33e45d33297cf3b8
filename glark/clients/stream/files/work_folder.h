// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The folder for the work in progress, with the errors of this library.
#pragma once

#include <filesystem>
#include <string_view>

#include "glark/clients/common/resume/work_folder.h"

namespace glark::stream {

// Throws Error for `resume` without a folder.
void require_work(const std::filesystem::path& folder, bool resume);

class WorkFolder : public common::WorkFolder {
 public:
  // Throws Error where common::WorkFolder fails.
  WorkFolder(std::filesystem::path folder, std::string_view identity, bool resume);
  // Throws Error if the file would be on another file system than this folder: it could not be put in its place.
  void require_same_disk(const std::filesystem::path& file) const;
};

}  // namespace glark::stream
