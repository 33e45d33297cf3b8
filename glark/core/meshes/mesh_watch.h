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

class MeshWatch {
 public:
  explicit MeshWatch(const Environment& environment) : env_(environment) {}

  // Notes the draw. `cause`: why it cannot be curved. `fields`: the inputs of its vertex stage; null if they are not
  // known. Returns why it stays unrefined; nothing if it is curved.
  std::optional<Cause> judge(const DrawCall& call, const std::vector<capture::Field>* fields,
                             std::optional<Cause> cause);
  void frame_finished() { table_.frame_finished(); }

 private:
  bool has_normals(const DrawCall& call, const std::vector<capture::Field>& fields) const;
  MeshKey key_of(int position_slot) const;
  std::optional<Cause> ask(const MeshKey& key, const MeshPass& pass, std::optional<Cause> cause);
  int vertex_slot_in_use() const;
  const std::vector<capture::Field>* known_fields() const;

  const Environment& env_;
  MeshTable table_;
};

}  // namespace glark::core
