// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which meshes are curved. A mesh is drawn several times in a frame: for depth, for a shadow map, in colours, as an
// outline. It is curved in all of these passes or in none (one shape), because curved and flat triangles meet neither in
// depth nor in outline. What is not curved stays exactly as the application draws it: interpolated outputs would round
// differently than the passes that nobody can refine. No GL.
//
// - A mesh is curved from the third frame on that draws it, if every pass of the frames before could be curved. Its
//   other passes show themselves in the first frame.
// - A pass that cannot be curved makes its mesh flat at once, and for good, so that nothing flickers.
// - A mesh without identity (glBegin) holds unrelated things: only passes that must meet others make it flat.
// - A pass whose partner is unknown makes all meshes of the context flat for some time. It must meet another draw in
//   depth, and no draw with the same positions is there.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "glark/core/meshes/mesh_key.h"
#include "glark/core/meshes/mesh_pass.h"

namespace glark::core {

enum class MeshVerdict {
  curved,
  waits,            // it has not been drawn in enough frames
  flat,             // a pass over it cannot be curved
  unknown_partner,  // a pass that cannot be curved must meet an unknown mesh
};

class MeshTable {
 public:
  // Notes a pass over the mesh and returns what holds for it. If the pass cannot be curved itself, the verdict is
  // flat or tells about the other passes.
  MeshVerdict draw(const MeshKey& key, const MeshPass& pass);
  // A draw that was to be curved failed.
  void make_flat(const MeshKey& key) { find(key).flat = true; }
  // A frame without draws is not counted.
  void frame_finished();

  static constexpr unsigned frames_to_watch = 2;
  static constexpr std::uint64_t frames_of_doubt = 300;  // after a pass with an unknown partner

 private:
  static constexpr std::uint64_t never = 0;

  struct Mesh {
    std::uint64_t frame = never;     // the last frame that drew it
    std::uint64_t written = never;   // the last frame in which it wrote depth
    std::uint64_t shown = never;     // the last frame in which it wrote colours
    std::uint64_t prepared = never;  // the last frame in which a flat pass prepared for others
    unsigned frames = 0;             // that drew it, up to frames_to_watch + 1
    bool flat = false;
  };

  Mesh& find(const MeshKey& key);
  void note(Mesh& mesh, bool loose, const MeshPass& pass);
  void doubt() { doubted_until_ = frame_ + frames_of_doubt; }
  void drop_old();

  std::unordered_map<MeshKey, Mesh, MeshKeyHash> meshes_;
  MeshKey last_key_;  // of last_, because draws of one mesh often follow each other
  Mesh* last_ = nullptr;
  std::vector<const Mesh*> preparing_;  // meshes that flat passes of this frame prepared for
  std::uint64_t frame_ = 1;
  std::uint64_t doubted_until_ = never;
  bool drawn_ = false;  // in this frame
};

}  // namespace glark::core
