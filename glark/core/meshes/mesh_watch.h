// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds the mesh of each draw, and asks the table whether it is curved (--refine smooth).
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "glark/core/capture/draw_call.h"
#include "glark/core/capture/record.h"
#include "glark/core/meshes/mesh_table.h"
#include "glark/core/meshes/overlays.h"
#include "glark/core/report/cause.h"
#include "glark/core/state/environment.h"
#include "glark/core/state/programs/derived_program.h"

namespace glark::core {

// Returns whether the user wants normals from positions, and the position allows them.
bool may_make_normals(const ContextOptions& options, const std::vector<capture::Field>& fields);

class MeshWatch {
 public:
  explicit MeshWatch(const Environment& environment) : env_(environment) {}

  struct Inputs {
    const std::vector<capture::Field>* fields = nullptr;  // of the vertex stage; null if they are not known
    bool lent_normal = false;                             // the array of the normal is enabled for the capture alone
  };
  // Notes the draw. `cause`: why it cannot be curved. Returns why it stays unrefined; nothing if it is curved.
  std::optional<Cause> judge(const DrawCall& call, const Inputs& inputs, std::optional<Cause> cause);
  // glEnd, after a draw that was judged when its triangles were not counted yet, and stayed unrefined.
  void loose_ended(std::uint64_t triangles) { table_.loose_ended(triangles); }
  // The normals of a draw by the vertex stage with these inputs.
  struct ChosenNormal {
    int attribute = own_normal;                          // DerivedKey::normal_attribute
    std::optional<AttributeSource> lent = std::nullopt;  // the capture must enable this array for the attribute
  };
  ChosenNormal choose_normal(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  // Passes over the mesh of this draw, or other draws, wrote depth in this or the last frame.
  bool mesh_wrote_depth(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  bool any_wrote_depth() const { return table_.any_wrote_depth(); }
  // Returns whether passes over the mesh of this draw are curved in this or the last frame.
  bool is_curved(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  // Returns whether the mesh may be curved in the next frame, so that its programs are needed.
  bool is_nearly_watched(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  // Programs of the draw are not compiled yet: its mesh waits.
  void compiles(const DrawCall& call, const std::vector<capture::Field>& fields);
  void frame_finished() { table_.frame_finished(); }

 private:
  std::optional<Cause> judge_loose(const MeshPass& pass, std::optional<Cause> cause);  // from glBegin..glEnd
  std::optional<Cause> judge_arrays(const Inputs& inputs, MeshPass pass, std::optional<Cause> cause);
  bool computes_depth(const DrawCall& call) const;
  void note_overlay(const DrawCall& call, const MeshPass& pass);
  bool is_moved_by_offsets(const DrawCall& call, const Inputs& inputs);
  bool places_vertices_itself() const;
  void note_overlay_array(int slot);
  bool is_overlaid(const MeshKey& mesh, int position_slot);
  // The stage reads no normal: finds an array that holds the normals of its mesh, or the normals of its list.
  ChosenNormal unread_normal(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  bool makes_normals(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  MeshKey mesh_of_draw(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  int find_array(const NormalSource& wanted, const std::vector<capture::Field>& fields) const;
  ChosenNormal find_lender(const MeshKey& mesh, int position_slot, const std::vector<capture::Field>& fields) const;
  int free_location(const std::vector<capture::Field>& fields) const;
  void note_normals(const MeshKey& mesh, int position_slot, const std::vector<capture::Field>& fields);
  bool has_normals(const DrawCall& call, const Inputs& inputs) const;
  int slot_in_use(int position_slot) const;
  MeshKey key_of(int position_slot) const;
  std::optional<Cause> ask(const MeshKey& key, const MeshPass& pass, std::optional<Cause> cause);
  int vertex_slot_in_use() const;
  const std::vector<capture::Field>* known_fields() const;

  const Environment& env_;
  mutable MeshTable table_;
  Overlays overlays_;
  std::unordered_map<MeshKey, bool, MeshKeyHash> moves_by_offsets_;  // by the array of the normals
};

}  // namespace glark::core
