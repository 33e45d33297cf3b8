// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A pass without colours prepares for other draws, its partners: it lays down the depth or the stencil values that they
// meet. If such a pass cannot be curved, its partners must stay flat, too. Usually they are passes over the same mesh.
// Here are the passes whose partners are not known. While there is one, nothing in the context is curved. No GL.
//
// The partners of these passes are known:
// - A mesh that shows in colours, now or in any earlier frame: it meets itself. It may be out of view at present.
// - A lid: its depth hides what lies behind it, as the bottom of a hole does. Draws that compare strictly (GL_LESS)
//   cannot lie on it to the bit, because they would vanish in the picture without glark, too. A lid is drawn beside
//   things that show. So the depths of a shadow map, which is copied or read later, are no lid.
// - A mask: it only marks pixels in the stencil buffer, whatever their depth. Browsers and toolkits fill shapes so. Only
//   draws that use the same stencil buffer can meet it. If none of them is curved, nothing changes where they meet.
// - A few polygons that glBegin..glEnd draw one by one: their colour passes stay as they are, too (mesh_watch.cpp).
#pragma once

#include <cstdint>
#include <vector>

#include "glark/core/meshes/mesh_pass.h"

namespace glark::core {

// Where the passes are that a lid or a mask can meet.
struct MeetingPlace {
  std::uint64_t buffer = 0;  // MeshPass::target of a lid, MeshPass::stencil of a mask; 0: anywhere
  bool mask = false;
  bool operator==(const MeetingPlace&) const = default;
};

// What the passes over one mesh tell about its partners.
struct Preparation {
  std::uint64_t shown = 0;          // the last frame in which a pass wrote colours; 0: none
  std::uint64_t prepared = 0;       // the last frame in which a flat pass prepared for others; 0: none
  MeetingPlace place;               // of the passes that did, if all of them were lids or masks there
  std::uint64_t doubted_until = 0;  // the first frame that does not doubt it; 0: nobody doubts it
};

class UnknownPartners {
 public:
  // Notes any pass over the mesh.
  void draw(const MeshPass& pass, Preparation& mesh);
  // Notes a flat pass that prepares for others. The mesh must live as long as this object does.
  void prepare(const MeshPass& pass, Preparation& mesh);
  // The same for a pass over vertices without identity. Returns false if its partner may be any mesh.
  bool prepare_loose(const MeshPass& pass);
  // glEnd after an open pass. Returns false if it turns out that its partner may be any mesh.
  bool loose_ended(std::uint64_t triangles);
  // The pass must meet another one, and none is there.
  void doubt() { doubted_until_ = frame_ + frames_of_doubt; }
  bool any() const { return frame_ < doubted_until_ || !doubted_.empty(); }
  void frame_finished();

  static constexpr std::uint64_t frames_of_doubt = 300;
  static constexpr unsigned few_lone_polygons = 16;  // in a frame

 private:
  struct Prepared {
    MeetingPlace place;
    bool loose = false;  // a draw without identity
    bool met = false;    // a draw that may be curved meets it
  };
  struct CurvedInStencil {
    std::uint64_t stencil = 0;
    std::uint64_t frame = 0;  // the last one with a draw that may be curved and uses this stencil buffer
  };
  bool is_lid(const MeshPass& pass) const;
  MeetingPlace place_of(const MeshPass& pass) const;
  void note_stencil(std::uint64_t stencil);
  void note_place(const MeetingPlace& place, bool loose);
  bool is_met(const MeetingPlace& place) const;
  bool is_one_of_few();

  std::uint64_t frame_ = 1;
  std::uint64_t doubted_until_ = 0;
  std::uint64_t shown_target_ = 0;  // where this frame has shown something last; 0: nowhere
  unsigned lone_polygons_ = 0;      // that prepared in this frame
  bool open_ = false;               // glEnd will tell whether the last pass was a lone polygon
  std::vector<Prepared> prepared_;  // lids and masks of this frame: one for each place and kind
  std::vector<CurvedInStencil> stencils_;
  std::vector<Preparation*> preparing_;  // in this frame
  std::vector<Preparation*> doubted_;    // they have not shown so far
};

}  // namespace glark::core
