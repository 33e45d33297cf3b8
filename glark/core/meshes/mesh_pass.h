// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The facts about a mesh that one draw shows. No GL.
#pragma once

#include <cstdint>
#include <optional>

#include "glark/core/report/cause.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/framebuffers.h"

namespace glark::core {

struct MeshPass {
  bool curves = false;        // the draw can be curved
  bool made = false;          // its normals are made from positions
  bool compiles = false;      // whether it curves is known when its programs are compiled
  bool lacks_normal = false;  // nothing else keeps it from that; another pass may have the normals
  bool uses_depth = false;    // it tests or writes depth: other passes over the mesh may meet it
  bool writes_depth = false;  // so that later passes may meet it
  bool equal = false;         // it is drawn only where an earlier pass left the same depth
  bool meets_depth = false;   // the picture depends on whether it lies on an earlier pass to the bit
  bool shows = true;          // it writes colours
  bool marks = false;         // it may read or write the stencil buffer
  bool lines = false;         // or points: they lie near a surface, not on it to the bit
  bool behind = false;        // a background: it says nothing about other meshes of its source
  bool lone = false;          // one polygon between glBegin and glEnd, in display lists, too
  bool open = false;          // glEnd will tell whether it is one
  std::uint64_t target = 0;   // the framebuffer, and the size of the viewport; not 0
  std::uint64_t stencil = 0;  // Framebuffers::bound_stencil

  // Without colours, a draw is there only for other draws: it lays down depth or stencil values for them.
  bool prepares() const { return !shows && !lines && (writes_depth || marks); }
  bool must_meet() const { return equal || prepares(); }
};

// glEnd counts the triangles: a draw of so many stays as it is.
constexpr bool is_one_polygon(std::uint64_t triangles) { return triangles > 0 && triangles <= 2; }

struct MeshPassFacts {
  const Bindings& bindings;
  bool depth_buffer = true;     // the framebuffer has one
  bool color_buffer = true;     // the framebuffer has one that is drawn to
  std::uint64_t triangles = 0;  // of the draw, or a bound; 0: not known
  GLuint framebuffer = 0;
  std::uint64_t stencil = Framebuffers::unknown_stencil;
  bool fragment_depth = false;  // the fragment stage computes the depth
};

// `cause`: why the draw cannot be curved; empty if it can. Returns nothing if the draw says nothing about its mesh: it
// draws no picture (selection), or it lies in a user interface.
std::optional<MeshPass> mesh_pass(const MeshPassFacts& facts, std::optional<Cause> cause);

}  // namespace glark::core
