// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/files/work_folder.h"

#include <glark/stream.h>
#include <sys/stat.h>

#include <string>
#include <utility>

namespace glark::stream {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& problem) { throw Error(Element::file, 0, problem); }

}  // namespace

void require_work(const fs::path& folder, bool resume) {
  if (resume && folder.empty())
    throw Error(Element::option, 0, "glark-stream: resume needs `work`, the folder where the state of the work is");
}

WorkFolder::WorkFolder(fs::path folder, std::string_view identity, bool resume)
    : common::WorkFolder(std::move(folder), identity, resume, fail) {}

void WorkFolder::require_same_disk(const fs::path& file) const {
  struct stat here {};
  struct stat there {};
  const fs::path target = fs::absolute(file).parent_path();
  if (!is_used() || stat(folder().c_str(), &here) != 0 || stat(target.c_str(), &there) != 0) return;
  if (here.st_dev != there.st_dev)
    throw Error(Element::option, 0,
                folder().string() + ": is on another file system than " + file.string() +
                    "; name a folder for the state of the work beside the output");
}

}  // namespace glark::stream
