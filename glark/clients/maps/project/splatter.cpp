// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/splatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glark::maps {
namespace {

// The value of a colour that is white.
double white_of(stream::Number type) {
  switch (type) {
    case stream::Number::uint16: return 65535;
    case stream::Number::float32:
    case stream::Number::float64: return 1;
    default: return 255;
  }
}

}  // namespace

SampleStream::SampleStream(const stream::Source& source, const std::array<double, 3>& origin, double scale,
                           bool skip_invalid)
    : reader_(source.open({.format = {}, .normals = true, .channels = true, .keep_invalid = true})),
      origin_(origin),
      scale_(scale),
      skip_invalid_(skip_invalid),
      has_normals_(reader_->schema().normals) {
  const char* names[] = {"red", "green", "blue"};
  has_colours_ = true;
  for (std::size_t k = 0; k < 3; ++k) {
    colour_channels_[k] = stream::channel_index(reader_->schema(), names[k]);
    has_colours_ = has_colours_ && colour_channels_[k] != stream::none;
  }
}

bool SampleStream::skip_to(std::uint64_t point) {
  if (!reader_->can_seek()) return false;
  reader_->seek(point);
  return true;
}

void SampleStream::continue_after(std::uint64_t points, std::uint64_t invalid) {
  constexpr std::uint64_t step = 1 << 16;
  if (!skip_to(points))
    for (std::uint64_t left = points; left > 0;) {
      const std::size_t count = reader_->read(static_cast<std::size_t>(std::min(step, left))).size();
      if (count == 0) break;
      left -= count;
    }
  read_ = points;
  invalid_ = invalid;
}

bool SampleStream::next(std::size_t most, std::vector<Sample>& samples) {
  samples.clear();
  const stream::Points points = reader_->read(most);
  const std::size_t count = points.size();
  if (count == 0) return false;
  samples.reserve(count);
  const std::size_t channels = reader_->schema().channels.size();
  const double white = has_colours_ ? white_of(reader_->schema().channels[colour_channels_[0]].type) : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double* p = points.positions.data() + 3 * i;
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
      if (!skip_invalid_)
        throw Error(Element::point, points.first + i,
                    fmt::format("of {} has a coordinate that is not finite; set the option skip_invalid to leave such "
                                "points out",
                                reader_->name()));
      ++invalid_;
      continue;
    }
    Sample& sample = samples.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) sample.position[k] = static_cast<float>((p[k] - origin_[k]) * scale_);
    if (has_normals_)
      sample.normal = common::unit(Vector{points.normals[3 * i], points.normals[3 * i + 1], points.normals[3 * i + 2]});
    if (has_colours_)
      for (std::size_t k = 0; k < 3; ++k)
        sample.colour[k] = static_cast<float>(points.channels[channels * i + colour_channels_[k]] / white);
  }
  read_ += count;
  return true;
}

Splatter::Splatter(const std::vector<Chart>& charts, const Atlas& atlas, const Surface& surface, const Shell& shell,
                   unsigned channels)
    : shell_(shell), channels_(channels), first_image_(surface.triangles.size() + 1) {
  const auto visit = [&](const auto& add) {
    for (std::uint32_t c = 0; c < charts.size(); ++c) {
      for (const std::uint32_t t : charts[c].triangles)
        if (!charts[c].is_own || Triangle2{surface.texcoords[t]}.doubled_area() != 0) add(c, t);
      for (const std::uint32_t t : charts[c].guests) add(c, t);
    }
  };
  visit([&](std::uint32_t, std::uint32_t t) { ++first_image_[t + 1]; });
  std::partial_sum(first_image_.begin(), first_image_.end(), first_image_.begin());
  images_.resize(first_image_.back());
  std::vector<std::uint32_t> next(first_image_.begin(), first_image_.end() - 1);
  visit([&](std::uint32_t c, std::uint32_t t) {
    images_[next[t]++] = {c, triangle_in(charts[c], atlas.places[c], surface, t)};
  });
}

void Splatter::sort_by_chart(std::size_t charts) {
  first_entry_.assign(charts + 1, 0);
  const auto visit = [&](const auto& add) {
    for (std::uint32_t i = 0; i < feet_.size(); ++i) {
      const std::uint32_t t = feet_[i].triangle;
      if (t == none) continue;
      for (std::uint32_t image = first_image_[t]; image < first_image_[t + 1]; ++image) add(i, image);
    }
  };
  visit([&](std::uint32_t, std::uint32_t image) { ++first_entry_[images_[image].chart + 1]; });
  std::partial_sum(first_entry_.begin(), first_entry_.end(), first_entry_.begin());
  entries_.resize(first_entry_.back());
  std::vector<std::uint32_t> next(first_entry_.begin(), first_entry_.end() - 1);
  visit([&](std::uint32_t i, std::uint32_t image) { entries_[next[images_[image].chart]++] = {i, image}; });
}

std::size_t Splatter::add(std::span<const Sample> samples, const common::Workers& workers,
                          std::vector<ChartMap>& maps) {
  constexpr std::size_t samples_a_piece = 1024;
  feet_.assign(samples.size(), {});
  workers.each(samples.size(), samples_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (const auto foot = shell_.foot_of(samples[i].position, samples[i].normal)) feet_[i] = *foot;
  });
  sort_by_chart(maps.size());
  // Each chart adds its samples in the order of the stream. So the sums are the same for any number of threads.
  workers.each(maps.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      maps[c].is_changed |= first_entry_[c] != first_entry_[c + 1];
      for (std::uint32_t e = first_entry_[c]; e < first_entry_[c + 1]; ++e) {
        const auto& [i, image] = entries_[e];
        const Point2 at = images_[image].triangle.at(feet_[i].weights);
        const bool is_near = at[0] >= 0 && at[1] >= 0 && at[0] <= static_cast<float>(maps[c].width) &&
                             at[1] <= static_cast<float>(maps[c].height);
        if (!is_near) continue;  // most of a guest lies beyond the gutter
        const std::array<float, channels_with_colour> values{
            samples[i].normal.x, samples[i].normal.y, samples[i].normal.z, feet_[i].height,
            samples[i].colour.x, samples[i].colour.y, samples[i].colour.z};
        maps[c].add(at, std::span(values).first(channels_));
      }
    }
  });
  std::size_t without = 0;
  for (const Foot& foot : feet_) without += foot.triangle == none ? 1 : 0;
  return without;
}

}  // namespace glark::maps
