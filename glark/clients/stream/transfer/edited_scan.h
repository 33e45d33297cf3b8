// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A scan and the edit of its sampling: all that a transfer needs before it reads the first record.
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <string>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/files/source_file.h"
#include "glark/clients/stream/transfer/record_editor.h"
#include "glark/clients/stream/transfer/transfer_memory.h"

namespace glark::stream {

struct TransferFiles {
  std::filesystem::path large;                             // the scan
  std::filesystem::path from, to;                          // its sampling, before and after the edit
  std::filesystem::path output;                            // in the format of the scan
  std::filesystem::path temporary = output.parent_path();  // a folder for the cells of a sampling that is too large
};

// The bounding box of edited points, which a LAS header stores.
struct EditedBox {
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void add(const OutputLayout& layout, std::span<const char> records, std::size_t count);
};

class EditedScan {
 public:
  // Throws Error for options out of range, files that cannot be read or do not fit together, and an output that is one of
  // the other files or has another ending.
  EditedScan(const TransferFiles& files, const TransferOptions& options);

  const SourceFile& file() const { return file_; }
  std::uint64_t records() const { return layout_.records; }
  // The byte of the scan where its records end. All after it, such as triangles, is copied.
  std::uint64_t rest() const { return layout_.begin + layout_.size(); }
  OutputLayout& output() { return output_; }
  // Throws Error if the scan was changed since the beginning.
  void require_unchanged() const { file_.require_unchanged(before_); }
  // All that the edited records depend on, as text.
  std::string identity() const;
  TransferReport report() const;
  // Of the records that were edited so far; report() has it, too.
  std::uint64_t points_away() const { return editor_.points_away(); }

  // Reads some records, from `first` to `end` at most, and edits them. A record does not depend on the others that are
  // edited with it. The result is valid until the next call. Throws Error for a scan that ends early, or coordinates
  // that do not fit into its numbers.
  struct Edited {
    std::span<const char> records;  // those of the output
    std::size_t count = 0;
  };
  Edited edit(std::uint64_t first, std::uint64_t end);

 private:
  TransferFiles files_;
  TransferOptions options_;
  common::Workers workers_;
  SourceFile file_;
  FileState before_;
  std::string format_;
  Layout layout_;  // of the scan
  TransferMemory memory_;
  Sampling sampling_;
  OutputLayout output_;
  RecordEditor editor_;
  std::vector<char> records_, edited_;
};

}  // namespace glark::stream
