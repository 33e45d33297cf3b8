// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A folder beside an output file, for the work in progress. After a run was killed, the next one may continue from the
// states that were saved here.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "glark/clients/stream/files/state_file.h"

namespace glark::stream {

// Throws Error for `resume` without a folder.
void require_work(const std::filesystem::path& folder, bool resume);

class WorkFolder {
 public:
  // folder: empty for no folder; nothing is saved then. identity: all that the work depends on. What was saved is only
  // kept if `resume` is true and the identity is the same. Throws Error if the folder cannot be written, if it is a file,
  // or if somebody else's files are in it.
  WorkFolder(std::filesystem::path folder, std::string_view identity, bool resume);
  // Removes what is here if nothing was saved.
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  bool is_used() const { return !folder_.empty(); }
  // A file of this folder. All that begin with glark- are ours, and are removed with it.
  std::filesystem::path path(const std::string& name) const { return path_in(folder_, name); }
  static std::filesystem::path path_in(const std::filesystem::path& folder, const std::string& name) {
    return folder / ("glark-" + name);
  }
  // Replaces a state, atomically. Throws Error, for a full disk too.
  void save(const char* name, const std::function<void(StateWriter&)>& write);
  // Calls read(state) if there is a state. Returns whether `read` has found all it needs.
  bool load(const char* name, const std::function<bool(StateReader&)>& read) const;
  // Throws Error if the file would be on another file system than this folder: it could not be put in its place.
  void require_same_disk(const std::filesystem::path& file) const;
  // Removes our files, and the folder if no others are in it: the work is done.
  void finish();

 private:
  std::string identity() const;
  void require_own() const;
  void remove_files() const;

  std::filesystem::path folder_;
  bool has_saved_ = false;
};

}  // namespace glark::stream
