// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <memory>

namespace glark::stream {

// The files of a sampling: the scan, the samples, and their index.
class SampleFiles {
 public:
  // Throws Error for a scan that can be read only once, and for outputs that are the scan or cannot be written.
  SampleFiles(std::filesystem::path large, std::filesystem::path small, SampleFormats formats);

  Source source() const { return file_source(large_, formats_.large); }
  std::filesystem::path folder() const { return small_.parent_path(); }
  std::unique_ptr<PointWriter> create(const Schema& schema) const;
  // The samples are in their place.
  void write_index(const SampleReport& report) const;

 private:
  std::filesystem::path large_, small_, index_;
  SampleFormats formats_;
};

}  // namespace glark::stream
