// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The changes that can be undone and done again. They lie in a file without a name, so that their number is only limited
// by the disk. It disappears with the program.
#pragma once

#include <glark/edit.h>

#include <filesystem>
#include <span>
#include <vector>

#include "glark/clients/common/nameless_file.h"

namespace glark::edit {

class History {
 public:
  // Throws Error if no file can be made in the folder; empty: the system's folder for temporary files.
  explicit History(const std::filesystem::path& folder);

  std::size_t undo_count() const { return done_; }
  std::size_t redo_count() const { return records_.size() - done_; }

  // Adds a change that was done. Forgets those that were undone. Throws Error if the disk is full; nothing changes then.
  void add(std::span<const char> change);
  // The last change that was done, or the first one that was undone. There must be one.
  std::vector<char> last_done() const;
  std::vector<char> first_undone() const;
  // Moves the border between done and undone by one change, and replaces that change by one of the same size.
  void undo(std::span<const char> change);
  void redo(std::span<const char> change);

 private:
  struct Record {
    std::uint64_t begin, size;
  };
  std::vector<char> read(const Record& record) const;
  void write(const Record& record, std::span<const char> bytes);

  std::filesystem::path folder_;
  common::NamelessFile file_;
  std::vector<Record> records_;
  std::size_t done_ = 0;
};

}  // namespace glark::edit
