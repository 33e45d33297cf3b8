// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/work_folder.h"

#include <glark/stream.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace glark::stream {
namespace {

namespace fs = std::filesystem;

constexpr const char* identity_name = "identity";
constexpr std::string_view magic = "glark work 1\n";  // what an identity begins with

[[noreturn]] void fail_in_work(const fs::path& file, int error) {
  throw Error(Element::file, 0,
              file.string() + ": the state of the work cannot be written: " + std::strerror(error) + "; " +
                  (error == ENOSPC || error == EDQUOT ? "make room on the disk, then resume"
                                                      : "use a folder that can be written"));
}

void write_state(const fs::path& file, const std::function<void(StateWriter&)>& write) {
  const fs::path aside = file.string() + ".new";
  const OpenFile stream(std::fopen(aside.c_str(), "wb"));
  if (!stream) fail_in_work(aside, errno);
  StateWriter state(stream.get());
  write(state);
  if (!state.finish() || std::rename(aside.c_str(), file.c_str()) != 0) fail_in_work(file, errno);
}

bool read_state(const fs::path& file, const std::function<bool(StateReader&)>& read) {
  const OpenFile stream(std::fopen(file.c_str(), "rb"));
  if (!stream) return false;
  StateReader state(stream.get());
  return read(state) && state.at_end();
}

}  // namespace

void require_work(const fs::path& folder, bool resume) {
  if (resume && folder.empty())
    throw Error(Element::option, 0, "glark-stream: resume needs `work`, the folder where the state of the work is");
}

WorkFolder::WorkFolder(fs::path folder, std::string_view identity, bool resume) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  std::error_code error;
  if (fs::exists(fs::symlink_status(folder_, error))) require_own();
  const std::string whole = std::string(magic) + std::string(identity);
  if (resume && this->identity() == whole) {
    has_saved_ = true;
    return;
  }
  remove_files();
  if (!fs::create_directories(folder_, error) && error) fail_in_work(folder_, error.value());
  write_state(path(identity_name), [&](StateWriter& state) { state.put_all(std::span(whole)); });
}

// What an earlier run has saved, or an empty text.
std::string WorkFolder::identity() const {
  std::vector<char> saved;
  load(identity_name, [&](StateReader& state) { return state.get_all(saved); });
  return {saved.begin(), saved.end()};
}

// A folder is ours if it is empty, or has our identity. A run that was killed early has only the start of one.
void WorkFolder::require_own() const {
  std::error_code error;
  if (!fs::is_directory(folder_, error))
    throw Error(Element::file, 0, folder_.string() + ": is not a folder; name another one for the state of the work");
  if (identity().starts_with(magic)) return;
  const fs::path begun = path(identity_name).string() + ".new";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
    if (entry.path() != begun)
      throw Error(Element::file, 0,
                  folder_.string() + ": has files that are not of this work, such as " +
                      entry.path().filename().string() +
                      "; they are left as they are: move them, or name another folder");
  if (error) fail_in_work(folder_, error.value());
}

// The identity goes last: until then, an interrupted removal leaves a folder that is known as ours.
void WorkFolder::remove_files() const {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored))
    if (entry.path().filename().string().starts_with("glark-") &&
        entry.symlink_status(ignored).type() == fs::file_type::regular)
      files.push_back(entry.path());
  const fs::path last = path(identity_name);
  for (const fs::path& file : files)
    if (file != last) fs::remove(file, ignored);
  fs::remove(last, ignored);
}

void WorkFolder::require_same_disk(const fs::path& file) const {
  struct stat here {};
  struct stat there {};
  const fs::path target = fs::absolute(file).parent_path();
  if (!is_used() || stat(folder_.c_str(), &here) != 0 || stat(target.c_str(), &there) != 0) return;
  if (here.st_dev != there.st_dev)
    throw Error(Element::option, 0,
                folder_.string() + ": is on another file system than " + file.string() +
                    "; name a folder for the state of the work beside the output");
}

WorkFolder::~WorkFolder() {
  if (!has_saved_) finish();
}

void WorkFolder::save(const char* name, const std::function<void(StateWriter&)>& write) {
  if (!is_used()) return;
  write_state(path(name), write);
  has_saved_ = true;
}

bool WorkFolder::load(const char* name, const std::function<bool(StateReader&)>& read) const {
  return is_used() && read_state(path(name), read);
}

void WorkFolder::finish() {
  if (!is_used()) return;
  remove_files();
  rmdir(folder_.c_str());  // fails if files of others are in it
  folder_.clear();
}

}  // namespace glark::stream
