// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The folder of a session. Its file "session" tells that the folder is ours, and of which scan.
#pragma once

#include <filesystem>
#include <string>

namespace glark::edit {

class Folder {
 public:
  // Makes the folder, or opens the one of a session, and locks it. Throws Error for a folder with other files, for
  // another scan, for a scan that has changed, and if another program uses the session.
  Folder(std::filesystem::path folder, const std::filesystem::path& scan);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  // Throws Error if the scan is not the one of the session any more.
  void require_same_scan(const std::filesystem::path& scan) const;
  // Throws Error if the file lies in this folder.
  void require_outside(const std::filesystem::path& file) const;
  // Brings a file of the folder, and its name, onto the disk. Throws Error.
  void keep(const std::string& name) const;

 private:
  void make(const std::string& identity);
  // Returns false if the program was killed before the file was complete.
  bool check(const std::string& identity, const std::filesystem::path& scan) const;
  void lock();

  std::filesystem::path folder_;
  int lock_ = -1;
};

}  // namespace glark::edit
