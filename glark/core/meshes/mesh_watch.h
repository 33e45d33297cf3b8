// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds the mesh of each draw, and asks the table whether it is curved (--refine smooth).
#pragma once

#include <optional>
#include <vector>

#include "glark/core/capture/draw_call.h"
#include "glark/core/capture/record.h"
#include "glark/core/meshes/mesh_table.h"
#include "glark/core/report/cause.h"
#include "glark/core/state/environment.h"

namespace glark::core {

// Returns whether the user wants normals from positions, and the position allows them.
bool may_make_normals(const ContextOptions& options, const std::vector<capture::Field>& fields);

class MeshWatch {
 public:
  explicit MeshWatch(const Environment& environment) : env_(environment) {}

  // Notes the draw. `cause`: why it cannot be curved. `fields`: the inputs of its vertex stage; null if they are not
  // known. Returns why it stays unrefined; nothing if it is curved.
  std::optional<Cause> judge(const DrawCall& call, const std::vector<capture::Field>* fields,
                             std::optional<Cause> cause);
  // Chooses the normals of a draw by the vertex stage with these inputs: DerivedKey::normal_attribute.
  int choose_normal(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  // Passes over the mesh of this draw, or other draws, wrote depth in this or the last frame.
  bool mesh_wrote_depth(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  bool any_wrote_depth() const { return table_.any_wrote_depth(); }
  void frame_finished() { table_.frame_finished(); }

 private:
  // The stage reads no normal: returns the location of an array that holds the normals of its mesh,
  // conventional_normal, or own_normal if there is none.
  int unread_normal(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  bool makes_normals(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  MeshKey mesh_of_draw(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  int find_array(const NormalSource& wanted, const std::vector<capture::Field>& fields) const;
  void note_normals(const MeshKey& mesh, const std::vector<capture::Field>& fields);
  bool has_normals(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  MeshKey key_of(int position_slot) const;
  std::optional<Cause> ask(const MeshKey& key, const MeshPass& pass, std::optional<Cause> cause);
  int vertex_slot_in_use() const;
  const std::vector<capture::Field>* known_fields() const;

  const Environment& env_;
  mutable MeshTable table_;
};

}  // namespace glark::core
