// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/pass/tree_store.h"

namespace glark::stream {

TreeStore::TreeStore(const WorkFolder& work, const std::filesystem::path& temporary, std::size_t cells)
    : file_(work.is_used() ? std::make_unique<TemporaryFile>(work.path(""), "trees")
                           : std::make_unique<TemporaryFile>(temporary)),
      places_(cells) {}

void TreeStore::put(std::size_t cell, const ClusterTree& tree) {
  Place& place = places_[cell];
  place.nodes = static_cast<std::uint32_t>(tree.nodes.size());
  place.shape = tree.shape;
  place.root = tree.nodes.front();
  place.offset =
      file_->append({reinterpret_cast<const char*>(tree.nodes.data()), tree.nodes.size() * sizeof(ClusterNode)});
}

void TreeStore::read(std::size_t cell, std::vector<ClusterNode>& nodes) const {
  nodes.resize(places_[cell].nodes);
  file_->read(places_[cell].offset, {reinterpret_cast<char*>(nodes.data()), nodes.size() * sizeof(ClusterNode)});
}

void TreeStore::save(StateWriter& state) const {
  state.put(file_->size());
  state.put_all(std::span<const Place>(places_));
}

bool TreeStore::load(StateReader& state) {
  std::uint64_t size = 0;
  std::vector<Place> places;
  if (!state.get(size) || !state.get_all(places) || places.size() != places_.size()) return false;
  file_->continue_at(size);
  places_ = std::move(places);
  return true;
}

}  // namespace glark::stream
