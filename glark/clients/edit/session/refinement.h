// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// New samples of the scan, and the files that keep them, so that a replay does not read the scan again.
#pragma once

#include "glark/clients/edit/session/folder.h"
#include "glark/clients/edit/session/names.h"
#include "glark/clients/edit/session/points_file.h"

namespace glark::edit {

// Takes the samples that line `line` of the log asks for, and keeps them. A sample that lies in two balls comes once.
// Throws stream::Error.
Refined take_samples(const Folder& folder, const std::filesystem::path& scan, std::span<const Refine> balls,
                     std::size_t line, const Editor& editor, const SessionOptions& options);
// Reads what take_samples() kept. Throws Error if the files are not there.
Refined kept_samples(const Folder& folder, std::size_t line);

// Two files of the folder: the sampling before the edit, and after it. The destructor removes them.
class EditFiles {
 public:
  EditFiles(const Folder& folder, const Editor& editor);
  ~EditFiles();
  EditFiles(const EditFiles&) = delete;
  EditFiles& operator=(const EditFiles&) = delete;

  const std::filesystem::path& before() const { return before_; }
  const std::filesystem::path& after() const { return after_; }

 private:
  std::filesystem::path before_, after_;
};

}  // namespace glark::edit
