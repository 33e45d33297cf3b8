// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/edit/turned_normals.h"

#include <Eigen/Dense>

namespace glark::stream {
namespace {

using common::Vector3f;

constexpr std::size_t neighbours_of_a_frame = 10;

// A sample, or one near it, before and after the edit.
struct Moved {
  Vector3f before, after;
};

// Turns a normal by the linear map that fits the neighbours of its sample best. Normals turn by its cofactors.
Vector3f turned_normal(const Vector3f& n, const Moved& sample, std::span<const Moved> neighbours) {
  const Eigen::Vector3d normal(n.x, n.y, n.z);
  if (!(normal.norm() > 0)) return n;
  Eigen::Matrix3d before = Eigen::Matrix3d::Zero(), both = Eigen::Matrix3d::Zero();
  for (const Moved& near : neighbours) {
    const Vector3f a = near.before - sample.before, b = near.after - sample.after;
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

// Finds the neighbours of samples, and turns their normals. at(i): where the i-th sample that was found is.
class Turner {
 public:
  template <class At>
  Vector3f turn(const Vector3f& normal, const Moved& sample, std::size_t count, const At& at) {
    bool stays = true;
    for (std::size_t i = 0; i < count; ++i) {
      neighbours_[i] = at(i);
      stays &= neighbours_[i].before == neighbours_[i].after;
    }
    return stays ? normal : turned_normal(normal, sample, std::span(neighbours_).first(count));
  }

 private:
  std::array<Moved, neighbours_of_a_frame> neighbours_{};
};

}  // namespace

void turn_normals(SamplesInMemory& store, const common::Workers& workers) {
  Samples& samples = store.samples();
  const auto moved = [&](std::size_t i) { return Moved{samples.before[i], samples.after[i]}; };
  workers.each(samples.size(), 1024, [&](std::size_t begin, std::size_t end) {
    FoundSamples found;
    Turner turner;
    for (std::size_t i = begin; i < end; ++i) {
      store.nearest(samples.before[i], neighbours_of_a_frame, found);
      samples.normals_after[i] = turner.turn(samples.normals[i], moved(i), found.nearest.size(),
                                             [&](std::size_t k) { return moved(found.nearest[k].index); });
    }
  });
}

void turn_normals(SamplesInCells& store, const common::Workers& workers) {
  store.set_turned_normals(workers, [&](const LoadedCell& cell, FoundSamples& found) {
    std::vector<Vector3f> normals(cell.size());
    Turner turner;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      store.gather(cell.samples.before[i], neighbours_of_a_frame, found);
      normals[i] = turner.turn(cell.samples.normals[i], {cell.samples.before[i], cell.samples.after[i]},
                               found.nearest.size(), [&](std::size_t k) {
                                 return Moved{found.samples.before[k], found.samples.after[k]};
                               });
    }
    return normals;
  });
}

}  // namespace glark::stream
