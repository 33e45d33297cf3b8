// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/resume/work_folder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace glark::common {
namespace {

namespace fs = std::filesystem;

constexpr const char* identity_name = "identity";
constexpr std::string_view magic = "glark work 1\n";  // what an identity begins with
constexpr const char* inner_ending = ".work";

bool read_state(const fs::path& file, const std::function<bool(StateReader&)>& read) {
  const OpenFile stream(std::fopen(file.c_str(), "rb"));
  if (!stream) return false;
  StateReader state(stream.get());
  return read(state) && state.at_end();
}

// The identity that an earlier run has saved, or an empty text.
std::string identity_in(const fs::path& folder) {
  std::vector<char> saved;
  read_state(WorkFolder::path_in(folder, identity_name), [&](StateReader& state) { return state.get_all(saved); });
  return {saved.begin(), saved.end()};
}

bool is_inner(const fs::path& name) { return name.string().starts_with("glark-") && name.extension() == inner_ending; }

std::vector<fs::path> inner_folders(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (is_inner(entry.path().filename()) && entry.symlink_status(ignored).type() == fs::file_type::directory)
      folders.push_back(entry.path());
  return folders;
}

void remove_files_in(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with("glark-") &&
        entry.symlink_status(ignored).type() == fs::file_type::regular)
      files.push_back(entry.path());
  const fs::path last = WorkFolder::path_in(folder, identity_name);
  for (const fs::path& file : files)
    if (file != last) fs::remove(file, ignored);
  fs::remove(last, ignored);
}

// Takes the first line off a text.
std::string_view first_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

}  // namespace

void require_same_work(const fs::path& folder, std::string_view identity, WorkFolder::Fail fail) {
  const std::string saved = identity_in(folder);
  if (!saved.starts_with(magic) || saved.substr(magic.size()) == identity) return;
  std::string_view before = std::string_view(saved).substr(magic.size());
  std::string_view line, line_before;
  while (line == line_before && !(identity.empty() && before.empty())) {
    line = first_line(identity);
    line_before = first_line(before);
  }
  fail(folder.string() + ": is the work of a run that differs: it has \"" + std::string(line_before) +
       "\", and this run \"" + std::string(line) +
       "\"; resume with the same files and options, or start without resume");
}

WorkFolder::WorkFolder(fs::path folder, std::string_view identity, bool resume, Fail fail)
    : folder_(std::move(folder)), fail_(fail) {
  if (folder_.empty()) return;
  std::error_code error;
  if (fs::exists(fs::symlink_status(folder_, error))) require_own();
  const std::string whole = std::string(magic) + std::string(identity);
  if (resume && this->identity() == whole) {
    has_saved_ = true;
    return;
  }
  remove_files();
  if (!fs::create_directories(folder_, error) && error) fail_in(folder_, error.value());
  write_state(path(identity_name), [&](StateWriter& state) { state.put_all(std::span(whole)); });
}

void WorkFolder::fail_in(const fs::path& file, int error) const {
  fail_(
      file.string() + ": the state of the work cannot be written: " + std::strerror(error) + "; " +
      (error == ENOSPC || error == EDQUOT ? "make room on the disk, then resume" : "use a folder that can be written"));
  std::abort();  // fail_ throws
}

void WorkFolder::write_state(const fs::path& file, const std::function<void(StateWriter&)>& write) const {
  const fs::path aside = file.string() + ".new";
  const OpenFile stream(std::fopen(aside.c_str(), "wb"));
  if (!stream) fail_in(aside, errno);
  StateWriter state(stream.get());
  write(state);
  if (!state.finish() || std::rename(aside.c_str(), file.c_str()) != 0) fail_in(file, errno);
}

std::string WorkFolder::identity() const { return identity_in(folder_); }

// A folder is ours if it is empty, or has our identity. A run that was killed early has only the start of one.
void WorkFolder::require_own() const {
  std::error_code error;
  if (!fs::is_directory(folder_, error))
    fail_(folder_.string() + ": is not a folder; name another one for the state of the work");
  if (identity().starts_with(magic)) return;
  const fs::path begun = path(identity_name).string() + ".new";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
    if (entry.path() != begun)
      fail_(folder_.string() + ": has files that are not of this work, such as " + entry.path().filename().string() +
            "; they are left as they are: move them, or name another folder");
  if (error) fail_in(folder_, error.value());
}

// The identity goes last: until then, an interrupted removal leaves a folder that is known as ours.
void WorkFolder::remove_files() const {
  for (const fs::path& inner : inner_folders(folder_)) {
    remove_files_in(inner);
    rmdir(inner.c_str());
  }
  remove_files_in(folder_);
}

WorkFolder::~WorkFolder() {
  if (!has_saved_ && inner_folders(folder_).empty()) finish();
}

fs::path WorkFolder::inner(const std::string& name) const { return is_used() ? path(name + inner_ending) : fs::path(); }

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

}  // namespace glark::common
