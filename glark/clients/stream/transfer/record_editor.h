// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Moves the points of some records of a scan, and changes their channels, as the samples near them were edited.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/edit/sampling.h"
#include "glark/clients/stream/samples/near_samples.h"
#include "glark/clients/stream/transfer/output_layout.h"

namespace glark::stream {

struct EditorOptions {
  const TransferOptions& transfer;
  std::size_t memory = 0;  // bytes for the records that are edited at a time
};

class RecordEditor {
 public:
  // from, to: the layouts of the scan and of the output, `file`. All must live as long as the editor.
  RecordEditor(const Sampling& sampling, const Layout& from, const OutputLayout& to, const EditorOptions& options,
               const common::Workers& workers, std::string file);

  // How many records to edit at a time: many, once points that follow each other in the file were found far apart. Among
  // many, each has near ones. The result does not depend on it.
  std::size_t batch_size() const;

  // The points up to now that lie away from all samples.
  std::uint64_t points_away() const { return away_; }

  // Writes the edited records. first: the index of the first one in the file.
  // Throws Error for a position that the numbers of the output cannot hold.
  void edit(std::uint64_t first, std::span<const char> records, std::span<char> edited);

 private:
  void decode_piece(std::span<const char> records, std::size_t begin, std::size_t end);
  void sort_points(std::size_t begin, std::size_t end);
  void edit_points(std::size_t begin, std::size_t end);  // of the order
  void encode_piece(std::uint64_t first, std::span<const char> records, std::size_t begin, std::size_t end,
                    std::span<char> edited) const;
  std::size_t gather(std::span<const std::uint32_t> order, NearSamples& near) const;
  void edit_point(std::size_t i, const NearSamples& near, std::span<const Neighbour> neighbours);
  void interpolate(const Samples& samples, std::span<const Neighbour> near, EditedValue* values) const;
  void write_channels(std::span<const EditedValue> values, std::span<char> records) const;

  const Sampling& sampling_;
  const Layout& from_;
  const OutputLayout& to_;
  const TransferOptions& options_;
  const std::size_t memory_;
  const common::Workers& workers_;
  const std::string file_;
  bool is_shuffled_ = false;
  std::atomic<std::size_t> searches_ = 0;
  std::atomic<std::uint64_t> away_ = 0;

  // The points of the records that are edited.
  std::vector<double> positions_;
  std::vector<float> normals_;           // empty if there are none
  std::vector<common::Vector3f> local_;  // the positions before, relative to the origin of the sampling
  std::vector<EditedValue> values_;      // [channels * points]
  std::vector<std::uint32_t> order_;     // of the points: neighbours follow each other
};

}  // namespace glark::stream
