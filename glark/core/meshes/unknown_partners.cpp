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
    for (Prepared& lid : prepared_) {
      lid.met = lid.met || lid.place == MeetingPlace{pass.target, false};
    }
  }
  if (pass.marks && (pass.curves || pass.compiles)) {
    note_stencil(pass.stencil);
  }
  if (pass.shows) {
    mesh.shown = frame_;
    shown_target_ = pass.uses_depth ? pass.target : shown_target_;
  }
}

void UnknownPartners::prepare(const MeshPass& pass, Preparation& mesh) {
  const MeetingPlace place = place_of(pass);
  if (place.buffer != 0) {
    note_place(place, false);
  }
  if (mesh.prepared != frame_) {
    mesh.prepared = frame_;
    mesh.place = place;
    preparing_.push_back(&mesh);
  } else if (!(mesh.place == place)) {
    mesh.place = {};
  }
}

bool UnknownPartners::prepare_loose(const MeshPass& pass) {
  if (const MeetingPlace place = place_of(pass); place.buffer != 0) {
    note_place(place, true);
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

MeetingPlace UnknownPartners::place_of(const MeshPass& pass) const {
  const bool mask = pass.marks && !pass.uses_depth && pass.stencil != Framebuffers::unknown_stencil;
  return mask ? MeetingPlace{pass.stencil, true} : is_lid(pass) ? MeetingPlace{pass.target, false} : MeetingPlace{};
}

// A browser's window may end the frame between the draws of a page, so the last frame counts, too.
void UnknownPartners::note_stencil(std::uint64_t stencil) {
  for (Prepared& mask : prepared_) {
    mask.met = mask.met || mask.place == MeetingPlace{stencil, true};
  }
  const auto same = [&](const CurvedInStencil& one) { return one.stencil == stencil; };
  if (const auto found = std::find_if(stencils_.begin(), stencils_.end(), same); found != stencils_.end()) {
    found->frame = frame_;
  } else {
    stencils_.push_back({stencil, frame_});
  }
}

void UnknownPartners::note_place(const MeetingPlace& place, bool loose) {
  const auto same = [&](const Prepared& one) { return one.place == place && one.loose == loose; };
  if (std::none_of(prepared_.begin(), prepared_.end(), same)) {
    const bool met = place.mask && std::any_of(stencils_.begin(), stencils_.end(),
                                               [&](const CurvedInStencil& one) { return one.stencil == place.buffer; });
    prepared_.push_back({place, loose, met});
  }
}

bool UnknownPartners::is_met(const MeetingPlace& place) const {
  return std::any_of(prepared_.begin(), prepared_.end(),
                     [&](const Prepared& one) { return one.place == place && one.met; });
}

void UnknownPartners::frame_finished() {
  for (Preparation* mesh : preparing_) {
    const bool known = mesh->shown != 0 || (mesh->place.buffer != 0 && !is_met(mesh->place));
    if (known) {
      continue;
    }
    if (mesh->doubted_until == 0) {
      doubted_.push_back(mesh);
    }
    mesh->doubted_until = frame_ + frames_of_doubt;
  }
  if (std::any_of(prepared_.begin(), prepared_.end(), [](const Prepared& one) { return one.loose && one.met; })) {
    doubt();
  }
  preparing_.clear();
  prepared_.clear();
  std::erase_if(stencils_, [this](const CurvedInStencil& one) { return one.frame < frame_; });
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
