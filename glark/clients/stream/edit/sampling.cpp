// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/sampling.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "glark/clients/stream/files/with_vstree.h"
#include "glark/clients/stream/format/layout.h"

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t neighbours_of_a_frame = 10;
constexpr std::size_t tried_samples = 2000, least_tried = 100;  // whether neighbours are strangers after an edit
constexpr float near_samples = 0.03F, far_samples = 0.1F;       // relative to the diagonal of all

struct FileContents {
  std::vector<double> positions, channels;
  std::vector<float> normals;
  Schema schema;
};

void require_within_floats(const std::vector<double>& positions, const std::string& file) {
  const auto beyond =
      std::find_if(positions.begin(), positions.end(), [](double at) { return !(std::abs(at) <= largest_coordinate); });
  if (beyond == positions.end()) return;
  const auto point = static_cast<std::size_t>(beyond - positions.begin()) / 3;
  throw Error(Element::point, point,
              fmt::format("{}: point {} has the coordinate {}; finite ones up to 1e18 are possible: move it, or undo "
                          "this edit",
                          file, point, *beyond));
}

// Throws Error for a file that cannot be read, or for coordinates with which floats cannot compute.
FileContents read_file(const std::filesystem::path& file) {
  const std::unique_ptr<PointReader> reader = open_points(file);
  FileContents all;
  all.schema = reader->schema();
  for (Points points = reader->read(); points.size() > 0; points = reader->read()) {
    all.positions.insert(all.positions.end(), points.positions.begin(), points.positions.end());
    all.normals.insert(all.normals.end(), points.normals.begin(), points.normals.end());
    all.channels.insert(all.channels.end(), points.channels.begin(), points.channels.end());
  }
  require_within_floats(all.positions, file.string());
  return all;
}

// For each sample, its place in the edited file.
std::vector<std::size_t> places_of(const FileContents& to, const std::string& file, std::size_t count) {
  std::vector<std::size_t> places(count, none);
  const std::size_t index = channel_index(to.schema, "index"), width = to.schema.channels.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double sample = index == none ? static_cast<double>(i) : to.channels[width * i + index];
    if (!(sample >= 0 && sample < static_cast<double>(count)) || places[static_cast<std::size_t>(sample)] != none)
      throw Error(Element::point, i,
                  fmt::format("{}: vertex {} has the index {}, which is repeated or not below {}; export it with the "
                              "indices of the sampling",
                              file, i, sample, count));
    places[static_cast<std::size_t>(sample)] = i;
  }
  return places;
}

// For each sample, whether a channel has another value than in `from`. Nothing if no sample has.
std::vector<std::uint8_t> edited_samples(const FileContents& from, const FileContents& to, std::size_t channel,
                                         const std::vector<std::size_t>& places) {
  const std::size_t old = channel_index(from.schema, to.schema.channels[channel].name);
  std::vector<std::uint8_t> edited(places.size(), 1);
  if (old == none) return edited;
  const std::size_t width = to.schema.channels.size(), old_width = from.schema.channels.size();
  bool is_edited = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    edited[i] = to.channels[width * places[i] + channel] != from.channels[old_width * i + old] ? 1 : 0;
    is_edited |= edited[i] != 0;
  }
  return is_edited ? edited : std::vector<std::uint8_t>();
}

// Turns each normal by the linear map that fits the neighbours of its sample best. Normals turn by its cofactors.
Vector3f turned_normal(const Samples& samples, std::size_t i, const std::vector<std::uint32_t>& neighbours) {
  const Vector3f n = samples.normals[i];
  const Eigen::Vector3d normal(n.x, n.y, n.z);
  if (!(normal.norm() > 0)) return n;
  Eigen::Matrix3d before = Eigen::Matrix3d::Zero(), both = Eigen::Matrix3d::Zero();
  for (const std::uint32_t k : neighbours) {
    const Vector3f a = samples.before[k] - samples.before[i], b = samples.after[k] - samples.after[i];
    const Eigen::Vector3d from(a.x, a.y, a.z), to(b.x, b.y, b.z);
    before += from * from.transpose();
    both += to * from.transpose();
  }
  // The neighbours say little about the map across the surface. The cross product does not need it.
  const double extent = before.trace();
  const Eigen::Matrix3d map = both * (before + 1e-6 * (extent + 1e-30) * Eigen::Matrix3d::Identity()).inverse();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::Vector3d turned = (map * u).cross(map * v);
  if (!(turned.norm() > 0)) return n;
  turned.normalize();
  return {static_cast<float>(turned[0]), static_cast<float>(turned[1]), static_cast<float>(turned[2])};
}

float diagonal_of(const std::vector<Vector3f>& positions) {
  Vector3f low = positions[0], high = low;
  for (const Vector3f& p : positions) {
    low = common::least(low, p);
    high = common::greatest(high, p);
  }
  return common::length(high - low);
}

// Throws Error if most samples that were neighbours are strangers: a program has written them in another order. An edit
// tears the sampling here and there, not everywhere.
void require_same_order(const Samples& samples, const SampleIndex& index, const std::string& file) {
  const float near = near_samples * diagonal_of(samples.before), far = far_samples * diagonal_of(samples.after);
  const std::size_t step = samples.size() / tried_samples + 1;
  std::size_t neighbours = 0, strangers = 0;
  std::vector<std::uint32_t> two;  // a sample and the one nearest to it
  std::vector<float> squares;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    index.nearest(samples.before[i], 2, two, squares);
    if (!(squares.back() < near * near)) continue;
    ++neighbours;
    strangers += common::length(samples.after[two.front()] - samples.after[two.back()]) > far ? 1 : 0;
  }
  if (neighbours < least_tried || 2 * strangers <= neighbours) return;
  throw Error(Element::file, 0,
              fmt::format("{}: its points have another order than those of the sampling: {} of {} that were neighbours "
                          "lie far apart; export it with the property \"index\" of the sampling, or without sorting",
                          file, strangers, neighbours));
}

void turn_normals(Samples& samples, const SampleIndex& index, const common::Workers& workers) {
  workers.each(samples.size(), 1024, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> neighbours;
    std::vector<float> squares;
    for (std::size_t i = begin; i < end; ++i) {
      index.nearest(samples.before[i], neighbours_of_a_frame, neighbours, squares);
      const bool stays = std::all_of(neighbours.begin(), neighbours.end(),
                                     [&](std::uint32_t k) { return samples.before[k] == samples.after[k]; });
      if (!stays) samples.normals_after[i] = turned_normal(samples, i, neighbours);
    }
  });
}

// Normals that the file lacks are estimated.
std::vector<float> normals_of(const FileContents& before, const Samples& samples, const std::string& file,
                              const common::Workers& workers) {
  if (!before.normals.empty()) return before.normals;
  std::vector<float> positions;
  for (const Vector3f& p : samples.before) positions.insert(positions.end(), {p.x, p.y, p.z});
  const vstree::NormalOptions options{.threads = static_cast<unsigned>(workers.count())};
  return with_vstree(file, [&] { return vstree::estimate_normals({.positions = positions}, options); });
}

}  // namespace

Sampling read_sampling(const std::filesystem::path& from, const std::filesystem::path& to,
                       const common::Workers& workers) {
  const FileContents before = read_file(from), after = read_file(to);
  const std::size_t count = before.positions.size() / 3;
  if (count == 0) throw Error(Element::file, 0, from.string() + ": the sampling has no points; sample the scan again");
  if (after.positions.size() != before.positions.size())
    throw Error(Element::file, 0,
                fmt::format("{}: has {} points, the sampling {} has {}; edit without adding or removing points",
                            to.string(), after.positions.size() / 3, from.string(), count));
  Sampling sampling;
  Samples& samples = sampling.samples;
  for (std::size_t k = 0; k < 3; ++k) sampling.origin[k] = before.positions[k];
  const std::vector<std::size_t> places = places_of(after, to.string(), count);
  const auto relative = [&](const std::vector<double>& all, std::size_t i) {
    return Vector3f{static_cast<float>(all[3 * i] - sampling.origin[0]),
                    static_cast<float>(all[3 * i + 1] - sampling.origin[1]),
                    static_cast<float>(all[3 * i + 2] - sampling.origin[2])};
  };
  const std::size_t width = after.schema.channels.size();
  std::vector<std::size_t> edited;  // channels; the others keep the values of the scan
  std::vector<std::vector<std::uint8_t>> where;
  for (std::size_t k = 0; k < width; ++k) {
    if (after.schema.channels[k].name == "index") continue;
    std::vector<std::uint8_t> there = edited_samples(before, after, k, places);
    if (there.empty()) continue;
    edited.push_back(k);
    where.push_back(std::move(there));
  }
  for (const std::size_t k : edited) sampling.channels.push_back(after.schema.channels[k]);
  for (std::size_t i = 0; i < count; ++i) {
    samples.before.push_back(relative(before.positions, i));
    samples.after.push_back(relative(after.positions, places[i]));
    sampling.is_deformed |= !(samples.before.back() == samples.after.back());
    for (std::size_t k = 0; k < edited.size(); ++k) {
      samples.values.push_back(static_cast<float>(after.channels[width * places[i] + edited[k]]));
      samples.is_edited.push_back(where[k][i]);
    }
  }
  const std::vector<float> normals = normals_of(before, samples, from.string(), workers);
  for (std::size_t i = 0; i < count; ++i)
    samples.normals.push_back(common::unit(common::vector_at(std::span<const float>(normals), i)));
  samples.normals_after = samples.normals;
  if (!sampling.is_deformed) return sampling;
  const SampleIndex index(samples.before);
  if (channel_index(after.schema, "index") == none) require_same_order(samples, index, to.string());
  turn_normals(samples, index, workers);
  return sampling;
}

}  // namespace glark::stream
