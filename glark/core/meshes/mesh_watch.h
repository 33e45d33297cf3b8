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
#include "glark/core/state/programs/derived_program.h"

namespace glark::core {

class MeshWatch {
 public:
  explicit MeshWatch(const Environment& environment) : env_(environment) {}

  // Notes the draw. `cause`: why it cannot be curved. Returns why it stays unrefined; nothing if it is curved.
  struct Inputs {
    const std::vector<capture::Field>* fields = nullptr;  // of the vertex stage; null if they are not known
    bool lent_normal = false;                             // the array of the normal is enabled for the capture alone
  };
  std::optional<Cause> judge(const DrawCall& call, const Inputs& inputs, std::optional<Cause> cause);
  // The normals for a draw by the vertex stage with these inputs, which reads none. The attribute is the location of an
  // array, or conventional_normal, or own_normal if there are no normals.
  struct UnreadNormal {
    int attribute = own_normal;
    std::optional<AttributeSource> lent = std::nullopt;  // the capture must enable this array for the attribute
  };
  UnreadNormal unread_normal(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  void frame_finished() { table_.frame_finished(); }

 private:
  int find_array(const NormalSource& wanted, const std::vector<capture::Field>& fields) const;
  UnreadNormal find_lender(const MeshKey& mesh, int position_slot, const std::vector<capture::Field>& fields) const;
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
};

}  // namespace glark::core
