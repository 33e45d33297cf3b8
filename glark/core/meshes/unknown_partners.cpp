// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/unknown_partners.h"

#include <algorithm>

namespace glark::core {

void UnknownPartners::draw(const MeshPass& pass, Preparation& mesh) {
  if (open_) {  // nobody has told how the pass before ended
    open_ = false;
    doubt();
  }
  if (pass.meets_depth) {
    for (Lid& lid : lids_) {
      lid.met = lid.met || lid.target == pass.target;
    }
  }
  if (pass.shows) {
    mesh.shown = frame_;
    shown_target_ = pass.uses_depth ? pass.target : shown_target_;
  }
}

void UnknownPartners::prepare(const MeshPass& pass, Preparation& mesh) {
  const bool lid = is_lid(pass);
  if (lid) {
    note_lid(pass.target, false);
  }
  if (mesh.prepared != frame_) {
    mesh.prepared = frame_;
    mesh.lid = lid ? pass.target : 0;
    preparing_.push_back(&mesh);
  } else if (!lid || mesh.lid != pass.target) {
    mesh.lid = 0;
  }
}

bool UnknownPartners::prepare_loose(const MeshPass& pass) {
  if (is_lid(pass)) {
    note_lid(pass.target, true);
    return true;
  }
  const bool may_be_lone = (pass.lone || pass.open) && !pass.marks && !pass.equal;
  open_ = may_be_lone && !pass.lone;
  if (open_ || (may_be_lone && is_one_of_few())) {
    return true;
  }
  doubt();
  return false;
}

bool UnknownPartners::loose_ended(std::uint64_t triangles) {
  if (!open_) {
    return true;
  }
  open_ = false;
  if (triangles == 0 || (is_one_polygon(triangles) && is_one_of_few())) {
    return true;
  }
  doubt();
  return false;
}

bool UnknownPartners::is_one_of_few() { return ++lone_polygons_ <= few_lone_polygons; }

bool UnknownPartners::is_lid(const MeshPass& pass) const {
  return pass.writes_depth && !pass.marks && !pass.meets_depth && shown_target_ != 0 && pass.target == shown_target_;
}

void UnknownPartners::note_lid(std::uint64_t target, bool loose) {
  const auto same = [&](const Lid& lid) { return lid.target == target && lid.loose == loose; };
  if (std::none_of(lids_.begin(), lids_.end(), same)) {
    lids_.push_back({target, loose});
  }
}

bool UnknownPartners::is_met(std::uint64_t target) const {
  return std::any_of(lids_.begin(), lids_.end(), [&](const Lid& lid) { return lid.target == target && lid.met; });
}

void UnknownPartners::frame_finished() {
  for (Preparation* mesh : preparing_) {
    const bool known = mesh->shown != 0 || (mesh->lid != 0 && !is_met(mesh->lid));
    if (known) {
      continue;
    }
    if (mesh->doubted_until == 0) {
      doubted_.push_back(mesh);
    }
    mesh->doubted_until = frame_ + frames_of_doubt;
  }
  if (std::any_of(lids_.begin(), lids_.end(), [](const Lid& lid) { return lid.loose && lid.met; })) {
    doubt();
  }
  preparing_.clear();
  lids_.clear();
  shown_target_ = 0;
  lone_polygons_ = 0;
  ++frame_;
  std::erase_if(doubted_, [this](Preparation* mesh) {
    const bool doubted = mesh->shown == 0 && frame_ < mesh->doubted_until;
    mesh->doubted_until = doubted ? mesh->doubted_until : 0;
    return !doubted;
  });
}

}  // namespace glark::core
