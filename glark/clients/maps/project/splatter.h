// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Streams points through the charts: each point goes to the chart of its foot, and to all charts whose guest the triangle
// is.
// Source: Boubekeur 2007, ch. 6.2.3, algorithm 4.
#pragma once

#include <glark/maps.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/maps/project/chart_map.h"
#include "glark/clients/maps/project/shell.h"

namespace glark::maps {

// A point of the stream, as the maps need it.
struct Sample {
  Vector position, normal;  // the normal has unit length, or is zero
  Vector colour;            // 0 to 1
};

// Reads the points of a source, span after span.
class SampleStream {
 public:
  // scale: positions are multiplied by it after the origin is taken off.
  SampleStream(const stream::Source& source, const std::array<double, 3>& origin, double scale, bool skip_invalid);

  bool has_normals() const { return has_normals_; }
  bool has_colours() const { return has_colours_; }
  std::optional<std::uint64_t> count() const { return reader_->count(); }
  std::uint64_t invalid() const { return invalid_; }
  std::uint64_t read_points() const { return read_; }
  // Reads the next points. Returns false at the end.
  bool next(std::size_t most, std::vector<Sample>& samples);
  // Skips points, if the source can do that without reading them.
  bool skip_to(std::uint64_t point);
  // Continues after points that were read before. invalid: of these, as invalid() told then.
  void continue_after(std::uint64_t points, std::uint64_t invalid);

 private:
  std::unique_ptr<stream::PointReader> reader_;
  std::array<double, 3> origin_;
  double scale_;
  bool skip_invalid_, has_normals_ = false, has_colours_ = false;
  std::array<std::size_t, 3> colour_channels_{};
  std::uint64_t invalid_ = 0, read_ = 0;
};

class Splatter {
 public:
  Splatter(const std::vector<Chart>& charts, const Atlas& atlas, const Surface& surface, const Shell& shell,
           unsigned channels);

  // Adds samples to the maps of the charts. Returns the number of samples that have no foot.
  std::size_t add(std::span<const Sample> samples, const common::Workers& workers, std::vector<ChartMap>& maps);

 private:
  // A triangle in a chart that shows it.
  struct Image {
    std::uint32_t chart;
    Triangle2 triangle;
  };
  void sort_by_chart(std::size_t charts);

  const Shell& shell_;
  unsigned channels_;
  std::vector<std::uint32_t> first_image_;
  std::vector<Image> images_;
  std::vector<Foot> feet_;
  std::vector<std::uint32_t> first_entry_;                        // of each chart
  std::vector<std::pair<std::uint32_t, std::uint32_t>> entries_;  // sample and image
};

}  // namespace glark::maps
