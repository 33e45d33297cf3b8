// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A folder beside an output file, for the work in progress. After a run was killed, the next one may continue from the
// states that were saved here.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "glark/clients/stream/files/state_file.h"

namespace glark::stream {

class WorkFolder {
 public:
  // folder: empty for no folder; nothing is saved then. identity: all that the work depends on. What was saved is only
  // kept if `resume` is true and the identity is the same. Throws Error if the folder cannot be written.
  WorkFolder(std::filesystem::path folder, std::string_view identity, bool resume);
  // Removes the folder if nothing was saved.
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  bool is_used() const { return !folder_.empty(); }
  std::filesystem::path path(const char* name) const { return folder_ / name; }
  // Replaces a state, atomically. Throws Error, for a full disk too.
  void save(const char* name, const std::function<void(StateWriter&)>& write);
  // Calls read(state) if there is a state. Returns whether `read` has found all it needs.
  bool load(const char* name, const std::function<bool(StateReader&)>& read) const;
  // Removes the folder: the work is done.
  void finish();

 private:
  std::filesystem::path folder_;
  bool has_saved_ = false;
};

}  // namespace glark::stream
