// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The file of a sampling's cells: samples that lie close together follow one another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "glark/clients/stream/files/temporary_file.h"
#include "glark/clients/stream/samples/sample_index.h"
#include "glark/clients/stream/samples/samples.h"

namespace glark::stream {

struct CellBox {
  common::Vector3f low, high;
};

// A cell in memory: its samples, and a tree to search them.
struct LoadedCell {
  std::vector<std::uint32_t> indices;  // in the sampling
  Samples samples;
  std::unique_ptr<SampleIndex> tree;

  std::size_t size() const { return indices.size(); }
};

// The bytes of a cell in memory with its tree, at most.
std::size_t cell_bytes(std::size_t samples, std::size_t channels);

class SampleCells {
 public:
  // Makes a file without a name in the folder. Throws Error if it cannot.
  SampleCells(const std::filesystem::path& folder, std::size_t channels) : file_(folder), channels_(channels) {}

  std::size_t cells() const { return places_.size(); }
  std::size_t size_of(std::size_t cell) const { return places_[cell].count; }
  std::size_t channels() const { return channels_; }
  const std::vector<CellBox>& boxes() const { return boxes_; }  // of the positions before the edit

  // All may be called by several threads, but append(). Throws Error for a full disk and for one that cannot be read.
  void append(std::span<const std::uint32_t> indices, const Samples& samples);
  std::shared_ptr<const LoadedCell> load(std::size_t cell) const;
  // Replaces the normals after the edit.
  void write_turned_normals(std::size_t cell, std::span<const common::Vector3f> normals);

 private:
  struct Place {
    std::uint64_t offset = 0;
    std::uint32_t count = 0;
  };

  TemporaryFile file_;
  std::size_t channels_;
  std::vector<Place> places_;
  std::vector<CellBox> boxes_;
};

}  // namespace glark::stream
