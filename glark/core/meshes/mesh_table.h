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
// - Programs that compile their lists or allocate their arrays again in every frame would wait for ever. A new mesh of
//   such a source is curved at once if the source was drawn in enough frames and never had a mesh with both curved and
//   flat passes.
// - A pass that cannot be curved makes its mesh flat at once, and for good, so that nothing flickers. A pass that lacks
//   normals is excused until the end of the frame in which another pass over the mesh has some: it then borrows these.
//   Only the frames from that one on count. So is a pass whose normals were made from positions, if a later pass has
//   other ones.
// - A mesh without identity (glBegin) holds unrelated things: only passes that must meet others make it flat.
// - A pass whose partner is unknown makes all meshes of the context flat for some time (unknown_partners.h). It must meet
//   another draw in depth, and no draw with the same positions is there.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "glark/core/meshes/lent_normals.h"
#include "glark/core/meshes/mesh_key.h"
#include "glark/core/meshes/mesh_pass.h"
#include "glark/core/meshes/unknown_partners.h"

namespace glark::core {

enum class MeshVerdict {
  curved,
  waits,            // it has not been drawn in enough frames
  flat,             // a pass over it cannot be curved
  unknown_partner,  // a pass that cannot be curved must meet an unknown mesh
};

// The array with the normals of a mesh.
struct NormalSource {
  MeshKey key;
  GLenum type = 0;
  bool normalized = false;
  bool operator==(const NormalSource&) const = default;
};

class MeshTable {
 public:
  // Notes a pass over the mesh and returns what holds for it. If the pass cannot be curved itself, the verdict is
  // flat or tells about the other passes.
  MeshVerdict draw(const MeshKey& key, const MeshPass& pass);
  // Something that cannot be curved lies on the mesh.
  void keep_flat(const MeshKey& key) { find(key).flat = true; }
  // glEnd of a pass without identity that said it was open.
  void loose_ended(std::uint64_t triangles);
  // The normals that a pass over the mesh reads. Other passes may use them, too.
  void set_normals(const MeshKey& key, const NormalSource& normals) { find(key).normals = normals; }
  const NormalSource& normals(const MeshKey& key) { return find(key).normals; }  // of no key: not known
  NormalsBeside& normals_beside(const MeshKey& key) { return find(key).beside; }
  bool shown(const MeshKey& key) { return is_recent(find(key).preparation.shown); }  // in this or the last frame
  // Returns whether a pass over the mesh wrote depth in this or the last frame; and whether any draw did. In the first
  // frame, draws are expected to write depth.
  bool wrote_depth(const MeshKey& key) { return is_recent(find(key).written); }
  bool any_wrote_depth() const { return frame_ == 1 || is_recent(written_); }
  // Passes over the mesh are curved in this or the last frame, or over other meshes of its source if it is a new one.
  bool is_curved(const MeshKey& key);
  // The mesh may be curved in the next frame.
  bool is_nearly_watched(const MeshKey& key);
  // A pass over the mesh cannot be curved in this frame, because its programs are not compiled yet. The mesh waits in
  // this frame and in the next one.
  void compiles(const MeshKey& key);
  // A frame without draws is not counted.
  void frame_finished();

  static constexpr unsigned frames_to_watch = 2;

 private:
  static constexpr std::uint64_t never = 0;

  struct Mesh {
    std::uint64_t first = never;         // the first frame that drew it
    std::uint64_t seen = never;          // the last frame that drew it
    std::uint64_t frame = never;         // the last frame that counts in `frames`
    std::uint64_t written = never;       // the last frame in which it wrote depth
    std::uint64_t written_flat = never;  // the last frame in which a flat pass wrote depth
    std::uint64_t curved = never;        // the last frame in which passes were curved
    std::uint64_t compiling = never;     // the last frame in which programs of a pass were not compiled
    std::uint64_t made = never;          // the last frame in which a pass had normals from positions
    unsigned frames = 0;                 // that drew it since it has normals, up to frames_to_watch + 1
    bool flat = false;
    bool had_curved = false;  // passes
    bool had_flat = false;
    NormalSource normals;
    NormalsBeside beside;
    Preparation preparation;
  };
  struct Source {
    std::uint64_t frame = never;      // the last frame that drew from it
    unsigned frames = 0;              // up to frames_to_watch + 1
    std::uint64_t compiling = never;  // the last frame in which programs for one of its meshes were not compiled
    bool curved = false;              // one of its meshes was
    bool mixed = false;               // one of its meshes had both curved and flat passes
  };

  Mesh& find(const MeshKey& key);
  void note(Mesh& mesh, bool loose, const MeshPass& pass);
  template <class Drawn>
  void count_frame(Drawn& drawn);
  static bool lasts(const MeshKey& key) { return source_of(key) == MeshSource::buffer || key == loose_mesh; }
  Source& source_for(const MeshKey& key) { return sources_[static_cast<std::size_t>(source_of(key))]; }
  bool meets_flat_depth(const Mesh& mesh, const MeshPass& pass) const;
  MeshVerdict delay(const MeshKey& key, Mesh& mesh, const MeshPass& pass);
  bool watched(const MeshKey& key, Mesh& mesh, const MeshPass& pass);
  bool is_recent(std::uint64_t frame) const { return frame != never && frame + 1 >= frame_; }
  void drop_old();

  std::unordered_map<MeshKey, Mesh, MeshKeyHash> meshes_;
  std::array<Source, 3> sources_;  // by MeshSource
  MeshKey last_key_;               // of last_, because draws of one mesh often follow each other
  Mesh* last_ = nullptr;
  UnknownPartners partners_;
  std::uint64_t frame_ = 1;
  std::uint64_t written_ = never;  // the last frame in which a draw wrote depth
  bool drawn_ = false;             // in this frame
};

}  // namespace glark::core
