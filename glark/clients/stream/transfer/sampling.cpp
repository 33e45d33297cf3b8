// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/transfer/sampling.h"

#include <fmt/format.h>
#include <glark/vstree.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t neighbours_of_a_frame = 10;

struct Cloud {
  const std::vector<Vector3f>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t>;

struct FileContents {
  std::vector<double> positions, channels;
  std::vector<float> normals;
  Schema schema;
};

FileContents read_file(const std::filesystem::path& file) {
  const std::unique_ptr<PointReader> reader = open_points(file);
  FileContents all;
  all.schema = reader->schema();
  for (Points points = reader->read(); points.size() > 0; points = reader->read()) {
    all.positions.insert(all.positions.end(), points.positions.begin(), points.positions.end());
    all.normals.insert(all.normals.end(), points.normals.begin(), points.normals.end());
    all.channels.insert(all.channels.end(), points.channels.begin(), points.channels.end());
  }
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

// Whether the samples of `from` have the channel with the same values.
bool is_unchanged(const FileContents& from, const FileContents& to, std::size_t channel,
                  const std::vector<std::size_t>& places) {
  const std::size_t old = channel_index(from.schema, to.schema.channels[channel].name);
  if (old == none) return false;
  const std::size_t width = to.schema.channels.size(), old_width = from.schema.channels.size();
  for (std::size_t i = 0; i < places.size(); ++i)
    if (to.channels[width * places[i] + channel] != from.channels[old_width * i + old]) return false;
  return true;
}

// Turns each normal by the linear map that fits the neighbours of its sample best. Normals turn by its cofactors.
void turn_normals(Sampling& sampling, const Index& index) {
  std::array<std::uint32_t, neighbours_of_a_frame> found{};
  std::array<float, neighbours_of_a_frame> squares{};
  for (std::size_t i = 0; i < sampling.size(); ++i) {
    const Vector3f p = sampling.before[i];
    const std::array<float, 3> query{p.x, p.y, p.z};
    const std::size_t count = index.knnSearch(query.data(), found.size(), found.data(), squares.data());
    const Vector3f n = sampling.normals[i];
    const Eigen::Vector3d normal(n.x, n.y, n.z);
    Eigen::Matrix3d before = Eigen::Matrix3d::Zero(), both = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < count; ++k) {
      const Vector3f a = sampling.before[found[k]] - p, b = sampling.after[found[k]] - sampling.after[i];
      const Eigen::Vector3d from(a.x, a.y, a.z), to(b.x, b.y, b.z);
      before += from * from.transpose();
      both += to * from.transpose();
    }
    // The neighbours say little about the map across the surface: there it is taken to be a rotation of the normal.
    const double extent = before.trace();
    const Eigen::Matrix3d map = both * (before + 1e-6 * (extent + 1e-30) * Eigen::Matrix3d::Identity()).inverse();
    const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    Eigen::Vector3d turned = (map * u).cross(map * v);
    if (!(turned.norm() > 0)) turned = normal;
    turned.normalize();
    sampling.normals_after[i] = {static_cast<float>(turned[0]), static_cast<float>(turned[1]),
                                 static_cast<float>(turned[2])};
  }
}

}  // namespace

Sampling read_sampling(const std::filesystem::path& from, const std::filesystem::path& to, unsigned threads) {
  const FileContents before = read_file(from), after = read_file(to);
  const std::size_t count = before.positions.size() / 3;
  if (count == 0) throw Error(Element::file, 0, from.string() + ": the sampling has no points; sample the scan again");
  if (after.positions.size() != before.positions.size())
    throw Error(Element::file, 0,
                fmt::format("{}: has {} points, the sampling {} has {}; edit without adding or removing points",
                            to.string(), after.positions.size() / 3, from.string(), count));
  Sampling sampling;
  for (std::size_t k = 0; k < 3; ++k) sampling.origin[k] = before.positions[k];
  const std::vector<std::size_t> places = places_of(after, to.string(), count);
  const auto relative = [&](const std::vector<double>& all, std::size_t i) {
    return Vector3f{static_cast<float>(all[3 * i] - sampling.origin[0]),
                    static_cast<float>(all[3 * i + 1] - sampling.origin[1]),
                    static_cast<float>(all[3 * i + 2] - sampling.origin[2])};
  };
  const std::size_t width = after.schema.channels.size();
  std::vector<std::size_t> edited;  // channels; the others keep the values of the scan
  for (std::size_t k = 0; k < width; ++k)
    if (after.schema.channels[k].name != "index" && !is_unchanged(before, after, k, places)) edited.push_back(k);
  for (const std::size_t k : edited) sampling.channels.push_back(after.schema.channels[k]);
  for (std::size_t i = 0; i < count; ++i) {
    sampling.before.push_back(relative(before.positions, i));
    sampling.after.push_back(relative(after.positions, places[i]));
    sampling.is_deformed |= !(sampling.before.back() == sampling.after.back());
    for (const std::size_t k : edited)
      sampling.values.push_back(static_cast<float>(after.channels[width * places[i] + k]));
  }
  std::vector<float> normals = before.normals;
  if (normals.empty()) {
    std::vector<float> positions;
    for (const Vector3f& p : sampling.before) positions.insert(positions.end(), {p.x, p.y, p.z});
    normals = vstree::estimate_normals({.positions = positions}, {.threads = threads});
  }
  for (std::size_t i = 0; i < count; ++i)
    sampling.normals.push_back(common::unit(common::vector_at(std::span<const float>(normals), i)));
  sampling.normals_after = sampling.normals;
  if (sampling.is_deformed) {
    const Cloud cloud{sampling.before};
    const Index index(3, cloud);
    turn_normals(sampling, index);
  }
  return sampling;
}

struct Neighbours::Tree {
  explicit Tree(const Sampling& sampling) : cloud{sampling.before}, index(3, cloud) {}
  Cloud cloud;
  Index index;
};

Neighbours::Neighbours(const Sampling& sampling, unsigned count, bool is_singular)
    : tree_(std::make_unique<Tree>(sampling)),
      count_(std::min<std::size_t>(count, sampling.size())),
      is_singular_(is_singular) {}
Neighbours::~Neighbours() = default;

// The kernel is Hermite's polynomial of the distance relative to that of the farthest neighbour.
// Source: Boubekeur 2007, ch. 4.4.1, with max in the place of arg max.
void Neighbours::find(const Vector3f& point, std::vector<Neighbour>& found) const {
  constexpr std::size_t most = 64;
  std::array<std::uint32_t, most> indices{};
  std::array<float, most> squares{};
  const std::array<float, 3> query{point.x, point.y, point.z};
  const std::size_t count =
      tree_->index.knnSearch(query.data(), std::min(count_, most), indices.data(), squares.data());
  found.resize(count);
  const float farthest = count > 0 ? std::sqrt(squares[count - 1]) : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float distance = std::sqrt(squares[i]), t = farthest > 0 ? distance / farthest : 0;
    float weight = 1 - 3 * t * t + 2 * t * t * t;
    if (is_singular_) weight /= t * t + 1e-6F;
    found[i] = {indices[i], distance, weight};
  }
  if (count > 0 && !(found[0].weight > 0)) found[0].weight = 1;  // all are equally far, or there is one only
}

}  // namespace glark::stream
