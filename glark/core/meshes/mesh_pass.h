// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What one draw says about its mesh. No GL.
#pragma once

#include <cstdint>
#include <optional>

#include "glark/core/report/cause.h"
#include "glark/core/state/bindings.h"

namespace glark::core {

struct MeshPass {
  bool curves = false;        // the draw can be curved
  bool made = false;          // its normals are made from positions
  bool compiles = false;      // whether it curves is known when its programs are compiled
  bool lacks_normal = false;  // nothing else keeps it from that; another pass may have the normals
  bool uses_depth = false;    // it tests or writes depth: other passes over the mesh may meet it
  bool writes_depth = false;  // so that later passes may meet it
  bool equal = false;         // it is drawn only where an earlier pass left the same depth
  bool shows = true;          // it writes colours
  bool marks = false;         // it may write the stencil buffer
  bool behind = false;        // a background: it says nothing about other meshes of its source

  // Without colours, a draw is there only for other draws: it lays down depth or stencil values for them.
  bool prepares() const { return !shows && (writes_depth || marks); }
  bool must_meet() const { return equal || prepares(); }
};

struct MeshPassFacts {
  const Bindings& bindings;
  bool depth_buffer = true;     // the framebuffer has one
  bool color_buffer = true;     // the framebuffer has one that is drawn to
  std::uint64_t triangles = 0;  // of the draw, or a bound; 0: not known
};

// `cause`: why the draw cannot be curved; empty if it can. Returns nothing if the draw says nothing about its mesh: it
// draws no picture (selection), or it lies in a user interface.
std::optional<MeshPass> mesh_pass(const MeshPassFacts& facts, std::optional<Cause> cause);

}  // namespace glark::core
