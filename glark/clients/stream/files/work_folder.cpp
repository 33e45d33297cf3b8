// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/work_folder.h"

#include <glark/stream.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace glark::stream {
namespace {

namespace fs = std::filesystem;

constexpr const char* identity_name = "identity";

[[noreturn]] void fail_in_work(const fs::path& file, int error) {
  throw Error(Element::file, 0,
              file.string() + ": the state of the work cannot be written: " + std::strerror(error) + "; " +
                  (error == ENOSPC || error == EDQUOT ? "make room on the disk, then continue with --resume"
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

WorkFolder::WorkFolder(fs::path folder, std::string_view identity, bool resume) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  std::error_code error;
  const bool is_same = resume && load(identity_name, [&](StateReader& state) {
                         std::vector<char> saved;
                         return state.get_all(saved) && std::string_view(saved.data(), saved.size()) == identity;
                       });
  if (is_same) {
    has_saved_ = true;
    return;
  }
  fs::remove_all(folder_, error);
  if (!fs::create_directories(folder_, error) && error) fail_in_work(folder_, error.value());
  write_state(path(identity_name), [&](StateWriter& state) { state.put_all(std::span(identity)); });
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
  std::error_code ignored;
  if (is_used()) fs::remove_all(folder_, ignored);
  folder_.clear();
}

}  // namespace glark::stream
