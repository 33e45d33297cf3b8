// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What readers without seek() share: an input in order, and the arrays of the points that were just read.
#pragma once

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/stream/read/readers.h"

namespace glark::stream {

class StreamReader : public PointReader {
 public:
  StreamReader(geometry::Input input, std::string element, const ReadOptions& options)
      : input_(std::move(input)), element_(std::move(element)), options_(options) {}

  const std::string& name() const final { return input_.name(); }
  const Schema& schema() const final { return schema_; }
  bool can_seek() const final { return false; }
  void seek(std::uint64_t) final {
    throw Error(Element::file, 0,
                name() + ": text, pipes and compressed files are read in order only; convert the file to binary PLY");
  }

 protected:
  // Adds a point. channels: all that the file has.
  void add(const double* position, const float* normal, std::span<const double> channels) {
    arrays_.positions.insert(arrays_.positions.end(), position, position + 3);
    if (schema_.normals) arrays_.normals.insert(arrays_.normals.end(), normal, normal + 3);
    if (options_.channels) arrays_.channels.insert(arrays_.channels.end(), channels.begin(), channels.end());
  }
  void clear() {
    arrays_.positions.clear();
    arrays_.normals.clear();
    arrays_.channels.clear();
  }
  // Returns the points in the arrays, and counts them.
  Points finish_block() {
    const Points points = arrays_.points(next_);
    next_ += points.size();
    if (!options_.keep_invalid) require_finite(points, name(), element_);
    return points;
  }
  // Calls `step` and turns errors of geometry's readers into Error.
  template <class Step>
  auto reading(const Step& step) {
    try {
      return step();
    } catch (const geometry::Error& error) {
      throw Error(Element::file, 0, error.what());
    }
  }

  geometry::Input input_;
  std::string element_;
  ReadOptions options_;
  Schema schema_;
  std::uint64_t next_ = 0;
  PointArrays arrays_;
};

}  // namespace glark::stream
