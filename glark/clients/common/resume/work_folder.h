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

#include "glark/clients/common/resume/state_file.h"

namespace glark::common {

class WorkFolder {
 public:
  // Throws the library's error for a file. problem: names the file, and says what to do.
  using Fail = void (*)(const std::string& problem);

  // folder: empty for no folder; nothing is saved then. identity: all that the work depends on. What was saved is only
  // kept if `resume` is true and the identity is the same. Fails if the folder cannot be written, if it is a file, or if
  // somebody else's files are in it.
  WorkFolder(std::filesystem::path folder, std::string_view identity, bool resume, Fail fail);
  // Removes what is here if nothing was saved, here or in an inner folder.
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  bool is_used() const { return !folder_.empty(); }
  // A file of this folder. All that begin with glark- are ours, and are removed with it.
  std::filesystem::path path(const std::string& name) const { return path_in(folder_, name); }
  static std::filesystem::path path_in(const std::filesystem::path& folder, const std::string& name) {
    return folder / ("glark-" + name);
  }
  // A folder in this one, for the work of another library. It is removed with this one. Empty for no folder.
  std::filesystem::path inner(const std::string& name) const;
  // Replaces a state, atomically. Fails if it cannot, for a full disk too.
  void save(const char* name, const std::function<void(StateWriter&)>& write);
  // Other processes have saved states here: they stay, as those of this one.
  void keep() { has_saved_ = true; }
  // Calls read(state) if there is a state. Returns whether `read` has found all it needs.
  bool load(const char* name, const std::function<bool(StateReader&)>& read) const;
  // Fails with the message for a file of this folder that cannot be written. error: an errno.
  [[noreturn]] void fail_in(const std::filesystem::path& file, int error) const;
  // Removes our files, and the folder if no others are in it: the work is done.
  void finish();

 protected:
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::string identity() const;
  void require_own() const;
  void remove_files() const;
  void write_state(const std::filesystem::path& file, const std::function<void(StateWriter&)>& write) const;

  std::filesystem::path folder_;
  Fail fail_;
  bool has_saved_ = false;
};

// Fails if `folder` has the work of another identity: where the texts differ, the message has the two lines. A folder that
// does not exist, or is empty, may be used for any work.
void require_same_work(const std::filesystem::path& folder, std::string_view identity, WorkFolder::Fail fail);

}  // namespace glark::common
