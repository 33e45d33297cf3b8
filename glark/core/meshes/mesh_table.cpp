// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/mesh_table.h"

namespace glark::core {
namespace {

constexpr std::size_t many_meshes = 8192;
constexpr std::uint64_t frames_to_keep = 1200;  // of meshes that are no longer drawn

}  // namespace

template <class Drawn>
void MeshTable::count_frame(Drawn& drawn) {
  if (drawn.frame != frame_) {
    drawn.frame = frame_;
    drawn.frames += drawn.frames <= frames_to_watch ? 1 : 0;
  }
}

MeshVerdict MeshTable::draw(const MeshKey& key, const MeshPass& pass) {
  Mesh& mesh = find(key);
  drawn_ = true;
  if (pass.compiles) {
    return delay(key, mesh, pass);
  }
  const bool enough = watched(key, mesh, pass) && !meets_flat_depth(mesh, pass);
  note(mesh, key == loose_mesh, pass);
  const MeshVerdict verdict = mesh.flat         ? MeshVerdict::flat
                              : partners_.any() ? MeshVerdict::unknown_partner
                              : enough          ? MeshVerdict::curved
                                                : MeshVerdict::waits;
  if (verdict == MeshVerdict::curved && pass.curves) {
    mesh.curved = frame_;
    source_for(key).curved = true;
  }
  return verdict;
}

// A browser shows its window while a page is not ready: then this frame's pass meets the depths of the last frame.
bool MeshTable::meets_flat_depth(const Mesh& mesh, const MeshPass& pass) const {
  return pass.equal && mesh.written != frame_ && mesh.curved != mesh.written;
}

// Nobody knows yet whether the pass can be curved. It is there for the passes that must meet it.
MeshVerdict MeshTable::delay(const MeshKey& key, Mesh& mesh, const MeshPass& pass) {
  mesh.first = mesh.first == never ? frame_ : mesh.first;
  mesh.seen = frame_;
  partners_.draw(pass, mesh.preparation);
  if (pass.writes_depth) {
    mesh.written = written_ = frame_;
  }
  compiles(key);
  return MeshVerdict::waits;
}

void MeshTable::compiles(const MeshKey& key) {
  find(key).compiling = frame_;
  source_for(key).compiling = frame_;
}

bool MeshTable::is_curved(const MeshKey& key) {
  return is_recent(find(key).curved) || (!lasts(key) && source_for(key).curved);
}

bool MeshTable::is_nearly_watched(const MeshKey& key) {
  return find(key).frames >= frames_to_watch || (!lasts(key) && source_for(key).frames >= frames_to_watch);
}

// Returns whether enough frames have shown the passes over the mesh, or over others of its source.
bool MeshTable::watched(const MeshKey& key, Mesh& mesh, const MeshPass& pass) {
  Source& source = source_for(key);
  mesh.first = mesh.first == never ? frame_ : mesh.first;
  mesh.seen = frame_;
  bool& had_such = pass.curves ? mesh.had_curved : mesh.had_flat;
  had_such = had_such || !pass.behind;
  if (mesh.had_curved) {
    count_frame(mesh);
  }
  count_frame(source);
  source.mixed = source.mixed || (mesh.had_curved && mesh.had_flat && !(key == loose_mesh));
  if (mesh.frames > frames_to_watch) {
    return !is_recent(mesh.compiling);
  }
  const bool compiles = !source.curved && is_recent(source.compiling);
  return !lasts(key) && !source.mixed && source.frames > frames_to_watch && !compiles;
}

MeshTable::Mesh& MeshTable::find(const MeshKey& key) {
  if (last_ == nullptr || !(last_key_ == key)) {
    last_ = &meshes_[key];
    last_key_ = key;
  }
  return *last_;
}

void MeshTable::note(Mesh& mesh, bool loose, const MeshPass& pass) {
  partners_.draw(pass, mesh.preparation);
  // Nothing has left the depth that the pass must meet.
  if (pass.equal && !is_recent(mesh.written)) {
    partners_.doubt();
  }
  // One of the loose draws is flat, perhaps the very one that the pass must meet.
  mesh.flat = mesh.flat || (pass.equal && mesh.written_flat == frame_ && loose);
  if (pass.writes_depth) {
    mesh.written = written_ = frame_;
    const bool as_others = pass.curves && !(pass.made && loose);
    mesh.written_flat = as_others ? mesh.written_flat : frame_;
  }
  if (pass.curves) {
    mesh.flat = mesh.flat || (!pass.made && !loose && mesh.made == frame_ && mesh.frames > 1);
    mesh.made = pass.made ? frame_ : mesh.made;
    return;
  }
  const bool excused = pass.lacks_normal && !loose && mesh.frames <= 1;
  if (excused && mesh.first == frame_) {
    return;
  }
  if (loose) {
    const bool known = pass.prepares() && partners_.prepare_loose(pass);
    mesh.flat = mesh.flat || (pass.must_meet() && !known);
    return;
  }
  mesh.flat = mesh.flat || (!excused && (pass.must_meet() || pass.uses_depth));
  if (pass.prepares()) {
    partners_.prepare(pass, mesh.preparation);
  }
}

void MeshTable::loose_ended(std::uint64_t triangles) {
  if (!partners_.loose_ended(triangles)) {
    find(loose_mesh).flat = true;
  }
}

void MeshTable::frame_finished() {
  if (!drawn_) {
    return;
  }
  drawn_ = false;
  partners_.frame_finished();
  ++frame_;
  if (meshes_.size() > many_meshes) {
    drop_old();
  }
}

void MeshTable::drop_old() {
  last_ = nullptr;
  std::erase_if(meshes_, [this](const auto& entry) { return entry.second.seen + frames_to_keep < frame_; });
}

}  // namespace glark::core
