// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A sampling before and after its editing, and the neighbours of a point in it.
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::stream {

struct Sampling {
  std::array<double, 3> origin{};               // positions are relative to it
  std::vector<common::Vector3f> before, after;  // positions
  std::vector<common::Vector3f> normals, normals_after;
  std::vector<Channel> channels;  // those of the edited sampling that are new or have other values
  std::vector<float> values;      // [channels * samples]
  bool is_deformed = false;

  std::size_t size() const { return before.size(); }
};

// Reads both files. The samples of `to` correspond by their order, or by a channel "index". Normals before are those of
// `from`, or estimated. Normals after are turned as the neighbours of each sample are.
// Throws Error if the numbers of samples differ, or if an index is out of range or repeated.
Sampling read_sampling(const std::filesystem::path& from, const std::filesystem::path& to, unsigned threads);

// A sample near a point, and its weight.
struct Neighbour {
  std::uint32_t index = 0;
  float distance = 0;
  float weight = 0;
};

// The nearest samples. Several threads may ask.
class Neighbours {
 public:
  Neighbours(const Sampling& sampling, unsigned count, bool is_singular);
  ~Neighbours();
  // Finds the nearest samples, the nearest one first, with the weights of the kernel.
  void find(const common::Vector3f& point, std::vector<Neighbour>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
  std::size_t count_;
  bool is_singular_;
};

}  // namespace glark::stream
