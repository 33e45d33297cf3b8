// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The records of an edited scan: those of the scan, with further channels where the edit has some.
#pragma once

#include <optional>

#include "glark/clients/stream/format/las_header.h"
#include "glark/clients/stream/format/layout.h"

namespace glark::stream {

// A channel that is written: its column in the sampling, and its field in the records.
struct WrittenChannel {
  std::size_t column = 0;
  Field field;
  double scale = 1;  // from the numbers of the sampling to those of the file
};

class OutputLayout {
 public:
  // Throws Error for a channel that the format cannot hold.
  OutputLayout(const SourceFile& file, const Layout& from, const std::string& format,
               const std::vector<Channel>& channels);

  const Layout& layout() const { return layout_; }
  const std::vector<WrittenChannel>& channels() const { return channels_; }
  std::string_view header() const { return header_; }
  bool has_box() const { return las_.has_value(); }
  // The header with the bounding box of the new positions, for formats that have one.
  std::string final_header(const std::array<double, 3>& low, const std::array<double, 3>& high);

 private:
  void add(const SourceFile& file, const std::string& format, const Channel& channel, std::size_t column);
  void add_property(const Channel& channel);

  Layout layout_;
  std::string header_;
  std::vector<WrittenChannel> channels_;
  std::optional<LasHeader> las_;
};

}  // namespace glark::stream
