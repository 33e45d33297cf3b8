// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "glark/clients/common/resume/work_folder.h"
#include "glark/clients/stream/files/temporary_file.h"
#include "glark/clients/stream/sample/tree/cluster_tree.h"

namespace glark::stream {

// The trees of all cells, in a file.
class TreeStore {
 public:
  // The file has a name in the work folder, if that is used; else it has none, and lies in `temporary`.
  TreeStore(const common::WorkFolder& work, const std::filesystem::path& temporary, std::size_t cells);
  struct Root {
    Shape shape;  // relative to the cell's centre
    float error = 0;
  };
  void put(std::size_t cell, const ClusterTree& tree);  // several threads may call it
  Root root(std::size_t cell) const;
  void read(std::size_t cell, std::vector<ClusterNode>& nodes) const;
  void save(common::StateWriter& state) const;
  bool load(common::StateReader& state);

 private:
  // Kept for each cell, so it is small. The root stands in the file before the nodes.
  struct Place {
    std::uint64_t offset = 0;
    std::uint64_t nodes = 0;
  };

  std::unique_ptr<TemporaryFile> file_;
  std::vector<Place> places_;
};

}  // namespace glark::stream
