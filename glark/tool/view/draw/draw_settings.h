// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How the viewer draws its models.
#pragma once

#include <array>
#include <optional>

#include "glark/tool/view/draw/camera.h"

namespace glark::tool {

// `patterns` draws what `refined` draws, in the colours of the refinement patterns.
enum class Mode { splat, strip, mesh, wireframe, refined, patterns };

// What is shown of a model with maps: its mesh as `Mode` says, the mesh with colours and normal map, or that displaced.
// Each shows more than the one before.
enum class MapsShown { plain, normal, displaced };

// How triangles are refined. Without normals, all are flat.
enum class Refinement { pn, phong, linear };

inline constexpr int deepest_level = 4;
inline constexpr int deepest_measured_level = 6;  // of displaced edges

inline constexpr std::array<float, 3> colour_without_texture{0.78F, 0.76F, 0.72F};

// The light stays with the viewer. Angles are in degrees: to the right and above the line of sight.
struct Look {
  float light_right = 16.7F;
  float light_above = 25.6F;
  float ambient = 0.2F;    // of white light from everywhere, 0 to 1
  float specular = 0.15F;  // 0 to 1
  float shininess = 30;    // 1 to 128
};

struct DrawSettings {
  Mode mode = Mode::mesh;
  MapsShown maps = MapsShown::plain;
  bool cull = true;
  bool lines = false;  // refined triangles are drawn as lines
  Refinement refinement = Refinement::pn;
  int level = 2;        // of refinement, 0 to deepest_level
  int edge_pixels = 0;  // 0: `level`; else edges get segments of at most so many pixels
  int budget = 0;       // the most refined triangles of a frame with edge_pixels; 0: no limit
  Look look;
  std::optional<Camera> culled_from;  // strips are culled for this camera; empty: for the one that draws
};

// The part of the window that shows a model, in pixels.
struct Part {
  int x = 0;
  int width = 1;
  int height = 1;
};

}  // namespace glark::tool
