// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/pass/tree_store.h"

namespace glark::stream {

TreeStore::TreeStore(const common::WorkFolder& work, const std::filesystem::path& temporary, std::size_t cells)
    : file_(work.is_used() ? std::make_unique<TemporaryFile>(KeptFile{work.path("trees")})
                           : std::make_unique<TemporaryFile>(temporary)),
      places_(cells) {}

void TreeStore::put(std::size_t cell, const ClusterTree& tree) {
  const Root root{tree.shape, tree.nodes.front().error};
  std::string bytes(reinterpret_cast<const char*>(&root), sizeof(root));
  bytes.append(reinterpret_cast<const char*>(tree.nodes.data()), tree.nodes.size() * sizeof(ClusterNode));
  places_[cell] = {file_->append(bytes), tree.nodes.size()};
}

TreeStore::Root TreeStore::root(std::size_t cell) const {
  Root root;
  file_->read(places_[cell].offset, {reinterpret_cast<char*>(&root), sizeof(root)});
  return root;
}

void TreeStore::read(std::size_t cell, std::vector<ClusterNode>& nodes) const {
  nodes.resize(static_cast<std::size_t>(places_[cell].nodes));
  file_->read(places_[cell].offset + sizeof(Root),
              {reinterpret_cast<char*>(nodes.data()), nodes.size() * sizeof(ClusterNode)});
}

void TreeStore::save(common::StateWriter& state) const {
  state.put(file_->size());
  state.put_all(std::span<const Place>(places_));
}

bool TreeStore::load(common::StateReader& state) {
  std::uint64_t size = 0;
  std::vector<Place> places;
  if (!state.get(size) || !state.get_all(places) || places.size() != places_.size()) return false;
  file_->continue_at(size);
  places_ = std::move(places);
  return true;
}

}  // namespace glark::stream
